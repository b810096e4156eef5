#pragma once
/// \file
/// State that GLFW's functions share. Windows, cursors and hints live from glfwInit to
/// glfwTerminate. As in GLFW, all but the context, time and error functions belong to the main
/// thread.

#include "capture/glfw/hints.hpp"
#include "capture/glfw/window.hpp"

#include <GLFW/glfw3.h>

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

struct GLFWcursor {};

namespace ggrade::capture {

struct Library {
  bool initialised = false;
  Hints hints;
  std::vector<std::unique_ptr<GLFWwindow>> windows;
  std::vector<std::unique_ptr<GLFWcursor>> cursors;
  std::atomic<GLFWwindow*> captured = nullptr; ///< the window whose frames are handed over
  std::string clipboard;
  std::thread::id mainThread;

  bool has(const GLFWwindow* window) const;
};

Library& library();

/// Stores the error for glfwGetError and calls the program's error callback. Any thread.
[[gnu::format(printf, 2, 3)]] void reportError(int code, const char* format, ...);

/// False after reporting GLFW_NOT_INITIALIZED.
bool requireInit();

/// Forgets the monitor's user pointer, gamma ramp and callback (glfwTerminate).
void resetMonitor();

/// Exchanges a callback, as all of GLFW's setters do.
template <typename Callback> Callback exchange(Callback& stored, Callback callback) {
  Callback previous = stored;
  stored = callback;
  return previous;
}

} // namespace ggrade::capture

#define GG_REQUIRE_INIT()                                                                          \
  if (!::ggrade::capture::requireInit()) return
#define GG_REQUIRE_INIT_OR(value)                                                                  \
  if (!::ggrade::capture::requireInit()) return value
