// OSMesa's window has a front buffer only. GL_BACK seems to work there, but glClearBuffer then
// clears nothing. So the window's back buffer is the front buffer behind the program's back.

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

GLenum front(GLenum buffer) {
  switch (buffer) {
  case GL_BACK:
    return GL_FRONT;
  case GL_BACK_LEFT:
    return GL_FRONT_LEFT;
  case GL_BACK_RIGHT:
    return GL_FRONT_RIGHT;
  default:
    return buffer;
  }
}

/// glDrawBuffers takes no GL_FRONT.
std::vector<GLenum> fronts(GLsizei count, const GLenum* buffers) {
  std::vector<GLenum> result(buffers, buffers + count);
  for (GLenum& buffer : result) {
    if (buffer == GL_BACK || buffer == GL_BACK_LEFT) buffer = GL_FRONT_LEFT;
  }
  return result;
}

decltype(&glDrawBuffer) nextDrawBuffer;
void APIENTRY hookDrawBuffer(GLenum buffer) {
  nextDrawBuffer(windowBound(GL_DRAW_FRAMEBUFFER_BINDING) ? front(buffer) : buffer);
}

decltype(&glReadBuffer) nextReadBuffer;
void APIENTRY hookReadBuffer(GLenum buffer) {
  nextReadBuffer(windowBound(GL_READ_FRAMEBUFFER_BINDING) ? front(buffer) : buffer);
}

decltype(&glDrawBuffers) nextDrawBuffers;
void APIENTRY hookDrawBuffers(GLsizei count, const GLenum* buffers) {
  if (count <= 0 || !windowBound(GL_DRAW_FRAMEBUFFER_BINDING))
    return nextDrawBuffers(count, buffers);
  nextDrawBuffers(count, fronts(count, buffers).data());
}

decltype(&glNamedFramebufferDrawBuffer) nextNamedDrawBuffer;
void APIENTRY hookNamedDrawBuffer(GLuint framebuffer, GLenum buffer) {
  nextNamedDrawBuffer(framebuffer, framebuffer == 0 ? front(buffer) : buffer);
}

decltype(&glNamedFramebufferReadBuffer) nextNamedReadBuffer;
void APIENTRY hookNamedReadBuffer(GLuint framebuffer, GLenum buffer) {
  nextNamedReadBuffer(framebuffer, framebuffer == 0 ? front(buffer) : buffer);
}

decltype(&glNamedFramebufferDrawBuffers) nextNamedDrawBuffers;
void APIENTRY hookNamedDrawBuffers(GLuint framebuffer, GLsizei count, const GLenum* buffers) {
  if (count <= 0 || framebuffer != 0) return nextNamedDrawBuffers(framebuffer, count, buffers);
  nextNamedDrawBuffers(framebuffer, count, fronts(count, buffers).data());
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
