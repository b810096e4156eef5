#pragma once
/// \file
/// One window: what the program asked for, what it is told, and its context.

#include "capture/context.hpp"
#include "capture/context_state.hpp"
#include "capture/glfw/hints.hpp"
#include "capture/run.hpp"

#include <GLFW/glfw3.h>

#include <array>
#include <atomic>
#include <chrono>
#include <memory>
#include <string>

struct GLFWwindow {
  ggrade::capture::WindowHints attributes;
  ggrade::capture::ContextHints contextAttributes;

  // Shared with the thread that draws, whose swap moves the schedule on.
  std::atomic<ggrade::capture::Size> asked{}; ///< what the program last asked for
  std::atomic<ggrade::capture::Size> size{};  ///< what it has; window and framebuffer are equal
  std::atomic<bool> isCurrent = false;        ///< the context, to any thread
  std::atomic<bool> shouldClose = false;
  // Callbacks that wait for the main thread.
  std::atomic<bool> sizeChanged = false;
  std::atomic<bool> closeAsked = false;
  std::atomic<bool> needsRefresh = true;

  std::string title;
  int x = 0;
  int y = 0;
  std::array<int, 4> limits{GLFW_DONT_CARE, GLFW_DONT_CARE, GLFW_DONT_CARE, GLFW_DONT_CARE};
  std::array<int, 2> aspect{GLFW_DONT_CARE, GLFW_DONT_CARE};
  float opacity = 1;
  bool iconified = false;
  GLFWmonitor* monitor = nullptr;
  void* userPointer = nullptr;

  // Input: nobody presses anything, but modes can be set and read.
  int cursorMode = GLFW_CURSOR_NORMAL;
  bool stickyKeys = false;
  bool stickyMouseButtons = false;
  bool lockKeyMods = false;
  bool rawMouseMotion = false;
  double cursorX = 0;
  double cursorY = 0;

  struct Callbacks {
    GLFWwindowposfun pos = nullptr;
    GLFWwindowsizefun size = nullptr;
    GLFWwindowclosefun close = nullptr;
    GLFWwindowrefreshfun refresh = nullptr;
    GLFWwindowfocusfun focus = nullptr;
    GLFWwindowiconifyfun iconify = nullptr;
    GLFWwindowmaximizefun maximize = nullptr;
    GLFWframebuffersizefun framebufferSize = nullptr;
    GLFWwindowcontentscalefun contentScale = nullptr;
    GLFWmousebuttonfun mouseButton = nullptr;
    GLFWcursorposfun cursorPos = nullptr;
    GLFWcursorenterfun cursorEnter = nullptr;
    GLFWscrollfun scroll = nullptr;
    GLFWkeyfun key = nullptr;
    GLFWcharfun character = nullptr;
    GLFWcharmodsfun charMods = nullptr;
    GLFWdropfun drop = nullptr;
  } callbacks;

  std::unique_ptr<ggrade::capture::Context> context;
  ggrade::capture::ContextState state;
  std::chrono::steady_clock::time_point lastSwap;
};

namespace ggrade::capture {

/// The window whose context is current to this thread, or null.
GLFWwindow* currentWindow();

/// Makes the window's context current to this thread; null makes none current. False on failure.
bool makeCurrent(GLFWwindow* window);

/// Takes the size to what the plan wants, or else the program. Callbacks wait for `deliverEvents`.
void updateSize(GLFWwindow& window);

/// True on the thread that called glfwInit, which alone gets callbacks.
bool onMainThread();

/// Calls the size callbacks that wait, on the main thread only. The window may be gone afterwards.
void deliverSize(GLFWwindow* window);

/// Calls all callbacks that wait, on the main thread only. The window may be gone afterwards.
void deliverEvents(GLFWwindow* window);

} // namespace ggrade::capture
