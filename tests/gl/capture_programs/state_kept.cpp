// Sets as much state as reading back could touch to odd values, draws pass after pass, and checks
// after each that the state is still so. Prints what has changed, and the errors and messages that
// it did not cause.
#include "recorded.hpp"

#include <array>
#include <vector>

namespace {

constexpr GLenum kIntegers[] = {
    GL_PACK_SWAP_BYTES,
    GL_PACK_LSB_FIRST,
    GL_PACK_ROW_LENGTH,
    GL_PACK_IMAGE_HEIGHT,
    GL_PACK_SKIP_ROWS,
    GL_PACK_SKIP_PIXELS,
    GL_PACK_SKIP_IMAGES,
    GL_PACK_ALIGNMENT,
    GL_UNPACK_ALIGNMENT,
    GL_UNPACK_ROW_LENGTH,
    GL_ACTIVE_TEXTURE,
    GL_TEXTURE_BINDING_2D,
    GL_RENDERBUFFER_BINDING,
    GL_PIXEL_PACK_BUFFER_BINDING,
    GL_PIXEL_UNPACK_BUFFER_BINDING,
    GL_UNIFORM_BUFFER_BINDING,
    GL_CLAMP_READ_COLOR,
    GL_SCISSOR_TEST,
    GL_FRAMEBUFFER_SRGB,
    GL_RASTERIZER_DISCARD,
    GL_DEPTH_WRITEMASK,
    GL_STENCIL_WRITEMASK,
    GL_CURRENT_PROGRAM,
    GL_VERTEX_ARRAY_BINDING,
    GL_SAMPLER_BINDING,
    GL_DEPTH_FUNC,
    GL_BLEND,
    GL_DEPTH_TEST,
    GL_STENCIL_TEST,
    GL_ARRAY_BUFFER_BINDING,
};

struct State {
  std::array<GLint, std::size(kIntegers)> integers{};
  GLint drawFramebuffer = 0, readFramebuffer = 0, drawBuffer = 0, readBuffer = 0;
  GLint scissor[4] = {}, viewport[4] = {};
  GLboolean colorMask[4] = {};
  GLint textures[4] = {};
};

State readState() {
  State state;
  for (std::size_t i = 0; i < std::size(kIntegers); ++i)
    glGetIntegerv(kIntegers[i], &state.integers[i]);
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &state.drawFramebuffer);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &state.readFramebuffer);
  glGetIntegerv(GL_DRAW_BUFFER, &state.drawBuffer);
  glGetIntegerv(GL_READ_BUFFER, &state.readBuffer);
  glGetIntegerv(GL_SCISSOR_BOX, state.scissor);
  glGetIntegerv(GL_VIEWPORT, state.viewport);
  glGetBooleanv(GL_COLOR_WRITEMASK, state.colorMask);
  return state;
}

void expectSame(const char* where, const State& before, const State& after) {
  for (std::size_t i = 0; i < std::size(kIntegers); ++i) {
    if (before.integers[i] != after.integers[i])
      std::printf("%s: %x was %x, is %x\n", where, kIntegers[i], before.integers[i],
                  after.integers[i]);
  }
  const auto same = [where](const char* what, const void* a, const void* b, std::size_t size) {
    if (std::memcmp(a, b, size) != 0) std::printf("%s: %s changed\n", where, what);
  };
  same("draw framebuffer", &before.drawFramebuffer, &after.drawFramebuffer, sizeof(GLint));
  same("read framebuffer", &before.readFramebuffer, &after.readFramebuffer, sizeof(GLint));
  same("draw buffer", &before.drawBuffer, &after.drawBuffer, sizeof(GLint));
  same("read buffer", &before.readBuffer, &after.readBuffer, sizeof(GLint));
  same("scissor", before.scissor, after.scissor, sizeof(before.scissor));
  same("viewport", before.viewport, after.viewport, sizeof(before.viewport));
  same("color mask", before.colorMask, after.colorMask, sizeof(before.colorMask));
}

