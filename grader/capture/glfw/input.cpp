// Keyboard, mouse and clipboard of a window that nobody touches.

#include "capture/channel_writer.hpp"
#include "capture/glfw/library.hpp"

#include <cfloat>

using namespace ggrade::capture;

namespace {

bool validDouble(double value) {
  return value == value && value >= -DBL_MAX && value <= DBL_MAX;
}

} // namespace

extern "C" {

int glfwGetInputMode(GLFWwindow* window, int mode) {
  GG_REQUIRE_INIT_OR(0);
  switch (mode) {
  case GLFW_CURSOR:
    return window->cursorMode;
  case GLFW_STICKY_KEYS:
    return window->stickyKeys;
  case GLFW_STICKY_MOUSE_BUTTONS:
    return window->stickyMouseButtons;
  case GLFW_LOCK_KEY_MODS:
    return window->lockKeyMods;
  case GLFW_RAW_MOUSE_MOTION:
    return window->rawMouseMotion;
  default:
    reportError(GLFW_INVALID_ENUM, "Invalid input mode 0x%08X", static_cast<unsigned>(mode));
    return 0;
  }
}

void glfwSetInputMode(GLFWwindow* window, int mode, int value) {
  GG_REQUIRE_INIT();
  const bool on = value != GLFW_FALSE;
  switch (mode) {
  case GLFW_CURSOR:
    if (value != GLFW_CURSOR_NORMAL && value != GLFW_CURSOR_HIDDEN &&
        value != GLFW_CURSOR_DISABLED) {
      reportError(GLFW_INVALID_ENUM, "Invalid cursor mode 0x%08X", static_cast<unsigned>(value));
      return;
    }
    window->cursorMode = value;
    return;
  case GLFW_STICKY_KEYS:
    window->stickyKeys = on;
    return;
  case GLFW_STICKY_MOUSE_BUTTONS:
    window->stickyMouseButtons = on;
    return;
  case GLFW_LOCK_KEY_MODS:
    window->lockKeyMods = on;
    return;
  case GLFW_RAW_MOUSE_MOTION:
    reportError(GLFW_PLATFORM_ERROR, "Raw mouse motion is not supported on this system");
    return;
  default:
    reportError(GLFW_INVALID_ENUM, "Invalid input mode 0x%08X", static_cast<unsigned>(mode));
  }
}

int glfwRawMouseMotionSupported() {
  GG_REQUIRE_INIT_OR(GLFW_FALSE);
  return GLFW_FALSE;
}

int glfwGetKey(GLFWwindow* /*window*/, int key) {
  GG_REQUIRE_INIT_OR(GLFW_RELEASE);
  if (key < GLFW_KEY_SPACE || key > GLFW_KEY_LAST)
    reportError(GLFW_INVALID_ENUM, "Invalid key %i", key);
  return GLFW_RELEASE;
}

int glfwGetMouseButton(GLFWwindow* /*window*/, int button) {
  GG_REQUIRE_INIT_OR(GLFW_RELEASE);
  if (button < GLFW_MOUSE_BUTTON_1 || button > GLFW_MOUSE_BUTTON_LAST) {
    reportError(GLFW_INVALID_ENUM, "Invalid mouse button %i", button);
  }
  return GLFW_RELEASE;
}

void glfwGetCursorPos(GLFWwindow* window, double* x, double* y) {
  if (x) *x = 0;
  if (y) *y = 0;
  GG_REQUIRE_INIT();
  if (x) *x = window->cursorX;
  if (y) *y = window->cursorY;
}

void glfwSetCursorPos(GLFWwindow* window, double x, double y) {
  GG_REQUIRE_INIT();
  if (!validDouble(x) || !validDouble(y)) {
    reportError(GLFW_INVALID_VALUE, "Invalid cursor position %f %f", x, y);
    return;
  }
  window->cursorX = x;
  window->cursorY = y;
}

void glfwSetClipboardString(GLFWwindow* /*window*/, const char* string) {
  GG_REQUIRE_INIT();
  library().clipboard = string;
}

const char* glfwGetClipboardString(GLFWwindow* /*window*/) {
  GG_REQUIRE_INIT_OR(nullptr);
  if (!library().clipboard.empty()) return library().clipboard.c_str();
  reportError(GLFW_FORMAT_UNAVAILABLE, "The clipboard holds no string");
  return nullptr;
}

} // extern "C"
