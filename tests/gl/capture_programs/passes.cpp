// One scenario for each rule of where passes and steps begin and end.
#include "recorded.hpp"

#include <chrono>
#include <thread>
#include <vector>

// Not in the loaded 4.1.
using ComputeFunction = void (*)(GLuint, GLuint, GLuint);
using BindImageFunction = void (*)(GLuint, GLuint, GLint, GLboolean, GLint, GLenum, GLenum);
using CopyImageFunction = void (*)(GLuint, GLenum, GLint, GLint, GLint, GLint, GLuint, GLenum,
                                   GLint, GLint, GLint, GLint, GLsizei, GLsizei, GLsizei);
template <typename Function> Function load(const char* name) {
  return reinterpret_cast<Function>(glfwGetProcAddress(name));
}

GLuint computeProgram() {
  const GLuint program = glCreateProgram();
  const GLuint shader = glCreateShader(0x91B9); // GL_COMPUTE_SHADER
  const char* const text = R"(#version 430 core
    layout(local_size_x = 8, local_size_y = 8) in;
    layout(rgba8, binding = 0) uniform writeonly image2D uImage;
    void main() { imageStore(uImage, ivec2(gl_GlobalInvocationID), vec4(0.2, 0.4, 0.6, 1)); })";
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  glAttachShader(program, shader);
  glLinkProgram(program);
  return program;
}

GLuint multisampledRenderbuffer() {
  GLuint renderbuffer = 0;
  glGenRenderbuffers(1, &renderbuffer);
  glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_RGBA8, 8, 8);
  return renderbuffer;
}

