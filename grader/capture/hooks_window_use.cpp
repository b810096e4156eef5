// Counts what reaches the window: draw calls and blits, clears, and whether sRGB encoding was on
// for it.

#include "capture/context_state.hpp"
#include "capture/gl_hooks.hpp"

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace ggrade::capture {
namespace {

enum class Use { draw, clear };

void count(Use use, bool window) {
  static const auto isEnabled = real<decltype(&glIsEnabled)>("glIsEnabled");
  ContextState* const state = currentState();
  if (!state || !window) return;
  if (use == Use::clear) {
    ++state->use.clears;
  } else if (!isEnabled(GL_RASTERIZER_DISCARD)) {
    ++state->use.draws;
  }
  if (isEnabled(GL_FRAMEBUFFER_SRGB)) state->use.srgb = true;
}

bool drawsToWindow() {
  static const auto getIntegerv = real<decltype(&glGetIntegerv)>("glGetIntegerv");
  GLint bound = 0;
  getIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  return bound == 0;
}

/// A GL function's name as a template argument, so that each name gets a hook of its own.
template <std::size_t size> struct Name {
  char text[size];
  consteval Name(const char (&from)[size]) {
    std::copy_n(from, size, text);
  } // NOLINT(google-explicit-constructor)
};

/// Hook of a function that draws to (or clears) the bound draw framebuffer.
template <Name name, Use use, typename Function> struct Bound;
template <Name name, Use use, typename Result, typename... Arguments>
struct Bound<name, use, Result(Arguments...)> {
  static inline Result (*next)(Arguments...) = nullptr;
  static Result call(Arguments... arguments) {
    if (currentState()) count(use, drawsToWindow());
    return next(arguments...);
  }
};

/// Hook of a function whose first parameter names the framebuffer.
template <Name name, Use use, typename Function> struct Named;
template <Name name, Use use, typename Result, typename... Arguments>
struct Named<name, use, Result(GLuint, Arguments...)> {
  static inline Result (*next)(GLuint, Arguments...) = nullptr;
  static Result call(GLuint framebuffer, Arguments... arguments) {
    count(use, framebuffer == 0);
    return next(framebuffer, arguments...);
  }
};

/// glBlitNamedFramebuffer: the draw framebuffer comes second.
template <typename Function> struct NamedBlit;
template <typename... Arguments> struct NamedBlit<void(GLuint, GLuint, Arguments...)> {
  static inline void (*next)(GLuint, GLuint, Arguments...) = nullptr;
  static void call(GLuint from, GLuint to, Arguments... arguments) {
    count(Use::draw, to == 0);
    next(from, to, arguments...);
  }
};

#define GG_HOOK_OF(name, ...)                                                                                  \
  Hook {                                                                                                       \
#name, reinterpret_cast<GlFunction>(&__VA_ARGS__::call),                                                     \
        [](GlFunction function) {                                                                                \
          __VA_ARGS__::next = reinterpret_cast<decltype(__VA_ARGS__::next)>(function);                           \
        } \
  }
#define GG_DRAW(name) GG_HOOK_OF(name, Bound<#name, Use::draw, decltype(::name)>)
#define GG_CLEAR(name) GG_HOOK_OF(name, Bound<#name, Use::clear, decltype(::name)>)
#define GG_NAMED_CLEAR(name) GG_HOOK_OF(name, Named<#name, Use::clear, decltype(::name)>)

const Hook kHooks[] = {
    GG_DRAW(glDrawArrays),
    GG_DRAW(glDrawArraysEXT),
    GG_DRAW(glDrawArraysIndirect),
    GG_DRAW(glDrawArraysInstanced),
    GG_DRAW(glDrawArraysInstancedARB),
    GG_DRAW(glDrawArraysInstancedBaseInstance),
    GG_DRAW(glDrawArraysInstancedEXT),
    GG_DRAW(glDrawElements),
    GG_DRAW(glDrawElementsBaseVertex),
    GG_DRAW(glDrawElementsIndirect),
    GG_DRAW(glDrawElementsInstanced),
    GG_DRAW(glDrawElementsInstancedARB),
    GG_DRAW(glDrawElementsInstancedBaseInstance),
    GG_DRAW(glDrawElementsInstancedBaseVertex),
    GG_DRAW(glDrawElementsInstancedBaseVertexBaseInstance),
    GG_DRAW(glDrawElementsInstancedEXT),
    GG_DRAW(glDrawRangeElements),
    GG_DRAW(glDrawRangeElementsBaseVertex),
    GG_DRAW(glDrawRangeElementsEXT),
    GG_DRAW(glDrawTransformFeedback),
    GG_DRAW(glDrawTransformFeedbackInstanced),
    GG_DRAW(glDrawTransformFeedbackStream),
    GG_DRAW(glDrawTransformFeedbackStreamInstanced),
    GG_DRAW(glMultiDrawArrays),
    GG_DRAW(glMultiDrawArraysEXT),
    GG_DRAW(glMultiDrawArraysIndirect),
    GG_DRAW(glMultiDrawArraysIndirectAMD),
    GG_DRAW(glMultiDrawArraysIndirectCount),
    GG_DRAW(glMultiDrawArraysIndirectCountARB),
    GG_DRAW(glMultiDrawElements),
    GG_DRAW(glMultiDrawElementsBaseVertex),
    GG_DRAW(glMultiDrawElementsEXT),
    GG_DRAW(glMultiDrawElementsIndirect),
    GG_DRAW(glMultiDrawElementsIndirectAMD),
    GG_DRAW(glMultiDrawElementsIndirectCount),
    GG_DRAW(glMultiDrawElementsIndirectCountARB),
    GG_DRAW(glMultiModeDrawArraysIBM),
    GG_DRAW(glMultiModeDrawElementsIBM),
    // compatibility profile
    GG_DRAW(glBegin),
    GG_DRAW(glBitmap),
    GG_DRAW(glCallList),
    GG_DRAW(glCallLists),
    GG_DRAW(glCopyPixels),
    GG_DRAW(glDrawPixels),
    GG_DRAW(glEvalMesh1),
    GG_DRAW(glEvalMesh2),
    GG_DRAW(glRectd),
    GG_DRAW(glRectdv),
    GG_DRAW(glRectf),
    GG_DRAW(glRectfv),
    GG_DRAW(glRecti),
    GG_DRAW(glRectiv),
    GG_DRAW(glRects),
    GG_DRAW(glRectsv),
    // blits
    GG_DRAW(glBlitFramebuffer),
    GG_DRAW(glBlitFramebufferEXT),
    GG_HOOK_OF(glBlitNamedFramebuffer, NamedBlit<decltype(::glBlitNamedFramebuffer)>),
    // clears
    GG_CLEAR(glClear),
    GG_CLEAR(glClearBufferfi),
    GG_CLEAR(glClearBufferfv),
    GG_CLEAR(glClearBufferiv),
    GG_CLEAR(glClearBufferuiv),
    GG_NAMED_CLEAR(glClearNamedFramebufferfi),
    GG_NAMED_CLEAR(glClearNamedFramebufferfv),
    GG_NAMED_CLEAR(glClearNamedFramebufferiv),
    GG_NAMED_CLEAR(glClearNamedFramebufferuiv),
};

} // namespace

std::span<const Hook> windowUseHooks() {
  return kHooks;
}

} // namespace ggrade::capture
