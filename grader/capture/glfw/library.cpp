#include "capture/glfw/library.hpp"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

namespace ggrade::capture {
namespace {

struct LastError {
  int code = GLFW_NO_ERROR;
  std::string description;
  std::string handedOut; ///< what the pointer from glfwGetError points to
};

thread_local LastError lastError;
GLFWerrorfun errorCallback = nullptr;

} // namespace

Library& library() {
  // Never destroyed: static destructors of the program may still call GLFW.
  static Library* const instance = new Library;
  return *instance;
}

void reportError(int code, const char* format, ...) {
  char text[1024];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof(text), format, arguments);
  va_end(arguments);
  lastError.code = code;
  lastError.description = text;
  if (errorCallback) errorCallback(code, text);
}

bool Library::has(const GLFWwindow* window) const {
  return std::any_of(windows.begin(), windows.end(),
                     [window](const auto& known) { return known.get() == window; });
}

bool requireInit() {
  if (library().initialised) return true;
  reportError(GLFW_NOT_INITIALIZED, "The GLFW library is not initialized");
  return false;
}

} // namespace ggrade::capture

using namespace ggrade::capture;

extern "C" {

int glfwGetError(const char** description) {
  const int code = exchange(lastError.code, int{GLFW_NO_ERROR});
  lastError.handedOut = lastError.description;
  if (description) *description = code == GLFW_NO_ERROR ? nullptr : lastError.handedOut.c_str();
  return code;
}

GLFWerrorfun glfwSetErrorCallback(GLFWerrorfun callback) {
  return exchange(errorCallback, callback);
}

} // extern "C"
