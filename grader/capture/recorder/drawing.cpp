// Draws and clears.

#include "capture/channel_writer.hpp"
#include "capture/recorder/gl_calls.hpp"
#include "capture/recorder/recorder.hpp"
#include "capture/recorder/session.hpp"
#include "capture/recorder/state.hpp"

#include <algorithm>

namespace ggrade::capture::recorder {
namespace {

/// What a clear of the bound draw framebuffer changes. `asked` is a mask of attachments.
void recordClear(Session& session, const Target& target, std::uint32_t asked,
                 const ClearValue& value) {
  OpenPass& pass = passFor(session, target, true);
  trace::PassRecord& record = pass.record;
  if (record.status != GL_FRAMEBUFFER_COMPLETE) return;
  const ClearEffect effect = effectOfClear(asked, target, record.images);
  record.cleared |= effect.covered;
  record.written |= effect.written;
  if (value.color && effect.written & ((1U << trace::kColors) - 1))
    std::copy(value.color->begin(), value.color->end(), record.clearColor);
  if (value.depth && effect.written >> trace::kDepth & 1) record.clearDepth = *value.depth;
  if (value.stencil && effect.written >> trace::kStencil & 1) record.clearStencil = *value.stencil;
}

void recordClearBuffer(Session& session, GLint drawBuffer, const ClearValue& value) {
  const Target target = boundTarget();
  std::uint32_t asked = 0;
  if (value.color && drawBuffer >= 0 && drawBuffer < static_cast<GLint>(trace::kColors)) {
    const std::uint32_t at = target.attachmentOfBuffer[drawBuffer];
    if (at != trace::kNone) asked |= 1U << at;
  }
  if (value.depth) asked |= 1U << trace::kDepth;
  if (value.stencil) asked |= 1U << trace::kStencil;
  recordClear(session, target, asked, value);
}

} // namespace

void draw(const DrawCall& call) {
  if (call.mode > GL_PATCHES) return; // an error of the program's; nothing is drawn
  Session session;
  if (!session) return;
  const Target target = boundTarget();
  OpenPass& pass = passFor(session, target, false);
  trace::PassRecord& record = pass.record;
  if (record.draws == 0) gl().getIntegerv(GL_VIEWPORT, record.viewport);
  OpenStep* const step = stepFor(session, pass);
  if (step) {
    if (step->record.draws == 0) step->record.mode = call.mode;
    recordMatrices(session, *step);
    ++step->record.draws;
    step->record.vertices += call.vertices;
    if (record.status == GL_FRAMEBUFFER_COMPLETE) {
      step->written |= writtenBy(step->record, target);
      record.written |= step->written;
      noteImageStores(session, pass, step->programs);
    }
  } else if (record.status == GL_FRAMEBUFFER_COMPLETE) {
    record.written |= writtenBy(readState(), target);
  }
  ++record.draws;
  record.vertices += call.vertices;
}

void begin(GLenum mode) {
  draw({mode, 0});
  if (ContextState* const state = currentState(); state && state->recorder)
    state->recorder->insideBegin = true;
}

void end() {
  if (ContextState* const state = currentState(); state && state->recorder)
    state->recorder->insideBegin = false;
}

void clear(GLbitfield mask) {
  constexpr GLbitfield kKnown = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
  // Other bits are an error of the program's; nothing is cleared.
  if (!(mask & kKnown) || mask & ~(kKnown | GL_ACCUM_BUFFER_BIT)) return;
  Session session;
  if (!session) return;
  const Target target = boundTarget();
  ClearValue value;
  std::uint32_t asked = 0;
  if (mask & GL_COLOR_BUFFER_BIT) {
    gl().getFloatv(GL_COLOR_CLEAR_VALUE, value.color.emplace().data());
    asked |= target.drawBuffers;
  }
  if (mask & GL_DEPTH_BUFFER_BIT) {
    gl().getFloatv(GL_DEPTH_CLEAR_VALUE, &value.depth.emplace());
    asked |= 1U << trace::kDepth;
  }
  if (mask & GL_STENCIL_BUFFER_BIT) {
    value.stencil = number(GL_STENCIL_CLEAR_VALUE);
    asked |= 1U << trace::kStencil;
  }
  recordClear(session, target, asked, value);
}

void clearBuffer(GLint drawBuffer, const ClearValue& value) {
  Session session;
  if (session) recordClearBuffer(session, drawBuffer, value);
}

void clearBufferOf(GLuint framebuffer, GLint drawBuffer, const ClearValue& value) {
  Session session;
  if (!session || (framebuffer && !gl().isFramebuffer(framebuffer))) return;
  const GLuint bound = number(GL_DRAW_FRAMEBUFFER_BINDING);
  gl().bindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  recordClearBuffer(session, drawBuffer, value);
  gl().bindFramebuffer(GL_DRAW_FRAMEBUFFER, bound);
}

void done() {
  if (!plan()->trace.times) return;
  const ContextState* const state = currentState();
  if (state && state->recorder && state->recorder->pass)
    state->recorder->pass->lastCall = passClock();
}

} // namespace ggrade::capture::recorder
