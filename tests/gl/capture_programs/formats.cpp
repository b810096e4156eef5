// Clears one image after another to values that every format's copy can be compared with:
//   color FORMAT KIND a b c d     KIND f, i, u
//   depth FORMAT d | depth_stencil FORMAT d s
// all of them given as arguments, as a texture or (before them: "renderbuffer", "multisampled",
// "multisampled_texture") otherwise. 16 x 8 pixels; the upper half is cleared to half the values.
#include "recorded.hpp"

#include <cmath>
#include <cstdlib>
#include <vector>

namespace {

constexpr int kWidth = 16;
constexpr int kHeight = 8;

enum class Holder { texture, renderbuffer, multisampled, multisampledTexture };

void attachImage(Holder holder, GLenum format, GLenum point) {
  GLuint name = 0;
  if (holder == Holder::renderbuffer || holder == Holder::multisampled) {
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, holder == Holder::multisampled ? 4 : 0,
                                     format, kWidth, kHeight);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, name);
    return;
  }
  glGenTextures(1, &name);
  if (holder == Holder::multisampledTexture) {
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, name);
    glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, 4, format, kWidth, kHeight, GL_TRUE);
    glFramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D_MULTISAMPLE, name, 0);
    return;
  }
  const auto storage = reinterpret_cast<void (*)(GLenum, GLsizei, GLenum, GLsizei, GLsizei)>(
      glfwGetProcAddress("glTexStorage2D"));
  glBindTexture(GL_TEXTURE_2D, name);
  storage(GL_TEXTURE_2D, 1, format, kWidth, kHeight);
  glFramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, name, 0);
}

void half(bool upper) {
  glScissor(0, upper ? kHeight / 2 : 0, kWidth, kHeight / 2);
}

} // namespace

int main(int argc, char** argv) {
  GLFWwindow* const window = openLoadedWindow(8, 8);
  int at = 1;
  const auto next = [&] { return at < argc ? argv[at++] : const_cast<char*>(""); };
  const auto number = [&] { return std::strtod(next(), nullptr); };
  Holder holder = Holder::texture;
  glEnable(GL_SCISSOR_TEST);
  while (at < argc) {
    const std::string word = next();
    if (word == "texture") holder = Holder::texture;
    if (word == "renderbuffer") holder = Holder::renderbuffer;
    if (word == "multisampled") holder = Holder::multisampled;
    if (word == "multisampled_texture") holder = Holder::multisampledTexture;
    if (word != "color" && word != "depth" && word != "depth_stencil") continue;
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    const auto format = static_cast<GLenum>(std::strtoul(next(), nullptr, 0));
    if (word == "color") {
      attachImage(holder, format, GL_COLOR_ATTACHMENT0);
      const char kind = next()[0];
      double values[4];
      for (double& value : values) value = number();
      for (const bool upper : {false, true}) {
        half(upper);
        const double scale = upper ? 0.5 : 1;
        float floats[4];
        GLint integers[4];
        GLuint naturals[4];
        for (int i = 0; i < 4; ++i) {
          floats[i] = static_cast<float>(values[i] * scale);
          integers[i] = kind == 'i' ? static_cast<GLint>(values[i] * scale) : 0;
          naturals[i] = kind == 'u' ? static_cast<GLuint>(values[i] * scale) : 0;
        }
        if (kind == 'f') glClearBufferfv(GL_COLOR, 0, floats);
        if (kind == 'i') glClearBufferiv(GL_COLOR, 0, integers);
        if (kind == 'u') glClearBufferuiv(GL_COLOR, 0, naturals);
      }
    } else {
      glDrawBuffer(GL_NONE);
      glReadBuffer(GL_NONE);
      const bool packed = word == "depth_stencil";
      attachImage(holder, format, packed ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT);
      const double depth = number();
      const double stencil = packed ? number() : 0;
      for (const bool upper : {false, true}) {
        half(upper);
        const double scale = upper ? 0.5 : 1;
        glClearDepth(depth * scale);
        glClearStencil(static_cast<GLint>(stencil * scale));
        glClear(GL_DEPTH_BUFFER_BIT | (packed ? GL_STENCIL_BUFFER_BIT : 0U));
      }
    }
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return 20;
  }
  glfwSwapBuffers(window);
  return glGetError() == GL_NO_ERROR ? 0 : 21;
}
