#pragma once
/// \file
/// What the library keeps for each context beside GL's own state.

#include "capture/run.hpp"

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstdint>
#include <deque>
#include <memory>
#include <string>

namespace ggrade::capture {

namespace recorder {
struct Context;
}

/// Debug output as the program sees it; behind its back it is always on (hooks_debug.cpp).
struct DebugState {
  struct Logged {
    GLenum source, type;
    GLuint id;
    GLenum severity;
    std::string text;
  };
  bool debugContext = false; ///< GLFW_OPENGL_DEBUG_CONTEXT was asked for
  bool output = false;       ///< GL_DEBUG_OUTPUT
  bool synchronous = false;  ///< GL_DEBUG_OUTPUT_SYNCHRONOUS
  GLDEBUGPROC callback = nullptr;
  const void* userParam = nullptr;
  std::deque<Logged> log; ///< what glGetDebugMessageLog has yet to return
};

/// GL errors that were taken from GL behind the program's back (hooks_errors.cpp).
struct ErrorState {
  GLenum kept = GL_NO_ERROR; ///< what the program's next glGetError returns
  bool named = false;        ///< a debug message has told of the error that GL now holds
};

/// What reached the window since the last swap (hooks_draws.cpp).
struct WindowUse {
  std::uint32_t draws = 0;
  std::uint32_t clears = 0;
  bool srgb = false;
};

struct ContextState {
  DebugState debug;
  ErrorState errors;
  WindowUse use;
  Size windowSize;              ///< of the window's framebuffer
  std::uint32_t shareGroup = 0; ///< equal for contexts that share objects
  bool quiet = false;           ///< the library itself calls GL: messages are nobody's business
  std::shared_ptr<recorder::Context> recorder; ///< null until something is recorded
};

/// The calling thread's current context, or null.
ContextState* currentState();
void setCurrentState(ContextState* state);

/// Turns on debug output for a context that has just become current for the first time.
void installDebugCallback(ContextState& state);

/// The program's view of debug output for glGetIntegerv. False, and `value` untouched, for all
/// other names.
bool debugInteger(const DebugState& debug, GLenum name, GLint& value);

/// Collects an error that no debug message told of, and keeps it for the program. Returns the error
/// that GL held. The context must be current.
GLenum collectError(ContextState& state);

} // namespace ggrade::capture
