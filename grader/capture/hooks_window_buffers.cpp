// A window offscreen has one colour buffer: whichever a program names is that one behind its back.

#include "capture/context.hpp"
#include "capture/context_state.hpp"
#include "capture/gl_hooks.hpp"

#include <vector>

namespace ggrade::capture {
namespace {

bool windowBound(GLenum binding) {
  static const auto getIntegerv = real<decltype(&glGetIntegerv)>("glGetIntegerv");
  GLint bound = 0;
  getIntegerv(binding, &bound);
  return bound == 0;
}

/// The window's buffer of that name.
GLenum windows(GLenum buffer) {
  const bool front = contextLibrary().windowBuffer() == GL_FRONT;
  switch (buffer) {
  case GL_FRONT:
  case GL_BACK:
    return front ? GL_FRONT : GL_BACK;
  case GL_FRONT_LEFT:
  case GL_BACK_LEFT:
    return front ? GL_FRONT_LEFT : GL_BACK_LEFT;
  case GL_FRONT_RIGHT:
  case GL_BACK_RIGHT:
    return front ? GL_FRONT_RIGHT : GL_BACK_RIGHT;
  default:
    return buffer;
  }
}

/// glDrawBuffers takes no GL_FRONT.
std::vector<GLenum> windows(GLsizei count, const GLenum* buffers) {
  std::vector<GLenum> result(buffers, buffers + count);
  for (GLenum& buffer : result)
    if (buffer != GL_FRONT) buffer = windows(buffer == GL_BACK ? GL_BACK_LEFT : buffer);
  return result;
}

decltype(&glDrawBuffer) nextDrawBuffer;
void APIENTRY hookDrawBuffer(GLenum buffer) {
  nextDrawBuffer(windowBound(GL_DRAW_FRAMEBUFFER_BINDING) ? windows(buffer) : buffer);
}

decltype(&glReadBuffer) nextReadBuffer;
void APIENTRY hookReadBuffer(GLenum buffer) {
  nextReadBuffer(windowBound(GL_READ_FRAMEBUFFER_BINDING) ? windows(buffer) : buffer);
}

decltype(&glDrawBuffers) nextDrawBuffers;
void APIENTRY hookDrawBuffers(GLsizei count, const GLenum* buffers) {
  if (count <= 0 || !windowBound(GL_DRAW_FRAMEBUFFER_BINDING))
    return nextDrawBuffers(count, buffers);
  nextDrawBuffers(count, windows(count, buffers).data());
}

decltype(&glNamedFramebufferDrawBuffer) nextNamedDrawBuffer;
void APIENTRY hookNamedDrawBuffer(GLuint framebuffer, GLenum buffer) {
  nextNamedDrawBuffer(framebuffer, framebuffer == 0 ? windows(buffer) : buffer);
}

decltype(&glNamedFramebufferReadBuffer) nextNamedReadBuffer;
void APIENTRY hookNamedReadBuffer(GLuint framebuffer, GLenum buffer) {
  nextNamedReadBuffer(framebuffer, framebuffer == 0 ? windows(buffer) : buffer);
}

decltype(&glNamedFramebufferDrawBuffers) nextNamedDrawBuffers;
void APIENTRY hookNamedDrawBuffers(GLuint framebuffer, GLsizei count, const GLenum* buffers) {
  if (count <= 0 || framebuffer != 0) return nextNamedDrawBuffers(framebuffer, count, buffers);
  nextNamedDrawBuffers(framebuffer, count, windows(count, buffers).data());
}

const Hook kWindowBufferHooks[] = {
    GG_HOOK(glDrawBuffer, hookDrawBuffer, nextDrawBuffer),
    GG_HOOK(glReadBuffer, hookReadBuffer, nextReadBuffer),
    GG_HOOK(glDrawBuffers, hookDrawBuffers, nextDrawBuffers),
    GG_HOOK(glNamedFramebufferDrawBuffer, hookNamedDrawBuffer, nextNamedDrawBuffer),
    GG_HOOK(glNamedFramebufferReadBuffer, hookNamedReadBuffer, nextNamedReadBuffer),
    GG_HOOK(glNamedFramebufferDrawBuffers, hookNamedDrawBuffers, nextNamedDrawBuffers),
};

} // namespace

std::span<const Hook> windowBufferHooks() {
  return kWindowBufferHooks;
}

} // namespace ggrade::capture
