// What a program may do that would be hard on a recorder, one scenario each.
#include "recorded.hpp"

#include <thread>
#include <vector>

const Scenarios kScenarios = {
    {"incomplete",
     [] {
       const GLuint empty = 0;
       GLuint framebuffer = 0;
       glGenFramebuffers(1, &framebuffer);
       const GLuint program = plainProgram();
       GLuint unsized = 0;
       glGenTextures(1, &unsized);
       glBindTexture(GL_TEXTURE_2D, unsized);
       return [=](int) {
         glUseProgram(program);
         glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
         clearTo(1, 0, 0, 1);
         drawFull();
         glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, unsized, 0);
         drawFull();
         glBlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
         glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, empty, 0);
         glBindFramebuffer(GL_FRAMEBUFFER, 0);
         drawFull();
       };
     }},
    {"many",
     [] {
       const GLuint a = makeTexture(GL_RGBA8);
       const GLuint b = makeTexture(GL_RGBA8);
       makeFramebuffer(a);
       const GLuint program = plainProgram();
       return [=](int) {
         glUseProgram(program);
         for (int i = 0; i < 10000; ++i) {
           attach(i % 2 ? a : b);
           drawFull();
         }
       };
     }},
    // More steps, sampled textures and matrices than the tables hold, in one pass.
    {"many_steps",
     [] {
       const GLuint program = makeProgram(kFullScreen, R"(#version 410 core
         uniform sampler2D uMaps[3];
         out vec4 oColor;
         void main() {
           oColor = texture(uMaps[0], vec2(0)) + texture(uMaps[1], vec2(0)) + texture(uMaps[2], vec2(0));
         })");
       const GLint matrix = glGetUniformLocation(program, "uMatrix");
       return [=](int) {
         glUseProgram(program);
         for (int i = 0; i < 9000; ++i) {
           glViewport(0, 0, 1 + i % 7, 1);
           for (int k = 0; k < 5; ++k) {
             const float values[16] = {static_cast<float>(5 * i + k)};
             glUniformMatrix4fv(matrix, 1, GL_FALSE, values);
             drawFull();
           }
         }
       };
     }},
    {"bones",
     [] {
       const GLuint program = makeProgram(R"(#version 410 core
         uniform mat4 uBones[60];
         void main() {
           vec4 sum = vec4(0);
           for (int i = 0; i < 60; ++i) sum += uBones[i][0];
           gl_Position = sum;
         })",
                                          R"(#version 410 core
         out vec4 oColor;
         void main() { oColor = vec4(1); })");
       return [=](int) {
         glUseProgram(program);
         for (int i = 0; i < 10; ++i) {
           std::vector<float> values(60 * 16, static_cast<float>(i));
           glUniformMatrix4fv(glGetUniformLocation(program, "uBones"), 60, GL_FALSE, values.data());
           drawFull();
         }
       };
     }},
    {"huge",
     [] {
       GLuint texture = 0;
       glGenTextures(1, &texture);
       glBindTexture(GL_TEXTURE_2D, texture);
       glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, 16384, 16384, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
       const GLuint framebuffer = makeFramebuffer(texture);
       return [=](int) {
         glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
         glEnable(GL_SCISSOR_TEST);
         glScissor(0, 0, 4, 4);
         clearTo(1, 0, 0, 1);
         glDisable(GL_SCISSOR_TEST);
         glBindFramebuffer(GL_FRAMEBUFFER, 0);
         clearTo(0, 1, 0, 1);
       };
     }},
    // The framebuffer, then its texture, go while they are in use.
    {"deleted_in_use",
     [] {
       const GLuint program = plainProgram();
       return [=](int) {
         glUseProgram(program);
         GLuint texture = makeTexture(GL_RGBA8);
         GLuint framebuffer = makeFramebuffer(texture);
         clearTo(0.2F, 0.4F, 0.6F, 1);
         glDeleteFramebuffers(1, &framebuffer); // now the window is bound
         drawFull();
         framebuffer = makeFramebuffer(texture);
         drawFull();
         glDeleteTextures(1, &texture); // detached from the bound framebuffer
         drawFull();
         texture = makeTexture(GL_RGBA8);
         framebuffer = makeFramebuffer(texture);
         glBindFramebuffer(GL_FRAMEBUFFER, 0);
         glDeleteTextures(1, &texture); // stays attached to the other framebuffer
         glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
         drawFull();
         glDeleteFramebuffers(1, &framebuffer);
         GLuint gone = plainProgram();
         glUseProgram(gone);
         glDeleteProgram(gone);
         drawFull();
         glUseProgram(0);
         drawFull();
       };
     }},
    {"srgb_target",
     [] {
       const GLuint program = plainProgram();
       const GLuint framebuffer = makeFramebuffer(makeTexture(GL_SRGB8_ALPHA8));
       return [=](int) {
         glUseProgram(program);
         glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
         glEnable(GL_FRAMEBUFFER_SRGB);
         drawFull();
         glDisable(GL_FRAMEBUFFER_SRGB);
         glBindFramebuffer(GL_FRAMEBUFFER, 0);
       };
     }},
    {"nonsense",
     [] {
       const GLuint program = textureProgram();
       glUseProgram(program);
       glUniform1i(glGetUniformLocation(program, "uTexture"), 79);
       const GLuint texture = makeTexture(GL_RGBA8);
       return [=](int) {
         glUseProgram(program);
         glBindTexture(GL_TEXTURE_2D, texture);
         glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 0x7fffffff);
         drawFull();
         glDrawArrays(0xdead, 0, 3);
         glDrawArrays(GL_TRIANGLES, -1, -3);
         glDrawElements(GL_TRIANGLES, 3, 0xdead, nullptr);
         glClear(0xffffffff);
         glClearBufferfv(0xdead, 99, nullptr);
         const float value[4] = {};
         glClearBufferfv(GL_COLOR, 99, value);
         glBlitFramebuffer(0, 0, -2147483647 - 1, 2147483647, 2147483647, -2147483647 - 1, 1, 1,
                           0xffffffff, 0xdead);
         glCopyTexSubImage2D(0xdead, -5, 0, 0, 0, 0, -1, -1);
         glCopyTexSubImage2D(GL_TEXTURE_2D, 99, 0, 0, 0, 0, 4, 4);
         glGenerateMipmap(0xdead);
         glGenerateMipmap(GL_TEXTURE_2D);
         glDeleteTextures(-1, nullptr);
         glLinkProgram(12345);
         glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 0);
         glTexImage2D(GL_TEXTURE_2D, -1, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_FLOAT, nullptr);
       };
     }},
    // One texture, drawn into by a context on a thread of its own while this one samples it.
    {"threads",
     [] {
       const GLuint texture = makeTexture(GL_RGBA8);
       const GLuint program = textureProgram();
       GLFWwindow* const main = glfwGetCurrentContext();
       glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
       GLFWwindow* const second = glfwCreateWindow(8, 8, "second", nullptr, main);
       return [=](int) {
         std::thread other([=] {
           glfwMakeContextCurrent(second);
           GLuint framebuffer = makeFramebuffer(texture);
           for (int i = 0; i < 200; ++i) clearTo(static_cast<float>(i) / 200, 0, 0, 1);
           glDeleteFramebuffers(1, &framebuffer);
           glfwMakeContextCurrent(nullptr);
         });
         glUseProgram(program);
         glBindTexture(GL_TEXTURE_2D, texture);
         for (int i = 0; i < 200; ++i) {
           glViewport(0, 0, 1 + i % 8, 8);
           drawFull();
         }
         other.join();
         glViewport(0, 0, 8, 8);
       };
     }},
    // Two contexts that share objects, one thread.
    {"contexts",
     [] {
       const GLuint texture = makeTexture(GL_RGBA8);
       GLFWwindow* const main = glfwGetCurrentContext();
       glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
       GLFWwindow* const second = glfwCreateWindow(4, 4, "second", nullptr, main);
       glfwMakeContextCurrent(second);
       const GLuint framebuffer = makeFramebuffer(texture);
       glBindFramebuffer(GL_FRAMEBUFFER, 0);
       glfwMakeContextCurrent(main);
       const GLuint program = textureProgram();
       return [=](int) {
         clearTo(0.2F, 0.4F, 0.6F, 1);
         glfwMakeContextCurrent(second);
         clearTo(1, 0, 0, 1);
         glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
         clearTo(0, 1, 0, 1);
         glBindFramebuffer(GL_FRAMEBUFFER, 0);
         glfwMakeContextCurrent(main);
         glUseProgram(program);
         glBindTexture(GL_TEXTURE_2D, texture);
         drawFull();
       };
     }},
};

int main(int argc, char** argv) {
  return runScenario(kScenarios, argc, argv);
}
