// Draws into textures that the judging side puts other pixels into, and into the window what it
// then samples from them.
#include "recorded.hpp"

#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <vector>

namespace {

GLuint makeLayered(GLenum target) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(target, texture);
  if (target == GL_TEXTURE_CUBE_MAP) {
    for (GLenum face = 0; face < 6; ++face)
      glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, 8, 8, 0, GL_RGBA,
                   GL_UNSIGNED_BYTE, nullptr);
  } else {
    glTexImage3D(target, 0, GL_RGBA8, 8, 8, 3, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  }
  return texture;
}

Frame clearsOneImage(GLenum target, bool whole) {
  const GLuint texture = makeLayered(target);
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  return [=](int) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    // Two layers, each in a pass of its own; the second one is the one that is replaced.
    for (const int layer : {2, 1}) {
      if (whole)
        glFramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture, 0);
      else if (target == GL_TEXTURE_CUBE_MAP)
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                               GL_TEXTURE_CUBE_MAP_POSITIVE_X + GLenum(layer), texture, 0);
      else
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture, 0, layer);
      clearTo(0.2F, 0.4F, 0.6F, 1);
      drawFull();
    }
  };
}

/// Sets pixel-store state that no upload of ours may follow, and says what of it is no more so.
class OddState {
public:
  OddState() {
    glGenBuffers(1, &buffer_);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer_);
    glBufferData(GL_PIXEL_UNPACK_BUFFER, 1 << 16, nullptr, GL_STREAM_DRAW);
    for (const auto& [name, value] : kOdd) glPixelStorei(name, value);
  }
  void expectKept() const {
    for (const auto& [name, value] : kOdd) {
      GLint now = 0;
      glGetIntegerv(name, &now);
      if (now != value) std::printf("%x is %d instead of %d\n", name, now, value);
    }
    GLint buffer = 0;
    glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &buffer);
    if (GLuint(buffer) != buffer_) std::printf("another unpack buffer: %d\n", buffer);
    if (const GLenum error = glGetError()) std::printf("error %x\n", error);
  }

private:
  static constexpr std::pair<GLenum, GLint> kOdd[] = {
      {GL_UNPACK_SWAP_BYTES, 1},    {GL_UNPACK_LSB_FIRST, 1}, {GL_UNPACK_ROW_LENGTH, 21},
      {GL_UNPACK_IMAGE_HEIGHT, 19}, {GL_UNPACK_SKIP_ROWS, 3}, {GL_UNPACK_SKIP_PIXELS, 5},
      {GL_UNPACK_SKIP_IMAGES, 1},   {GL_UNPACK_ALIGNMENT, 8}, {GL_PACK_SWAP_BYTES, 1},
      {GL_PACK_ROW_LENGTH, 33},     {GL_PACK_SKIP_ROWS, 2},   {GL_PACK_ALIGNMENT, 8}};
  GLuint buffer_ = 0;
};

GLuint depthTexture(GLenum format) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  const bool packed = format == GL_DEPTH24_STENCIL8;
  glTexImage2D(GL_TEXTURE_2D, 0, GLint(format), 8, 8, 0,
               packed ? GL_DEPTH_STENCIL : GL_DEPTH_COMPONENT,
               packed ? GL_UNSIGNED_INT_24_8 : GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

const Scenarios kScenarios = {
    // A colour texture, then the window from it, in two frames.
    {"sampled",
     []() -> Frame {
       const GLuint texture = makeTexture(GL_RGBA8);
       const GLuint framebuffer = makeFramebuffer(texture);
       const GLuint plain = plainProgram(), sampling = textureProgram();
       return [=](int) {
         glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
         glUseProgram(plain);
         drawFull();
         glBindFramebuffer(GL_FRAMEBUFFER, 0);
         glUseProgram(sampling);
         drawFull();
       };
     }},
    // The same with odd state, for a depth texture with stencil as well.
    {"odd_state",
     []() -> Frame {
       const GLuint color = makeTexture(GL_RGBA16F);
       const GLuint depth = depthTexture(GL_DEPTH24_STENCIL8);
       const GLuint framebuffer = makeFramebuffer(color);
       glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
       const GLuint sampling = textureProgram();
       const OddState state;
       return [=](int) {
         glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
         glClearStencil(77);
         glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
         glBindFramebuffer(GL_FRAMEBUFFER, 0);
         glUseProgram(sampling);
         glBindTexture(GL_TEXTURE_2D, color);
         drawFull();
         state.expectKept();
         GLint bound = 0;
         glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
         if (GLuint(bound) != color) std::printf("another texture is bound: %d\n", bound);
       };
     }},
    {"level",
     []() -> Frame {
       const GLuint texture = makeTexture(GL_RGBA8, 16, 2);
       const GLuint framebuffer = makeFramebuffer(texture, 1);
       return [=](int) {
         glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
         clearTo(0, 0, 0, 0);
       };
     }},
    {"array", [] { return clearsOneImage(GL_TEXTURE_2D_ARRAY, false); }},
    {"cube", [] { return clearsOneImage(GL_TEXTURE_CUBE_MAP, false); }},
    {"whole_array", [] { return clearsOneImage(GL_TEXTURE_2D_ARRAY, true); }},
};

} // namespace

int main(int argc, char** argv) {
  return runScenario(kScenarios, argc, argv);
}
