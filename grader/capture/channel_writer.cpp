#include "capture/channel_writer.hpp"

#include "capture/tape/writer.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <set>
#include <string>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ggrade::capture {
namespace {

using channel::Header;
using channel::Message;
using channel::Plan;

thread_local std::uint32_t messagePass = trace::kNone;

[[noreturn]] void refuse(const char* reason) {
  std::fprintf(stderr, "ggrade capture: %s: %s\n", channel::kDescriptorVariable, reason);
  _exit(channel::kRefusedExit);
}

const char* faultOf(const trace::Request& request) {
  for (const std::uint32_t flag : {request.passes, request.stepCopies}) {
    if (flag > 1) return "a switch of what to record is neither 0 nor 1";
  }
  if (request.times > std::uint32_t(trace::Times::processor)) return "there is no such clock";
  for (const std::uint32_t mask :
       {request.copies, request.windowCopies, request.renderbufferCopies}) {
    if (mask > trace::kAllAttachments) return "attachments to copy out of range";
  }
  if (request.copyFrames > channel::kMaxFrames) return "frames to copy out of range";
  if (request.copyBytes > channel::kMaxCopyBytes) return "room for copies out of range";
  if (request.tapeFrames > channel::kMaxFrames) return "frames to tape out of range";
  if (request.tapeBytes > channel::kMaxTapeBytes) return "room for a tape out of range";
  return nullptr;
}

const char* faultOfReplacements(const Plan& plan) {
  if (plan.replacementCount > channel::kMaxReplacements ||
      (plan.replacementCount > 0 && !plan.trace.passes))
    return "number of replacements out of range";
  if (plan.replacementBytes > channel::kMaxReplacementBytes)
    return "room for replacements out of range";
  for (std::uint32_t i = 0; i < plan.replacementCount; ++i) {
    const channel::Replacement& one = plan.replacements[i];
    const bool depth = one.attachment == trace::kDepth;
    const auto type = static_cast<trace::PixelType>(one.type);
    if (!depth && one.attachment >= trace::kColors) return "attachment to replace out of range";
    if (depth != (type == trace::PixelType::f32x1) || type == trace::PixelType::u8x1)
      return "type of a replacement out of range";
    if (one.width > channel::kMaxSide || one.height > channel::kMaxSide || one.bytes == 0 ||
        one.bytes != trace::bytesPerPixel(type) * one.width * one.height)
      return "size of a replacement out of range";
    if (one.offset % 16 != 0 || one.offset > plan.replacementBytes ||
        one.bytes > plan.replacementBytes - one.offset)
      return "place of a replacement out of range";
  }
  return nullptr;
}

/// The plan is copied first: what is checked is what is used.
const char* faultOf(const Plan& plan) {
  if (plan.magic != channel::kMagic) return "not a capture channel";
  if (plan.version != channel::kVersion) return "another version of the capture channel";
  if (plan.frameCount < 1 || plan.frameCount > channel::kMaxFrames)
    return "frame count out of range";
  if (plan.slotBytes > std::uint64_t{4} * channel::kMaxSide * channel::kMaxSide)
    return "slot size out of range";
  for (std::uint32_t i = 0; i < plan.frameCount; ++i) {
    const channel::PlannedFrame& frame = plan.frames[i];
    if (!std::isfinite(frame.time) || frame.time < 0) return "frame time out of range";
    if (frame.width > channel::kMaxSide || frame.height > channel::kMaxSide)
      return "frame size out of range";
    if (frame.unseen > 1) return "a switch of a frame is neither 0 nor 1";
  }
  if (const char* const fault = faultOf(plan.trace)) return fault;
  return faultOfReplacements(plan);
}

class Writer {
public:
  Writer() : verbose_(isSet("GG_CAPTURE_VERBOSE")) {
    if (const char* const text = std::getenv(channel::kDescriptorVariable)) open(text);
  }

  const Plan* plan() const { return header_ ? &plan_ : nullptr; }

  /// A place in the file.
  template <typename Value> Value* at(std::uint64_t offset) const {
    return reinterpret_cast<Value*>(reinterpret_cast<std::byte*>(header_) + offset);
  }

  void message(channel::MessageKind kind, std::string_view text) {
    const std::lock_guard lock(mutex_);
    if (verbose_ && printed_.emplace(text).second) {
      std::fprintf(stderr, "ggrade capture: %.*s\n", static_cast<int>(text.size()), text.data());
    }
    if (!header_) return;
    char stored[sizeof(Message::text)] = {};
    std::memcpy(stored, text.data(), std::min(text.size(), sizeof(stored) - 1));
    const auto number = static_cast<std::uint32_t>(kind);
    for (std::uint32_t i = 0; i < messages_; ++i) {
      Message& known = header_->messages[i];
      if (known.kind == number && std::strcmp(known.text, stored) == 0) {
        ++known.count;
        if (early_[i] && !isUnseen()) place(i);
        return;
      }
    }
    if (messages_ == channel::kMaxMessages) {
      ++header_->messagesLost;
      return;
    }
    Message& message = header_->messages[messages_];
    message.kind = number;
    message.count = 1;
    std::memcpy(message.text, stored, sizeof(stored));
    place(messages_);
    header_->messageCount = ++messages_;
  }

  void context(double seconds, const char* version, const char* renderer) {
    if (!header_ || header_->contextMade) return;
    header_->contextSeconds = seconds;
    copyText(header_->glVersion, version);
    copyText(header_->glRenderer, renderer);
    header_->contextMade = 1;
  }