const Scenarios kScenarios = {
    // One framebuffer, three attachments one after another; the window, twice.
    {"attachments",
     [] {
       const GLuint a = makeTexture(GL_RGBA8);
       const GLuint b = makeTexture(GL_RGBA16F, 4);
       const GLuint framebuffer = makeFramebuffer(a);
       const GLuint program = plainProgram();
       return [=](int) {
         glUseProgram(program);
         glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
         attach(a);
         clearTo(0, 0, 0, 1);
         drawFull();
         attach(b);
         glViewport(0, 0, 4, 4);
         drawFull();
         attach(a);
         glViewport(0, 0, 8, 8);
         drawFull();
         glBindFramebuffer(GL_FRAMEBUFFER, 0);
         drawFull();
         glBindFramebuffer(GL_FRAMEBUFFER, framebuffer); // no draw: no pass
         glBindFramebuffer(GL_FRAMEBUFFER, 0);
         drawFull();
       };
     }},
    {"draw_buffers",
     [] {
       const GLuint a = makeTexture(GL_RGBA8);
       const GLuint b = makeTexture(GL_RGBA8);
       makeFramebuffer(a);
       attach(b, 0, GL_COLOR_ATTACHMENT2);
       const GLuint program = plainProgram();
       return [=](int) {
         glUseProgram(program);
         const GLenum first[] = {GL_COLOR_ATTACHMENT0};
         const GLenum second[] = {GL_NONE, GL_COLOR_ATTACHMENT2};
         const GLenum both[] = {GL_COLOR_ATTACHMENT2, GL_COLOR_ATTACHMENT0};
         glDrawBuffers(1, first);
         drawFull();
         glDrawBuffers(2, second);
         drawFull();
         glDrawBuffers(2, both);
         const float value[] = {1, 0, 0, 1};
         glClearBufferfv(GL_COLOR, 0, value);
       };
     }},
    // Two framebuffers with equal attachments are one place to draw to.
    {"same_images",
     [] {
       const GLuint a = makeTexture(GL_RGBA8);
       const GLuint first = makeFramebuffer(a);
       const GLuint second = makeFramebuffer(a);
       const GLuint program = plainProgram();
       return [=](int) {
         glUseProgram(program);
         glBindFramebuffer(GL_FRAMEBUFFER, first);
         drawFull();
         glBindFramebuffer(GL_FRAMEBUFFER, second);
         drawFull();
       };
     }},
    {"clears",
     [] {
       const GLuint program = plainProgram();
       return [=](int) {
         glUseProgram(program);
         glClearColor(0.1F, 0.2F, 0.3F, 0.4F);
         glClear(GL_COLOR_BUFFER_BIT);
         glClearDepth(0.5);
         glClear(GL_DEPTH_BUFFER_BIT);
         drawFull();
         glEnable(GL_SCISSOR_TEST);
         glScissor(0, 0, 4, 8);
         glClearStencil(7);
         glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
         glScissor(-1, -1, 20, 20);
         glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
         glDepthMask(GL_FALSE);
         glClear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
         glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
         glDepthMask(GL_TRUE);
         glDisable(GL_SCISSOR_TEST);
         glClear(0);
       };
     }},
    {"levels",
     [] {
       const GLuint texture = makeTexture(GL_RGBA8, 8, 3);
       const GLuint framebuffer = makeFramebuffer(texture);
       GLuint array = 0;
       glGenTextures(1, &array);
       glBindTexture(GL_TEXTURE_2D_ARRAY, array);
       glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA8, 8, 8, 3, 0, GL_RGBA, GL_FLOAT, nullptr);
       GLuint cube = 0;
       glGenTextures(1, &cube);
       glBindTexture(GL_TEXTURE_CUBE_MAP, cube);
       for (GLenum face = 0; face < 6; ++face)
         glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, 8, 8, 0, GL_RGBA,
                      GL_FLOAT, nullptr);
       return [=](int) {
         glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
         for (int level = 0; level < 3; ++level) {
           attach(texture, level);
           clearTo(static_cast<float>(level) / 5, 0, 0, 1);
         }
         for (int layer = 1; layer < 3; ++layer) {
           glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, array, 0, layer);
           clearTo(0, static_cast<float>(layer) / 5, 0, 1);
         }
         for (GLenum face : {2U, 5U}) {
           glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                  GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, cube, 0);
           clearTo(0, 0, static_cast<float>(face) / 5, 1);
         }
         glFramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, array, 0);
         clearTo(1, 1, 1, 1);
       };
     }},
    // A pass that takes long, though next to nothing is done in it.
    {"sleeps",
     [] {
       return [](int) {
         clearTo(0.2F, 0.4F, 0.6F, 1);
         std::this_thread::sleep_for(std::chrono::milliseconds(200));
         clearTo(0.6F, 0.4F, 0.2F, 1);
       };
     }},
    {"blit",
     [] {
       GLuint source = 0;
       glGenFramebuffers(1, &source);
       glBindFramebuffer(GL_FRAMEBUFFER, source);
       glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                 multisampledRenderbuffer());
       const GLuint texture = makeTexture(GL_RGBA8);
       const GLuint resolved = makeFramebuffer(texture);
       const GLuint program = textureProgram();
       return [=](int) {
         glBindFramebuffer(GL_FRAMEBUFFER, source);
         clearTo(0.2F, 0.4F, 0.6F, 1);
         glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved);
         glBlitFramebuffer(0, 0, 8, 8, 0, 8, 8, 0, GL_COLOR_BUFFER_BIT, GL_NEAREST);
         glBindFramebuffer(GL_FRAMEBUFFER, 0);
         glUseProgram(program);
         drawFull();
       };
     }},
    {"copies",
     [] {
       const GLuint from = makeTexture(GL_RGBA8);
       const GLuint framebuffer = makeFramebuffer(from);
       const GLuint to = makeTexture(GL_RGBA8);
       const GLuint third = makeTexture(GL_RGBA8);
       const auto copyImage = load<CopyImageFunction>("glCopyImageSubData");
       return [=](int) {
         glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
         clearTo(0.2F, 0.4F, 0.6F, 1);
         glBindTexture(GL_TEXTURE_2D, to);
         glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 8, 8);
         copyImage(to, GL_TEXTURE_2D, 0, 0, 0, 0, third, GL_TEXTURE_2D, 0, 0, 0, 0, 8, 8, 1);
         glBindFramebuffer(GL_FRAMEBUFFER, 0);
         glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 0, 0, 8, 8, 0);
         glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 8, 8, 0);
       };
     }},
    {"mipmap",
     [] {
       const GLuint texture = makeTexture(GL_RGBA8, 8, 4);
       const GLuint framebuffer = makeFramebuffer(texture);
       const GLuint program = textureProgram();
       return [=](int) {
         glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
         clearTo(0.2F, 0.4F, 0.6F, 1);
         glBindTexture(GL_TEXTURE_2D, texture);
         glGenerateMipmap(GL_TEXTURE_2D);
         glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 2);
         glBindFramebuffer(GL_FRAMEBUFFER, 0);
         glUseProgram(program);
         drawFull();
         glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 0);
       };
     }},
    {"compute",
     [] {
       const GLuint texture = makeTexture(GL_RGBA8);
       const GLuint compute = computeProgram();
       const GLuint program = textureProgram();
       const auto dispatch = load<ComputeFunction>("glDispatchCompute");
       const auto bindImage = load<BindImageFunction>("glBindImageTexture");
       const auto barrier = load<void (*)(GLbitfield)>("glMemoryBarrier");
       return [=](int) {
         glUseProgram(compute);
         bindImage(0, texture, 0, GL_FALSE, 0, 0x88B9, GL_RGBA8); // GL_WRITE_ONLY
         dispatch(1, 1, 1);
         barrier(0xffffffff);
         glUseProgram(program);
         glBindTexture(GL_TEXTURE_2D, texture);
         drawFull();
       };
     }},
    // What is uploaded while a pass goes on ends it only if it is drawn into.
    {"uploads",
     [] {
       const GLuint drawn = makeTexture(GL_RGBA8);
       const GLuint sampled = makeTexture(GL_RGBA8);
       const GLuint framebuffer = makeFramebuffer(drawn);
       const GLuint program = textureProgram();
       return [=](int) {
         const std::vector<unsigned char> pixels(4 * 64, 51);
         glUseProgram(program);
         glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
         clearTo(0.2F, 0.4F, 0.6F, 1);
         glBindTexture(GL_TEXTURE_2D, sampled);
         drawFull();
         glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
         drawFull();
         glBindTexture(GL_TEXTURE_2D, drawn);
         glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
         glBindTexture(GL_TEXTURE_2D, sampled);
         drawFull();
         glBindFramebuffer(GL_FRAMEBUFFER, 0);
         glBindTexture(GL_TEXTURE_2D, drawn);
         drawFull();
         glBindTexture(GL_TEXTURE_2D, drawn);
         glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
         drawFull();
       };
     }},
    // Made, drawn into and deleted in every frame; the name comes again for another image.
    {"deleted",
     [] {
       return [](int) {
         GLuint first = makeTexture(GL_RGBA8);
         GLuint framebuffer = makeFramebuffer(first);
         clearTo(0.2F, 0.4F, 0.6F, 1);
         glDeleteTextures(1, &first);
         glDeleteFramebuffers(1, &framebuffer);
         GLuint second = makeTexture(GL_RGBA16F, 4);
         framebuffer = makeFramebuffer(second);
         clearTo(2, 3, 4, 1);
         GLuint renderbuffer = 0;
         glGenRenderbuffers(1, &renderbuffer);
         glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
         glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 8, 8);
         glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                   renderbuffer);
         clearTo(1, 0, 0, 1);
         glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 4, 4);
         clearTo(0, 1, 0, 1);
         glDeleteRenderbuffers(1, &renderbuffer);
         glDeleteFramebuffers(1, &framebuffer);
         glDeleteTextures(1, &second);
         glBindFramebuffer(GL_FRAMEBUFFER, 0);
       };
     }},
    {"steps",
     [] {
       const GLuint first = plainProgram();
       const GLuint second = plainProgram();
       return [=](int) {
         glUseProgram(first);
         drawFull();
         glDrawArrays(GL_LINES, 0, 2); // another mode is no other step
         glDrawArraysInstanced(GL_TRIANGLES, 0, 3, 5);
         glUseProgram(second);
         drawFull();
         glEnable(GL_DEPTH_TEST);
         glDepthFunc(GL_LEQUAL);
         drawFull();
         glDepthMask(GL_FALSE);
         drawFull();
         glEnable(GL_BLEND);
         glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE, GL_ZERO, GL_DST_ALPHA);
         glBlendEquationSeparate(GL_FUNC_SUBTRACT, GL_MAX);
         glBlendColor(0.1F, 0.2F, 0.3F, 0.4F);
         drawFull();
         glEnable(GL_CULL_FACE);
         glCullFace(GL_FRONT);
         glFrontFace(GL_CW);
         drawFull();
         glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
         drawFull();
         glEnable(GL_STENCIL_TEST);
         glStencilFuncSeparate(GL_FRONT, GL_EQUAL, 3, 0x0f);
         glStencilFuncSeparate(GL_BACK, GL_NOTEQUAL, 4, 0xf0);
         glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_INCR_WRAP, GL_REPLACE);
         glStencilOpSeparate(GL_BACK, GL_ZERO, GL_DECR_WRAP, GL_INVERT);
         glStencilMaskSeparate(GL_FRONT, 0x3f);
         drawFull();
         glViewport(1, 2, 3, 4);
         glEnable(GL_SCISSOR_TEST);
         glScissor(2, 3, 4, 5);
         drawFull();
         glEnable(GL_CLIP_DISTANCE1);
         glEnable(GL_POLYGON_OFFSET_FILL);
         glPolygonOffset(1.5F, 4);
         glEnable(GL_DEPTH_CLAMP);
         drawFull();
         glEnable(GL_RASTERIZER_DISCARD);
         drawFull();
         for (const GLenum name :
              {GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE, GL_STENCIL_TEST, GL_SCISSOR_TEST,
               GL_CLIP_DISTANCE1, GL_POLYGON_OFFSET_FILL, GL_DEPTH_CLAMP, GL_RASTERIZER_DISCARD})
           glDisable(name);
         glDepthMask(GL_TRUE);
         glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
         glBlendFunc(GL_ONE, GL_ZERO);
         glBlendEquation(GL_FUNC_ADD);
         glBlendColor(0, 0, 0, 0);
         glFrontFace(GL_CCW);
         glCullFace(GL_BACK);
         glViewport(0, 0, 8, 8);
       };
     }},
};

int main(int argc, char** argv) {
  return runScenario(kScenarios, argc, argv);
}
