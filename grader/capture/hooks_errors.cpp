// A GL error is reported by its debug message. A program can switch messages off
// (glDebugMessageControl); then the error flag still tells that something went wrong. Reading the
// flag clears it, so what we read is kept for the program's own glGetError.

#include "capture/channel_writer.hpp"
#include "capture/context_state.hpp"
#include "capture/gl_hooks.hpp"

#include <string>

namespace ggrade::capture {
namespace {

const char* errorName(GLenum error) {
  switch (error) {
  case GL_INVALID_ENUM:
    return "GL_INVALID_ENUM";
  case GL_INVALID_VALUE:
    return "GL_INVALID_VALUE";
  case GL_INVALID_OPERATION:
    return "GL_INVALID_OPERATION";
  case GL_INVALID_FRAMEBUFFER_OPERATION:
    return "GL_INVALID_FRAMEBUFFER_OPERATION";
  case GL_OUT_OF_MEMORY:
    return "GL_OUT_OF_MEMORY";
  case GL_STACK_OVERFLOW:
    return "GL_STACK_OVERFLOW";
  case GL_STACK_UNDERFLOW:
    return "GL_STACK_UNDERFLOW";
  default:
    return "an unknown GL error";
  }
}

GLenum realError() {
  static const auto getError = real<decltype(&glGetError)>("glGetError");
  return getError();
}

/// GL's flag, cleared. An error without a debug message is reported here.
GLenum takeError(ContextState& state) {
  const GLenum error = realError();
  if (error != GL_NO_ERROR && !state.errors.named) {
    writeMessage(channel::MessageKind::glError,
                 std::string(errorName(error)) +
                     " in a call of this frame (the program has switched debug messages off)");
  }
  state.errors.named = false;
  return error;
}

GLenum APIENTRY hookGetError() {
  ContextState* const state = currentState();
  if (!state) return realError();
  const GLenum error = takeError(*state);
  const GLenum kept = state->errors.kept;
  state->errors.kept = GL_NO_ERROR;
  return kept != GL_NO_ERROR ? kept : error; // one flag: the first error stays until it is read
}

const Hook kErrorHooks[] = {{"glGetError", reinterpret_cast<GlFunction>(hookGetError), nullptr}};

} // namespace

std::span<const Hook> errorHooks() {
  return kErrorHooks;
}

GLenum collectError(ContextState& state) {
  const GLenum error = takeError(state);
  if (state.errors.kept == GL_NO_ERROR) state.errors.kept = error;
  return error;
}

} // namespace ggrade::capture
