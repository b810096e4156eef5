#include "capture/channel_reader.hpp"

#include "capture/channel_plan.hpp"
#include "capture/checker.hpp"
#include "capture/tables_reader.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <sys/mman.h>
#include <system_error>
#include <unistd.h>

namespace ggrade::channel {
namespace {

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

/// How many of the first `count` frames are looked at.
std::uint32_t seenOf(const Plan& plan, std::uint32_t count) {
  const PlannedFrame* const end = plan.frames + std::min(count, plan.frameCount);
  return count - static_cast<std::uint32_t>(std::count_if(
                     plan.frames, end, [](const PlannedFrame& one) { return one.unseen != 0; }));
}

/// `passes`: how many were recorded.
bool checkMessage(Checker& check, const std::string& at, const Message& from, const Plan& plan,
                  std::uint32_t passes, CapturedMessage& to) {
  to.kind = static_cast<MessageKind>(from.kind);
  to.frame = seenOf(plan, from.frame);
  to.count = from.count;
  // Nothing says which pass where none is recorded.
  to.pass = passes == 0 ? trace::kNone : from.pass;
  return check.atLeast(at + "kind", from.kind, static_cast<std::uint32_t>(MessageKind::glError)) &&
         check.atMost(at + "kind", from.kind, static_cast<std::uint32_t>(MessageKind::capture)) &&
         check.atMost(at + "frame", from.frame, kMaxFrames) &&
         (to.pass == trace::kNone || check.range(at + "pass", to.pass, 1, passes)) &&
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

bool checkCounts(Checker& check, const trace::Counts& counts, std::uint64_t copyRoom) {
  return check.atMost("counts.passes", counts.passes, trace::kMaxPasses) &&
         check.atMost("counts.steps", counts.steps, trace::kMaxSteps) &&
         check.atMost("counts.matrices", counts.matrices, trace::kMaxMatrices) &&
         check.atMost("counts.samples", counts.samples, trace::kMaxSamples) &&
         check.atMost("counts.copies", counts.copies, trace::kMaxCopies) &&
         check.atMost("counts.copyBytes", counts.copyBytes, copyRoom);
}

/// Everything but pixels and tables. Returns what is wrong, or nothing.
std::string check(const Header& from, const Plan& plan, std::uint32_t passes, Capture& to) {
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
    if (!checkMessage(check, element("messages", i), from.messages[i], plan, passes,
                      to.messages[i]))
      return check.error;
  }
  for (std::uint32_t i = 0; i < from.framesDone; ++i) {
    const PlannedFrame& planned = plan.frames[i];
    if (planned.unseen) {
      ++to.unseenFrames;
      continue;
    }
    CapturedFrame& frame = to.frames.emplace_back();
    frame.time = planned.time;
    if (!checkFrame(check, element("frames", i), from.frames[i], plan.slotBytes, frame))
      return check.error;
    // The library makes every window as large as planned: another size is somebody else's writing.
    if ((planned.width != 0 && frame.width != planned.width) ||
        (planned.height != 0 && frame.height != planned.height))
      return element("frames", i) + "size: " + std::to_string(frame.width) + "x" +
             std::to_string(frame.height) + " is not the planned " + std::to_string(planned.width) +
             "x" + std::to_string(planned.height);
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

template <typename Record>
std::vector<Record> readTable(int descriptor, std::size_t offset, std::uint32_t count) {
  std::vector<Record> records(count);
  readAll(descriptor, records.data(), count * sizeof(Record), tablesOffset() + offset);
  return records;
}

/// The filled rows of every table, unchecked; `counts` has been checked.
trace::Trace readTables(int descriptor, const Header& header, const Plan& plan,
                        const trace::Counts& counts) {
  using namespace trace;
  Trace trace;
  for (std::uint32_t i = 0; i < header.framesDone; ++i) {
    const FrameRecord& frame = header.frames[i];
    if (plan.frames[i].unseen) continue;
    trace.frames.push_back({frame.firstPass, frame.passCount, frame.imageBytes, frame.bufferBytes});
  }
  trace.passes = readTable<PassRecord>(descriptor, offsetof(Tables, passes), counts.passes);
  trace.steps = readTable<StepRecord>(descriptor, offsetof(Tables, steps), counts.steps);
  trace.matrices = readTable<MatrixRecord>(descriptor, offsetof(Tables, matrices), counts.matrices);
  trace.samples = readTable<SampleRecord>(descriptor, offsetof(Tables, samples), counts.samples);
  trace.copies = readTable<CopyRecord>(descriptor, offsetof(Tables, copies), counts.copies);
  trace.passesLost = counts.passesLost;
  trace.stepsLost = counts.stepsLost;
  trace.matricesLost = counts.matricesLost;
  trace.samplesLost = counts.samplesLost;
  trace.copiesLost = counts.copiesLost;
  return trace;
}

/// The answers to what was planned. `trace` has been checked: what is said to be done must have
/// been possible there.
bool readAnswers(Checker& check, const Header& header, const Plan& plan, const trace::Trace& trace,
                 std::vector<ReplacementAnswer>& to) {
  for (std::uint32_t i = 0; i < plan.replacementCount; ++i) {
    const Replacement& planned = plan.replacements[i];
    const std::uint32_t answer = header.replacements[i];
    const std::string at = element("replacements", i);
    if (!check.atMost(at + "answer", answer,
                      static_cast<std::uint32_t>(ReplacementAnswer::refused)))
      return false;
    to.push_back(static_cast<ReplacementAnswer>(answer));
    if (to.back() != ReplacementAnswer::done) continue;
    if (!check.range(at + "pass", planned.pass, 1, trace.passes.size())) return false;
    const trace::PassRecord& pass = trace.passes[planned.pass];
    const trace::ImageRef& image = pass.images[planned.attachment];
    if (!check.equal(at + "frame", pass.frame, 0) ||
        !check.equal(at + "kind", image.kind,
                     static_cast<std::uint32_t>(trace::ImageKind::texture)) ||
        !check.equal(at + "samples", image.samples, 0) ||
        !check.equal(at + "format", image.format, planned.format) ||
        !check.equal(at + "width", image.width, planned.width) ||
        !check.equal(at + "height", image.height, planned.height))
      return false;
  }
  return true;
}

/// The bytes of the copies, whose places have been checked.
void readCopies(int descriptor, std::uint64_t offset, trace::Trace& trace) {
  if (trace.copies.empty()) return;
  trace.pixels.resize(trace.copies.back().offset + trace.copies.back().bytes);
  readAll(descriptor, trace.pixels.data(), trace.pixels.size(), offset);
  turnCopies(trace);
}

} // namespace

Channel::Channel(const std::vector<PlannedFrame>& frames, std::uint64_t maxPixels,
                 const trace::Request& trace, const std::vector<PassPixels>& replacements)
    : plan_(makePlan(frames, maxPixels, trace, replacements)),
      descriptor_(memfd_create("ggrade-capture", MFD_CLOEXEC | MFD_ALLOW_SEALING)) {
  if (descriptor_ < 0) throwSystem("cannot create the capture channel");
  try {
    if (ftruncate(descriptor_, static_cast<off_t>(totalBytes(plan_))) != 0) {
      throwSystem("cannot size the capture channel");
    }
    writePlan(descriptor_, plan_, replacements);
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
  trace::Counts counts{};
  if (plan_.trace.passes) {
    readAll(descriptor_, &counts, sizeof counts, tablesOffset() + offsetof(trace::Tables, counts));
  }
  Capture capture;
  const auto refused = [&](std::string error) {
    capture = {};
    capture.error = std::move(error);
    return std::move(capture);
  };
  Checker checker;
  if (!checkCounts(checker, counts, plan_.trace.copyBytes)) return refused(checker.error);
  if (std::string error = check(*header, plan_, counts.passes, capture); !error.empty()) {
    return refused(std::move(error));
  }
  if (plan_.trace.passes) {
    capture.trace = readTables(descriptor_, *header, plan_, counts);
    const auto frames = static_cast<std::uint32_t>(capture.frames.size());
    if (!checkTables(checker, capture.trace, frames, counts.copyBytes) ||
        !readAnswers(checker, *header, plan_, capture.trace, capture.replacements)) {
      return refused(checker.error);
    }
    readCopies(descriptor_, copiesOffset(plan_), capture.trace);
  }
  if (plan_.trace.tapeFrames > 0) {
    if (!checker.atMost("tapeBytes", header->tapeBytes, plan_.trace.tapeBytes) ||
        !checker.text("tapeRefused", header->tapeRefused, capture.tapeRefused))
      return refused(checker.error);
    if (capture.tapeRefused.empty()) {
      capture.tape.resize(header->tapeBytes);
      readAll(descriptor_, capture.tape.data(), capture.tape.size(), tapeOffset(plan_));
    }
  }
  std::size_t next = 0;
  for (std::uint32_t i = 0; i < header->framesDone; ++i) {
    if (plan_.frames[i].unseen) continue;
    CapturedFrame& frame = capture.frames[next++];
    if (frame.written) readPixels(descriptor_, slotOffset(plan_, i), frame);
  }
  return capture;
}

} // namespace ggrade::channel
