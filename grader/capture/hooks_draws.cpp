// Everything that draws, clears or blits: counts what reaches the window (draw calls and blits,
// clears, and whether sRGB encoding was on for it), and tells the recorder.

#include "capture/channel_writer.hpp"
#include "capture/context.hpp"
#include "capture/context_state.hpp"
#include "capture/gl_hooks.hpp"
#include "capture/recorder/defined_outputs.hpp"
#include "capture/recorder/recorder.hpp"

#include <array>

namespace ggrade::capture {
namespace {

using recorder::ClearValue;
using recorder::DrawCall;

enum class Use { draw, clear };

/// While sRGB encoding is off for the window's sake.
thread_local bool encodingOff = false;

void setEncoding(bool on) {
  static const auto enable = real<decltype(&glEnable)>("glEnable");
  static const auto disable = real<decltype(&glDisable)>("glDisable");
  (on ? enable : disable)(GL_FRAMEBUFFER_SRGB);
  encodingOff = !on;
}

void count(Use use, bool window) {
  static const auto isEnabled = real<decltype(&glIsEnabled)>("glIsEnabled");
  ContextState* const state = currentState();
  if (!state || !window) return;
  if (use == Use::clear) {
    ++state->use.clears;
  } else if (!isEnabled(GL_RASTERIZER_DISCARD)) {
    ++state->use.draws;
  }
  if (!isEnabled(GL_FRAMEBUFFER_SRGB)) return;
  state->use.srgb = true;
  if (contextLibrary().encodesSrgb()) setEncoding(false);
}

/// Counts what goes to the bound draw framebuffer.
void countBound(Use use) {
  static const auto getIntegerv = real<decltype(&glGetIntegerv)>("glGetIntegerv");
  if (!currentState()) return;
  GLint bound = 0;
  getIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  count(use, bound == 0);
}

/// Lives until the GL call has returned.
struct Called {
  Called() = default;
  ~Called() {
    if (encodingOff) setEncoding(true);
    if (recordsPasses) recorder::done();
  }
  Called(const Called&) = delete;
  Called& operator=(const Called&) = delete;
};

struct Drawn : Called {
  const recorder::DefinedOutputs outputs;
};

struct Blitted {
  Blitted() = default;
  ~Blitted() {
    if (encodingOff) setEncoding(true);
    if (recordsPasses) recorder::ended();
  }
  Blitted(const Blitted&) = delete;
  Blitted& operator=(const Blitted&) = delete;
};

Drawn drawing(GLenum mode, std::uint64_t vertices) {
  countBound(Use::draw);
  if (recordsPasses) recorder::draw({mode, vertices});
  return {};
}

std::uint64_t times(GLsizei count, GLsizei instances) {
  return static_cast<std::uint64_t>(std::max(count, 0)) *
         static_cast<std::uint64_t>(std::max(instances, 0));
}

std::uint64_t total(const GLsizei* counts, GLsizei draws) {
  std::uint64_t sum = 0;
  for (GLsizei i = 0; recordsPasses && counts && i < draws; ++i) sum += times(counts[i], 1);
  return sum;
}

// One for each order of parameters.
constexpr auto arrays = [](GLenum mode, GLint, GLsizei count) {
  return drawing(mode, times(count, 1));
};
constexpr auto arraysInstanced = [](GLenum mode, GLint, GLsizei count, GLsizei instances, auto...) {
  return drawing(mode, times(count, instances));
};
constexpr auto elements = [](GLenum mode, GLsizei count, GLenum, const void*, auto...) {
  return drawing(mode, times(count, 1));
};
constexpr auto elementsInstanced = [](GLenum mode, GLsizei count, GLenum, const void*,
                                      GLsizei instances,
                                      auto...) { return drawing(mode, times(count, instances)); };
constexpr auto rangeElements = [](GLenum mode, GLuint, GLuint, GLsizei count, auto...) {
  return drawing(mode, times(count, 1));
};
constexpr auto multiArrays = [](GLenum mode, const GLint*, const GLsizei* counts, GLsizei draws) {
  return drawing(mode, total(counts, draws));
};
constexpr auto multiElements = [](GLenum mode, const GLsizei* counts, GLenum, const void* const*,
                                  GLsizei draws,
                                  auto...) { return drawing(mode, total(counts, draws)); };
constexpr auto modeOnly = [](GLenum mode, auto...) { return drawing(mode, 0); };
constexpr auto unknown = [](auto...) { return drawing(GL_NONE, 0); };
constexpr auto beginning = [](GLenum mode) {
  countBound(Use::draw);
  if (recordsPasses) recorder::begin(mode);
};

struct Encoded {
  Encoded() = default;
  ~Encoded() {
    if (encodingOff) setEncoding(true);
  }
  Encoded(const Encoded&) = delete;
  Encoded& operator=(const Encoded&) = delete;
};
constexpr auto ending = [] { return Encoded(); };

constexpr auto clearing = [](GLbitfield mask) {
  countBound(Use::clear);
  if (recordsPasses) recorder::clear(mask);
  return Called();
};

template <typename Value> ClearValue clearValue(GLenum buffer, const Value* value) {
  ClearValue result;
  if (!value) return result;
  switch (buffer) {
  case GL_COLOR:
    result.color = {static_cast<float>(value[0]), static_cast<float>(value[1]),
                    static_cast<float>(value[2]), static_cast<float>(value[3])};
    break;
  case GL_DEPTH:
    result.depth = static_cast<float>(value[0]);
    break;
  case GL_STENCIL:
    result.stencil = static_cast<std::uint32_t>(value[0]);
    break;
  default:
    break;
  }
  return result;
}

ClearValue depthStencil(GLfloat depth, GLint stencil) {
  ClearValue result;
  result.depth = depth;
  result.stencil = static_cast<std::uint32_t>(stencil);
  return result;
}

constexpr auto clearingBuffer = [](GLenum buffer, GLint drawBuffer, const auto* value) {
  countBound(Use::clear);
  if (recordsPasses) recorder::clearBuffer(drawBuffer, clearValue(buffer, value));
  return Called();
};
constexpr auto clearingDepthStencil = [](GLenum, GLint drawBuffer, GLfloat depth, GLint stencil) {
  countBound(Use::clear);
  if (recordsPasses) recorder::clearBuffer(drawBuffer, depthStencil(depth, stencil));
  return Called();
};
constexpr auto clearingNamed = [](GLuint framebuffer, GLenum buffer, GLint drawBuffer,
                                  const auto* value) {
  count(Use::clear, framebuffer == 0);
  if (recordsPasses) recorder::clearBufferOf(framebuffer, drawBuffer, clearValue(buffer, value));
  return Called();
};
constexpr auto clearingNamedDepthStencil = [](GLuint framebuffer, GLenum, GLint drawBuffer,
                                              GLfloat depth, GLint stencil) {
  count(Use::clear, framebuffer == 0);
  if (recordsPasses) recorder::clearBufferOf(framebuffer, drawBuffer, depthStencil(depth, stencil));
  return Called();
};

constexpr auto blitting = [](GLint, GLint, GLint, GLint, GLint x0, GLint y0, GLint x1, GLint y1,
                             GLbitfield mask, GLenum) {
  countBound(Use::draw);
  if (recordsPasses) recorder::blit({x0, y0, x1, y1}, mask);
  return Blitted();
};
constexpr auto blittingNamed = [](GLuint from, GLuint to, GLint, GLint, GLint, GLint, GLint x0,
                                  GLint y0, GLint x1, GLint y1, GLbitfield mask, GLenum) {
  count(Use::draw, to == 0);
  if (recordsPasses) recorder::blitOf(from, to, {x0, y0, x1, y1}, mask);
  return Blitted();
};

const Hook kDrawHooks[] = {
    GG_AROUND(glDrawArrays, arrays),
    GG_AROUND(glDrawArraysEXT, arrays),
    GG_AROUND(glDrawArraysIndirect, modeOnly),
    GG_AROUND(glDrawArraysInstanced, arraysInstanced),
    GG_AROUND(glDrawArraysInstancedARB, arraysInstanced),
    GG_AROUND(glDrawArraysInstancedBaseInstance, arraysInstanced),
    GG_AROUND(glDrawArraysInstancedEXT, arraysInstanced),
    GG_AROUND(glDrawElements, elements),
    GG_AROUND(glDrawElementsBaseVertex, elements),
    GG_AROUND(glDrawElementsIndirect, modeOnly),
    GG_AROUND(glDrawElementsInstanced, elementsInstanced),
    GG_AROUND(glDrawElementsInstancedARB, elementsInstanced),
    GG_AROUND(glDrawElementsInstancedBaseInstance, elementsInstanced),
    GG_AROUND(glDrawElementsInstancedBaseVertex, elementsInstanced),
    GG_AROUND(glDrawElementsInstancedBaseVertexBaseInstance, elementsInstanced),
    GG_AROUND(glDrawElementsInstancedEXT, elementsInstanced),
    GG_AROUND(glDrawRangeElements, rangeElements),
    GG_AROUND(glDrawRangeElementsBaseVertex, rangeElements),
    GG_AROUND(glDrawRangeElementsEXT, rangeElements),
    GG_AROUND(glDrawTransformFeedback, modeOnly),
    GG_AROUND(glDrawTransformFeedbackInstanced, modeOnly),
    GG_AROUND(glDrawTransformFeedbackStream, modeOnly),
    GG_AROUND(glDrawTransformFeedbackStreamInstanced, modeOnly),
    GG_AROUND(glMultiDrawArrays, multiArrays),
    GG_AROUND(glMultiDrawArraysEXT, multiArrays),
    GG_AROUND(glMultiDrawArraysIndirect, modeOnly),
    GG_AROUND(glMultiDrawArraysIndirectAMD, modeOnly),
    GG_AROUND(glMultiDrawArraysIndirectCount, modeOnly),
    GG_AROUND(glMultiDrawArraysIndirectCountARB, modeOnly),
    GG_AROUND(glMultiDrawElements, multiElements),
    GG_AROUND(glMultiDrawElementsBaseVertex, multiElements),
    GG_AROUND(glMultiDrawElementsEXT, multiElements),
    GG_AROUND(glMultiDrawElementsIndirect, modeOnly),
    GG_AROUND(glMultiDrawElementsIndirectAMD, modeOnly),
    GG_AROUND(glMultiDrawElementsIndirectCount, modeOnly),
    GG_AROUND(glMultiDrawElementsIndirectCountARB, modeOnly),
    GG_AROUND(glMultiModeDrawArraysIBM, unknown),
    GG_AROUND(glMultiModeDrawElementsIBM, unknown),
    // compatibility profile
    GG_AROUND(glBegin, beginning),
    GG_AROUND(glBitmap, unknown),
    GG_AROUND(glCallList, unknown),
    GG_AROUND(glCallLists, unknown),
    GG_AROUND(glCopyPixels, unknown),
    GG_AROUND(glDrawPixels, unknown),
    GG_AROUND(glEnd, ending),
    GG_AROUND(glEvalMesh1, unknown),
    GG_AROUND(glEvalMesh2, unknown),
    GG_AROUND(glRectd, unknown),
    GG_AROUND(glRectdv, unknown),
    GG_AROUND(glRectf, unknown),
    GG_AROUND(glRectfv, unknown),
    GG_AROUND(glRecti, unknown),
    GG_AROUND(glRectiv, unknown),
    GG_AROUND(glRects, unknown),
    GG_AROUND(glRectsv, unknown),
    // blits
    GG_AROUND(glBlitFramebuffer, blitting),
    GG_AROUND(glBlitFramebufferEXT, blitting),
    GG_AROUND(glBlitNamedFramebuffer, blittingNamed),
    // clears
    GG_AROUND(glClear, clearing),
    GG_AROUND(glClearBufferfi, clearingDepthStencil),
    GG_AROUND(glClearBufferfv, clearingBuffer),
    GG_AROUND(glClearBufferiv, clearingBuffer),
    GG_AROUND(glClearBufferuiv, clearingBuffer),
    GG_AROUND(glClearNamedFramebufferfi, clearingNamedDepthStencil),
    GG_AROUND(glClearNamedFramebufferfv, clearingNamed),
    GG_AROUND(glClearNamedFramebufferiv, clearingNamed),
    GG_AROUND(glClearNamedFramebufferuiv, clearingNamed),
};

} // namespace

std::span<const Hook> drawHooks() {
  return kDrawHooks;
}

} // namespace ggrade::capture
