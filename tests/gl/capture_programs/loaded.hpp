#pragma once
/// \file
/// A window whose GL functions glad loads, and a program from two shader texts.

#include <glad/gl.h>

#include "open_window.hpp"

inline GLFWwindow* openLoadedWindow(int width, int height) {
  GLFWwindow* const window = openWindow(width, height);
  if (!gladLoadGL(glfwGetProcAddress)) std::exit(12);
  gladUninstallGLDebug(); // calls nothing but what the program calls
  return window;
}

inline GLuint makeProgram(const char* vertex, const char* fragment) {
  const GLuint program = glCreateProgram();
  const auto add = [program](GLenum kind, const char* text) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) std::exit(13);
    glAttachShader(program, shader);
  };
  add(GL_VERTEX_SHADER, vertex);
  add(GL_FRAGMENT_SHADER, fragment);
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (!linked) std::exit(14);
  return program;
}