  void shaderSeconds(double seconds) {
    const std::lock_guard lock(mutex_);
    if (header_) header_->shaderSeconds += seconds;
  }

  void ended() {
    if (header_) header_->endedByCapture = 1;
  }

  void answer(std::uint32_t index, channel::ReplacementAnswer answer) {
    if (header_) header_->replacements[index] = static_cast<std::uint32_t>(answer);
  }

  void tapeBytes(std::uint64_t bytes) { header_->tapeBytes = bytes; }
  void tapeRefused(const char* what) { copyText(header_->tapeRefused, what); }

  void frame(const channel::FrameRecord& record, const std::uint8_t* pixels) {
    if (!header_ || frames_ >= plan_.frameCount) return;
    channel::FrameRecord stored = record;
    const std::uint64_t bytes = std::uint64_t{4} * record.width * record.height;
    stored.written = !isUnseen() && bytes <= plan_.slotBytes;
    if (stored.written) {
      std::memcpy(at<std::uint8_t>(channel::slotOffset(plan_, frames_)), pixels, bytes);
    }
    header_->frames[frames_] = stored;
    header_->framesDone = ++frames_;
  }

private:
  /// Is the frame that is being drawn one that nobody looks at?
  bool isUnseen() const { return frames_ < plan_.frameCount && plan_.frames[frames_].unseen; }

  /// A message came in this frame and pass.
  void place(std::uint32_t index) {
    header_->messages[index].frame = frames_;
    header_->messages[index].pass = messagePass;
    early_[index] = isUnseen();
  }

  static bool isSet(const char* variable) {
    const char* const text = std::getenv(variable);
    return text && *text && std::strcmp(text, "0") != 0;
  }

  template <std::size_t size> static void copyText(char (&to)[size], const char* from) {
    std::strncpy(to, from ? from : "", size - 1);
  }

  void open(const char* text) {
    char* end = nullptr;
    const long descriptor = std::strtol(text, &end, 10);
    if (end == text || *end || descriptor < 0 || descriptor > 1 << 20)
      refuse("not a descriptor number");
    const int fd = static_cast<int>(descriptor);
    if (pread(fd, &plan_, sizeof(plan_), 0) != static_cast<ssize_t>(sizeof(plan_)))
      refuse("cannot read the plan");
    if (const char* const fault = faultOf(plan_)) refuse(fault);
    struct stat status {};
    if (fstat(fd, &status) != 0 ||
        static_cast<std::uint64_t>(status.st_size) < channel::totalBytes(plan_)) {
      refuse("the file is smaller than its plan");
    }
    void* const file =
        mmap(nullptr, channel::totalBytes(plan_), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    if (file == MAP_FAILED) refuse("cannot map the file");
    header_ = static_cast<Header*>(file);
    header_->started = 1;
    // Programs that this one starts are not the captured one.
    close(fd);
    unsetenv(channel::kDescriptorVariable);
  }

  std::mutex mutex_;
  bool verbose_;
  std::set<std::string, std::less<>> printed_;
  Plan plan_{};
  Header* header_ = nullptr;
  std::bitset<channel::kMaxMessages> early_; ///< messages that came in unseen frames only
  std::uint32_t messages_ = 0; ///< our own count: the program can write to the file as well
  std::uint32_t frames_ = 0;
};

/// Never destroyed: the program's own destructors may still call GL.
Writer& writer() {
  static Writer* const instance = new Writer;
  return *instance;
}

/// The plan is checked and `started` set before `main`, whether or not the program calls anything.
[[gnu::constructor]] void openChannel() {
  writer();
  recordsPasses = plan() && plan()->trace.passes;
  tape::isWanted = recordsPasses && plan()->trace.tapeFrames > 0;
}

} // namespace

bool recordsPasses = false;

const Plan* plan() {
  return writer().plan();
}

trace::Tables* recordTables() {
  return recordsPasses ? writer().at<trace::Tables>(channel::tablesOffset()) : nullptr;
}

std::byte* recordCopies() {
  return recordsPasses ? writer().at<std::byte>(channel::copiesOffset(*plan())) : nullptr;
}

std::byte* tapeRoom() {
  return writer().at<std::byte>(channel::tapeOffset(*plan()));
}

void writeTapeBytes(std::uint64_t bytes) {
  writer().tapeBytes(bytes);
}

void writeTapeRefused(const char* what) {
  writer().tapeRefused(what);
}

const std::byte* replacementPixels(const channel::Replacement& replacement) {
  return writer().at<std::byte>(channel::replacementsOffset(*plan()) + replacement.offset);
}

void answerReplacement(std::uint32_t index, channel::ReplacementAnswer answer) {
  writer().answer(index, answer);
}

void setMessagePass(std::uint32_t pass) {
  messagePass = pass;
}

void writeMessage(channel::MessageKind kind, std::string_view text) {
  writer().message(kind, text);
}

void say(const char* format, ...) {
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof(text), format, arguments);
  va_end(arguments);
  writeMessage(channel::MessageKind::capture, text);
}

void writeContext(double seconds, const char* version, const char* renderer) {
  writer().context(seconds, version, renderer);
}

void addShaderSeconds(double seconds) {
  writer().shaderSeconds(seconds);
}

void writeEndedByCapture() {
  writer().ended();
}

void writeFrame(const channel::FrameRecord& record, const std::uint8_t* pixels) {
  writer().frame(record, pixels);
}

} // namespace ggrade::capture
