// Where passes begin and end.

#include "capture/channel_writer.hpp"
#include "capture/recorder/copies.hpp"
#include "capture/recorder/gl_calls.hpp"
#include "capture/recorder/session.hpp"

#include <algorithm>
#include <ctime>

namespace ggrade::capture::recorder {
namespace {

using trace::ImageKind;
using trace::kNone;

bool isWanted(const trace::Request& request, const trace::ImageRef& image,
              std::uint32_t attachment) {
  switch (static_cast<ImageKind>(image.kind)) {
  case ImageKind::window:
    return request.windowCopies >> attachment & 1;
  case ImageKind::renderbuffer:
    return request.renderbufferCopies >> attachment & 1;
  case ImageKind::texture:
    return true;
  default:
    return false;
  }
}

/// The pass is the last one that wrote to its images. One that isn't in the table leaves them
/// without a known writer.
void noteWriter(Writers& writers, const Place& place, std::uint32_t level, std::uint32_t layer,
                std::uint32_t pass) {
  if (pass == kNone) {
    writers.forget(place, level);
  } else {
    writers.set(place, level, layer, pass);
  }
}

void noteWriters(Session& session, const OpenPass& pass) {
  Writers& writers = session.shared().writers;
  for (std::uint32_t i = 0; i < trace::kAttachments; ++i) {
    const trace::ImageRef& image = pass.record.images[i];
    if (pass.record.written >> i & 1)
      noteWriter(writers, session.placeOf(image), image.level, image.layer, pass.index);
  }
  for (const OtherWrite& write : pass.otherWrites)
    noteWriter(writers, write.place, write.level, write.layer, pass.index);
}

void writeSteps(Session& session, OpenPass& pass) {
  TableWriter& tables = session.shared().tables;
  std::uint32_t written = 0;
  for (OpenStep& step : pass.steps) {
    if (!step.kept) continue;
    step.record.pass = pass.index;
    step.record.matrixCount = static_cast<std::uint32_t>(step.matrices.size());
    step.record.firstMatrix = tables.addMatrices(step.matrices);
    step.record.sampleCount = step.samplesKept;
    step.record.firstSample = tables.addSamples(std::span(step.samples).first(step.samplesKept));
    const std::uint32_t index = tables.addStep(step.record);
    if (written++ == 0) pass.record.firstStep = index;
  }
  pass.record.stepCount = written;
  // Steps that are in the table come first.
  for (const OpenPass::StepCopy& copy : pass.stepCopies)
    tables.setStepOfCopy(copy.copy, pass.record.firstStep + copy.step);
}

double secondsOf(const OpenPass& pass) {
  const std::chrono::nanoseconds finishing = passClock();
  gl().finish();
  const auto calls = std::max(pass.lastCall, pass.start) - pass.start;
  return std::chrono::duration<double>(calls + (passClock() - finishing)).count();
}

} // namespace

std::chrono::nanoseconds passClock() {
  // llvmpipe without threads of its own draws in the thread that calls it.
  const bool processor = plan()->trace.times == std::uint32_t(trace::Times::processor);
  timespec now{};
  clock_gettime(processor ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &now);
  return std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec);
}

OpenPass& beginPass(Session& session, trace::PassKind kind) {
  endPass(session);
  OpenPass& pass = session.context().pass.emplace();
  pass.isSeen = session.isSeen();
  pass.record.frame = session.shared().seenFrames;
  pass.record.kind = static_cast<std::uint32_t>(kind);
  pass.record.framebuffer = kNone;
  pass.record.status = GL_FRAMEBUFFER_COMPLETE;
  for (trace::ImageRef& image : pass.record.images) image.layer = kNone;
  if (pass.isSeen) pass.index = session.shared().tables.addPass(pass.record);
  setMessagePass(pass.index);
  if (session.shared().request.times) {
    gl().finish();
    pass.start = pass.lastCall = passClock();
  }
  return pass;
}

OpenPass& passFor(Session& session, const Target& target, bool isClear) {
  const std::optional<OpenPass>& open = session.context().pass;
  const bool goesOn = open && open->isSeen == session.isSeen() &&
                      open->record.kind == static_cast<std::uint32_t>(trace::PassKind::draw) &&
                      sameImages(open->target, target) && !(isClear && open->record.draws > 0);
  if (goesOn) return *session.context().pass;
  OpenPass& pass = beginPass(session, trace::PassKind::draw);
  pass.target = target;
  pass.record.framebuffer = target.framebuffer;
  pass.record.status = gl().checkFramebufferStatus(GL_DRAW_FRAMEBUFFER);
  pass.record.drawBuffers = target.drawBuffers;
  for (std::uint32_t i = 0; i < trace::kColors; ++i)
    pass.record.attachmentOfOutput[i] =
        std::uint8_t(std::min(target.attachmentOfBuffer[i], trace::kColors));
  gl().getIntegerv(GL_VIEWPORT, pass.record.viewport);
  for (std::uint32_t i = 0; i < trace::kAttachments; ++i) {
    pass.record.images[i] = target.images[i];
    describe(pass.record.images[i], i, session.state().windowSize);
  }
  if (pass.index != kNone) session.shared().tables.setPass(pass.index, pass.record);
  return pass;
}

void copyAttachments(Session& session, OpenPass& pass, std::uint32_t mask, std::uint32_t step) {
  Shared& shared = session.shared();
  const trace::Request& request = shared.request;
  mask &= request.copies;
  if (!mask || pass.index == kNone || pass.record.frame >= request.copyFrames) return;
  std::optional<ImageReader> reader;
  for (std::uint32_t i = 0; i < trace::kAttachments; ++i) {
    const trace::ImageRef& image = pass.record.images[i];
    if (!(mask >> i & 1) || !isWanted(request, image, i)) continue;
    if (!reader) reader.emplace(session.context().framebuffer);
    trace::CopyRecord record{};
    record.pass = pass.index;
    record.step = kNone;
    record.attachment = i;
    const std::uint32_t copy = reader->copy(image, record, shared.tables);
    if (copy != kNone && step != kNone) pass.stepCopies.push_back({copy, step});
  }
}

void endPass(Session& session) {
  if (!session.context().pass) return;
  OpenPass& pass = *session.context().pass;
  if (session.shared().request.times) pass.record.seconds = secondsOf(pass);
  endStep(session, pass);
  if (!pass.otherWrites.empty()) gl().memoryBarrier(GL_ALL_BARRIER_BITS);
  replaceOutputs(pass);
  copyAttachments(session, pass, pass.record.written, kNone);
  noteWriters(session, pass);
  if (pass.index != kNone) {
    writeSteps(session, pass);
    session.shared().tables.setPass(pass.index, pass.record);
  }
  setMessagePass(kNone);
  session.context().pass.reset();
}

} // namespace ggrade::capture::recorder
