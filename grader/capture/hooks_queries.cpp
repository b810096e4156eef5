// What glGet* answers otherwise than the context: the program's own debug output, and a window that
// is double-buffered as GLFW's are.

#include "capture/context_state.hpp"
#include "capture/gl_hooks.hpp"

#include <type_traits>

namespace ggrade::capture {
namespace {

/// The window's one buffer under the name that the program gave it (hooks_window_buffers.cpp).
GLint programsName(GLint buffer) {
  return buffer == GL_FRONT || buffer == GL_FRONT_LEFT ? GL_BACK : buffer;
}

/// False, and `value` untouched, for everything that the context answers.
bool ownInteger(GLenum name, GLint& value) {
  const ContextState* const state = currentState();
  if (!state) return false;
  switch (name) {
  case GL_DOUBLEBUFFER:
    value = 1;
    return true;
  case GL_DRAW_BUFFER:
  case GL_DRAW_BUFFER0:
  case GL_READ_BUFFER:
    value = programsName(integer(name));
    return true;
  case GL_CONTEXT_FLAGS:
    value = integer(name) | (state->debug.debugContext ? GL_CONTEXT_FLAG_DEBUG_BIT : 0);
    return true;
  default:
    return debugInteger(state->debug, name, value);
  }
}

template <typename Value> using Getter = void(APIENTRY*)(GLenum, Value*);

/// One hook for each type that glGet* knows.
template <typename Value> struct Get {
  static inline Getter<Value> next = nullptr;
  static void APIENTRY call(GLenum name, Value* values) {
    GLint value = 0;
    if (!values || !ownInteger(name, value)) return next(name, values);
    // A boolean is whether the number is not 0, not its low byte.
    *values = std::is_same_v<Value, GLboolean> ? static_cast<Value>(value != 0)
                                               : static_cast<Value>(value);
  }
};

const Hook kQueryHooks[] = {
    GG_HOOK(glGetBooleanv, Get<GLboolean>::call, Get<GLboolean>::next),
    GG_HOOK(glGetDoublev, Get<GLdouble>::call, Get<GLdouble>::next),
    GG_HOOK(glGetFloatv, Get<GLfloat>::call, Get<GLfloat>::next),
    GG_HOOK(glGetInteger64v, Get<GLint64>::call, Get<GLint64>::next),
    GG_HOOK(glGetIntegerv, Get<GLint>::call, Get<GLint>::next),
};

} // namespace

std::span<const Hook> queryHooks() {
  return kQueryHooks;
}

} // namespace ggrade::capture
