#pragma once
/// \file
/// What the programs whose passes are recorded share: textures, framebuffers, small shaders, and a
/// loop that draws the scenario named on the command line.

#include "loaded.hpp"

#include <cstring>
#include <functional>
#include <map>
#include <string>

inline constexpr char kFullScreen[] = R"(#version 410 core
  uniform mat4 uMatrix = mat4(1);
  void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1);
    gl_Position = uMatrix * vec4(corner, 0.5, 1);
  })";

/// Draws uColor everywhere.
inline GLuint plainProgram() {
  return makeProgram(kFullScreen, R"(#version 410 core
    uniform vec4 uColor = vec4(0.25, 0.5, 0.75, 1);
    out vec4 oColor;
    void main() { oColor = uColor; })");
}

/// Draws uTexture everywhere.
inline GLuint textureProgram() {
  return makeProgram(kFullScreen, R"(#version 410 core
    uniform sampler2D uTexture;
    out vec4 oColor;
    void main() { oColor = texture(uTexture, gl_FragCoord.xy / vec2(8)); })");
}

inline GLuint makeTexture(GLenum format, int size = 8, int levels = 1) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  const bool depth = format == GL_DEPTH_COMPONENT24 || format == GL_DEPTH_COMPONENT16 ||
                     format == GL_DEPTH_COMPONENT32F;
  for (int level = 0; level < levels; ++level)
    glTexImage2D(GL_TEXTURE_2D, level, static_cast<GLint>(format), size >> level, size >> level, 0,
                 depth ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, levels - 1);
  return texture;
}

inline GLuint makeFramebuffer(GLuint color, GLint level = 0) {
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, level);
  return framebuffer;
}

inline void attach(GLuint texture, GLint level = 0, GLenum point = GL_COLOR_ATTACHMENT0) {
  glFramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, texture, level);
}

inline void drawFull() {
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

inline void clearTo(float red, float green, float blue, float alpha) {
  glClearColor(red, green, blue, alpha);
  glClear(GL_COLOR_BUFFER_BIT);
}

/// A scenario sets up, and returns what draws a frame (its number is the argument).
using Frame = std::function<void(int)>;
using Scenarios = std::map<std::string, std::function<Frame()>>;

inline int runScenario(const Scenarios& scenarios, int argc, char** argv) {
  GLFWwindow* const window = openLoadedWindow(8, 8);
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  const auto scenario = scenarios.find(argc > 1 ? argv[1] : "");
  if (scenario == scenarios.end()) return 15;
  const Frame frame = scenario->second();
  for (int i = 0; !glfwWindowShouldClose(window); ++i) {
    frame(i);
    glfwSwapBuffers(window);
    glfwPollEvents();
  }
  return 0;
}
