#pragma once
/// \file
/// What most of the programs that the capture tests run begin with. They are ordinary GLFW
/// programs.

#include <cstdio>
#include <cstdlib>

#include <GLFW/glfw3.h>

inline GLFWwindow* openWindow(int width, int height, int profile = GLFW_OPENGL_CORE_PROFILE) {
  glfwSetErrorCallback(
      [](int code, const char* text) { std::fprintf(stderr, "GLFW %x: %s\n", code, text); });
  if (!glfwInit()) std::exit(10);
  if (profile == GLFW_OPENGL_CORE_PROFILE) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_OPENGL_PROFILE, profile);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  }
  GLFWwindow* const window = glfwCreateWindow(width, height, "capture", nullptr, nullptr);
  if (!window) std::exit(11);
  glfwMakeContextCurrent(window);
  return window;
}
