#include <gg/handle.hpp>

#include <stdexcept>
#include <vector>

#include "words/words.hpp"

namespace gg::detail {

namespace {

// Before there is a window, GL's functions are not loaded; calling one would crash.
void requireWindow(bool loaded, const char* what) {
  if (!loaded)
    throw std::logic_error(say("{} was made before the window; make the window first", what));
}

// Names of each kind start at another number: a texture's, taken for a framebuffer's, is none and
// not by chance the right one. What lies before is given away, once a context.
template <class Generate> GLuint generate(Generate function, GLuint first, const char* what) {
  requireWindow(function != nullptr, what);
  GLuint name = 0;
  function(1, &name);
  if (name >= first) return name;
  std::vector<GLuint> before(first - name);
  function(static_cast<GLsizei>(before.size()), before.data());
  return before.back();
}

} // namespace

GLuint TextureTraits::create() {
  return generate(glad_glGenTextures, 101, "a Texture");
}
void TextureTraits::destroy(GLuint name) {
  glDeleteTextures(1, &name);
}

GLuint RenderbufferTraits::create() {
  return generate(glad_glGenRenderbuffers, 201, "a Renderbuffer");
}
void RenderbufferTraits::destroy(GLuint name) {
  glDeleteRenderbuffers(1, &name);
}

GLuint FramebufferTraits::create() {
  return generate(glad_glGenFramebuffers, 301, "a Framebuffer");
}
void FramebufferTraits::destroy(GLuint name) {
  glDeleteFramebuffers(1, &name);
}

GLuint BufferTraits::create() {
  return generate(glad_glGenBuffers, 401, "a Buffer");
}
void BufferTraits::destroy(GLuint name) {
  glDeleteBuffers(1, &name);
}

GLuint VertexArrayTraits::create() {
  return generate(glad_glGenVertexArrays, 501, "a VertexArray");
}
void VertexArrayTraits::destroy(GLuint name) {
  glDeleteVertexArrays(1, &name);
}

GLuint SamplerTraits::create() {
  return generate(glad_glGenSamplers, 601, "a Sampler");
}
void SamplerTraits::destroy(GLuint name) {
  glDeleteSamplers(1, &name);
}

GLuint ProgramTraits::create() {
  requireWindow(glad_glCreateProgram != nullptr, "a Program");
  return glCreateProgram();
}
void ProgramTraits::destroy(GLuint name) {
  glDeleteProgram(name);
}

} // namespace gg::detail