void APIENTRY hear(GLenum, GLenum, GLuint id, GLenum, GLsizei, const char* text, const void*) {
  if (id != 99) std::printf("heard: %s\n", text);
}

/// A multisampled sRGB colour and a packed depth and stencil renderbuffer: reading them takes most.
GLuint multisampledFramebuffer() {
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  GLuint names[2];
  glGenRenderbuffers(2, names);
  const GLenum formats[] = {GL_SRGB8_ALPHA8, GL_DEPTH24_STENCIL8};
  const GLenum points[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_STENCIL_ATTACHMENT};
  for (int i = 0; i < 2; ++i) {
    glBindRenderbuffer(GL_RENDERBUFFER, names[i]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, formats[i], 8, 8);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, points[i], GL_RENDERBUFFER, names[i]);
  }
  return framebuffer;
}

} // namespace

int main() {
  GLFWwindow* const window = openLoadedWindow(8, 8);
  glDebugMessageCallback(hear, nullptr);
  glEnable(GL_DEBUG_OUTPUT);
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  const GLuint texture = makeTexture(GL_RGBA16F);
  const GLuint other = makeTexture(GL_RGBA8);
  const GLuint plain = makeFramebuffer(texture);
  glReadBuffer(GL_NONE);
  const GLuint multisampled = multisampledFramebuffer();
  const GLuint readFramebuffer = makeFramebuffer(other);
  GLuint buffers[3];
  glGenBuffers(3, buffers);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffers[0]);
  glBufferData(GL_PIXEL_PACK_BUFFER, 16, nullptr, GL_STREAM_READ);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffers[1]);
  glBindBuffer(GL_UNIFORM_BUFFER, buffers[2]);
  GLuint sampler = 0;
  glGenSamplers(1, &sampler);
  const GLuint program = textureProgram();
  glUseProgram(program);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, other);
  glActiveTexture(GL_TEXTURE3);
  glBindTexture(GL_TEXTURE_2D, texture);
  glBindSampler(3, sampler);
  glPixelStorei(GL_PACK_SWAP_BYTES, 1);
  glPixelStorei(GL_PACK_LSB_FIRST, 1);
  glPixelStorei(GL_PACK_ROW_LENGTH, 77);
  glPixelStorei(GL_PACK_IMAGE_HEIGHT, 55);
  glPixelStorei(GL_PACK_SKIP_ROWS, 5);
  glPixelStorei(GL_PACK_SKIP_PIXELS, 3);
  glPixelStorei(GL_PACK_SKIP_IMAGES, 2);
  glPixelStorei(GL_PACK_ALIGNMENT, 8);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 33);
  glClampColor(GL_CLAMP_READ_COLOR, GL_TRUE);
  glEnable(GL_SCISSOR_TEST);
  glScissor(2, 2, 3, 3);
  glViewport(1, 1, 6, 6);
  glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
  glStencilMask(0x55);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glEnable(GL_STENCIL_TEST);
  glEnable(GL_BLEND);
  while (!glfwWindowShouldClose(window)) {
    for (const GLuint framebuffer : {plain, multisampled, 0U}) {
      glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
      glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer == 0 ? plain : readFramebuffer);
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
      drawFull();
      const State before = readState();
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); // ends a pass: copies are made
      expectSame("clear", before, readState());
      drawFull();
      glDrawElements(GL_TRIANGLES, -1, GL_UNSIGNED_INT, nullptr); // the program's own error stays
      glDebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_MARKER, 99,
                           GL_DEBUG_SEVERITY_LOW, -1, "mine");
      drawFull();
      const GLenum error = glGetError();
      if (error != GL_INVALID_VALUE) std::printf("error %x\n", error);
      if (glGetError() != GL_NO_ERROR) std::printf("second error\n");
    }
    const State before = readState();
    glfwSwapBuffers(window);
    expectSame("swap", before, readState());
    if (const GLenum error = glGetError()) std::printf("error %x after the swap\n", error);
    glfwPollEvents();
  }
  std::printf("done\n");
}
