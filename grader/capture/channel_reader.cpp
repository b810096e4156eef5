#include "capture/channel_reader.hpp"

#include "capture/utf8.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <sys/mman.h>
#include <system_error>
#include <unistd.h>

namespace ggrade::channel {
namespace {

constexpr double kLongest = 1e6; // seconds: longer than any run
constexpr std::uint64_t kMaxPixels = std::uint64_t{kMaxSide} * kMaxSide;

[[noreturn]] void throwSystem(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

void readAll(int descriptor, void* to, std::uint64_t bytes, std::uint64_t offset) {
  auto* at = static_cast<char*>(to);
  while (bytes > 0) {
    const ssize_t got = pread(descriptor, at, bytes, static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throwSystem("cannot read the capture channel");
    if (got == 0)
      throw std::system_error(std::make_error_code(std::errc::io_error),
                              "capture channel ends early");
    at += got;
    offset += static_cast<std::uint64_t>(got);
    bytes -= static_cast<std::uint64_t>(got);
  }
}

void writePlan(int descriptor, const Plan& plan) {
  std::vector<char> bytes(sizeof(Plan));
  std::memcpy(bytes.data(), &plan, sizeof(Plan));
  if (pwrite(descriptor, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throwSystem("cannot write the capture plan");
  }
}

Plan makePlan(const std::vector<PlannedFrame>& frames, std::uint64_t maxPixels,
              const trace::Request& trace) {
  const auto require = [](bool met, const std::string& rule) {
    if (!met) throw std::invalid_argument("capture plan: " + rule);
  };
  require(!frames.empty() && frames.size() <= kMaxFrames,
          "there are 1 to 64 frames, not " + std::to_string(frames.size()));
  require(maxPixels > 0 && maxPixels <= kMaxPixels, "a frame has 1 to 16384 x 16384 pixels");
  Plan plan{};
  plan.magic = kMagic;
  plan.version = kVersion;
  plan.frameCount = static_cast<std::uint32_t>(frames.size());
  std::uint64_t pixels = 0;
  for (const PlannedFrame& frame : frames) {
    require(std::isfinite(frame.time) && frame.time >= 0, "a time is finite and not negative");
    require(frame.width <= kMaxSide && frame.height <= kMaxSide, "a side has 16384 pixels at most");
    const bool open = frame.width == 0 || frame.height == 0;
    pixels = std::max(pixels, open ? maxPixels : std::uint64_t{frame.width} * frame.height);
  }
  plan.slotBytes = 4 * pixels;
  std::copy(frames.begin(), frames.end(), plan.frames);
  plan.trace = trace;
  return plan;
}

/// Checks claims one after another; the first one that fails is the result.
class Checker {
public:
  bool atMost(const std::string& field, std::uint64_t value, std::uint64_t limit) {
    return value <= limit ||
           fail(field, std::to_string(value) + " is above " + std::to_string(limit));
  }
  bool atLeast(const std::string& field, std::uint64_t value, std::uint64_t limit) {
    return value >= limit ||
           fail(field, std::to_string(value) + " is below " + std::to_string(limit));
  }
  bool seconds(const std::string& field, double value) {
    return (std::isfinite(value) && value >= 0 && value <= kLongest) ||
           fail(field, std::to_string(value) + " is not a time from 0 to 1000000 seconds");
  }
  template <std::size_t size>
  bool text(const std::string& field, const char (&from)[size], std::string& to) {
    const auto* const end = std::find(from, from + size, '\0');
    if (end == from + size) return fail(field, "the text does not end");
    to = sanitizedUtf8(std::string_view(from, static_cast<std::size_t>(end - from)));
    return true;
  }
  std::string error;

private:
  bool fail(const std::string& field, const std::string& reason) {
    error = field + ": " + reason;
    return false;
  }
};

std::string element(const char* list, std::uint32_t index) {
  return std::string(list) + "[" + std::to_string(index) + "].";
}

bool checkMessage(Checker& check, const std::string& at, const Message& from, CapturedMessage& to) {
  to.kind = static_cast<MessageKind>(from.kind);
  to.frame = from.frame;
  to.count = from.count;
  return check.atLeast(at + "kind", from.kind, static_cast<std::uint32_t>(MessageKind::glError)) &&
         check.atMost(at + "kind", from.kind, static_cast<std::uint32_t>(MessageKind::capture)) &&
         check.atMost(at + "frame", from.frame, kMaxFrames) &&
         check.text(at + "text", from.text, to.text);
}

bool checkFrame(Checker& check, const std::string& at, const FrameRecord& from,
                std::uint64_t slotBytes, CapturedFrame& to) {
  to.written = from.written != 0;
  to.width = from.width;
  to.height = from.height;
  to.windowDraws = from.windowDraws;
  to.windowClears = from.windowClears;
  to.boundFramebuffer = from.boundFramebuffer;
  to.windowSrgb = from.windowSrgb != 0;
  to.seconds = from.seconds;
  if (!check.atMost(at + "written", from.written, 1) ||
      !check.atMost(at + "windowSrgb", from.windowSrgb, 1) ||
      !check.atLeast(at + "width", from.width, 1) ||
      !check.atMost(at + "width", from.width, kMaxSide) ||
      !check.atLeast(at + "height", from.height, 1) ||
      !check.atMost(at + "height", from.height, kMaxSide) ||
      !check.seconds(at + "seconds", from.seconds)) {
    return false;
  }
  return !to.written ||
         check.atMost(at + "bytes", std::uint64_t{4} * from.width * from.height, slotBytes);
}

/// Everything but pixels. Returns what is wrong, or nothing.
std::string check(const Header& from, const Plan& plan, Capture& to) {
  Checker check;
  to.started = from.started != 0;
  to.contextMade = from.contextMade != 0;
  to.endedByCapture = from.endedByCapture != 0;
  to.contextSeconds = from.contextSeconds;
  to.shaderSeconds = from.shaderSeconds;
  to.messagesLost = from.messagesLost;
  const bool valid = check.atMost("started", from.started, 1) &&
                     check.atMost("contextMade", from.contextMade, 1) &&
                     check.atMost("endedByCapture", from.endedByCapture, 1) &&
                     check.atMost("framesDone", from.framesDone, plan.frameCount) &&
                     check.atMost("messageCount", from.messageCount, kMaxMessages) &&
                     check.seconds("contextSeconds", from.contextSeconds) &&
                     check.seconds("shaderSeconds", from.shaderSeconds) &&
                     check.text("glVersion", from.glVersion, to.glVersion) &&
                     check.text("glRenderer", from.glRenderer, to.glRenderer);
  if (!valid) return check.error;
  to.messages.resize(from.messageCount);
  for (std::uint32_t i = 0; i < from.messageCount; ++i) {
    if (!checkMessage(check, element("messages", i), from.messages[i], to.messages[i]))
      return check.error;
  }
  to.frames.resize(from.framesDone);
  for (std::uint32_t i = 0; i < from.framesDone; ++i) {
    to.frames[i].time = plan.frames[i].time;
    const PlannedFrame& planned = plan.frames[i];
    if (!checkFrame(check, element("frames", i), from.frames[i], plan.slotBytes, to.frames[i]))
      return check.error;
    // The library makes every window as large as planned: another size is somebody else's writing.
    if ((planned.width != 0 && to.frames[i].width != planned.width) ||
        (planned.height != 0 && to.frames[i].height != planned.height))
      return element("frames", i) + "size: " + std::to_string(to.frames[i].width) + "x" +
             std::to_string(to.frames[i].height) + " is not the planned " +
             std::to_string(planned.width) + "x" + std::to_string(planned.height);
  }
  return {};
}

/// Fills `frame.pixels`, whose size has been checked, turning rows over: the file has row 0 at the
/// bottom.
void readPixels(int descriptor, std::uint64_t offset, CapturedFrame& frame) {
  const std::size_t rowBytes = std::size_t{4} * frame.width;
  frame.pixels.resize(rowBytes * frame.height);
  readAll(descriptor, frame.pixels.data(), frame.pixels.size(), offset);
  const auto row = [&](std::uint32_t y) {
    return frame.pixels.begin() + static_cast<std::ptrdiff_t>(rowBytes * y);
  };
  for (std::uint32_t y = 0; y < frame.height / 2; ++y) {
    std::swap_ranges(row(y), row(y + 1), row(frame.height - 1 - y));
  }
}

} // namespace

Channel::Channel(const std::vector<PlannedFrame>& frames, std::uint64_t maxPixels,
                 const trace::Request& trace)
    : plan_(makePlan(frames, maxPixels, trace)),
      descriptor_(memfd_create("ggrade-capture", MFD_CLOEXEC | MFD_ALLOW_SEALING)) {
  if (descriptor_ < 0) throwSystem("cannot create the capture channel");
  try {
    if (ftruncate(descriptor_, static_cast<off_t>(totalBytes(plan_))) != 0) {
      throwSystem("cannot size the capture channel");
    }
    writePlan(descriptor_, plan_);
    // A child that shrinks the file would kill whoever has it mapped; one that grows it would take
    // memory for itself.
    if (fcntl(descriptor_, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) != 0) {
      throwSystem("cannot seal the capture channel");
    }
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

Channel::~Channel() {
  close(descriptor_);
}

Capture Channel::read() const {
  const auto header = std::make_unique<Header>();
  readAll(descriptor_, header.get(), sizeof(Header), 0);
  Capture capture;
  if (std::string error = check(*header, plan_, capture); !error.empty()) {
    capture = {};
    capture.error = std::move(error);
    return capture;
  }
  for (std::uint32_t i = 0; i < capture.frames.size(); ++i) {
    if (capture.frames[i].written) {
      readPixels(descriptor_, slotOffset(plan_, i), capture.frames[i]);
    }
  }
  return capture;
}

} // namespace ggrade::channel
