#pragma once
/// \file
/// What glfwWindowHint sets, with GLFW's defaults.

#include <GLFW/glfw3.h>

namespace ggrade::capture {

struct WindowHints {
  bool resizable = true;
  bool visible = true;
  bool decorated = true;
  bool focused = true;
  bool autoIconify = true;
  bool floating = false;
  bool maximized = false;
  bool focusOnShow = true;
  bool transparent = false;
};

struct ContextHints {
  int client = GLFW_OPENGL_API;
  int source = GLFW_NATIVE_CONTEXT_API;
  int major = 1;
  int minor = 0;
  int profile = GLFW_OPENGL_ANY_PROFILE;
  int robustness = GLFW_NO_ROBUSTNESS;
  int release = GLFW_ANY_RELEASE_BEHAVIOR;
  bool forward = false;
  bool debug = false;
  bool noError = false;
};

struct FramebufferHints {
  int depthBits = 24;
  int stencilBits = 8;
  int samples = 0;
  bool stereo = false;
  bool srgb = false;
  bool doubleBuffer = true;
};

struct Hints {
  WindowHints window;
  ContextHints context;
  FramebufferHints framebuffer;
};

} // namespace ggrade::capture
