#include "capture/glfw/library.hpp"

using namespace ggrade::capture;

extern "C" {

int glfwInit() {
  if (library().initialised) return GLFW_TRUE;
  library().initialised = true;
  library().hints = {};
  library().mainThread = std::this_thread::get_id();
  run().setTime(0);
  return GLFW_TRUE;
}

void glfwTerminate() {
  if (!library().initialised) return;
  while (!library().windows.empty()) glfwDestroyWindow(library().windows.back().get());
  library().cursors.clear();
  resetMonitor();
  library().initialised = false;
}

void glfwInitHint(int hint, int /*value*/) {
  switch (hint) {
  case GLFW_JOYSTICK_HAT_BUTTONS:
  case GLFW_COCOA_CHDIR_RESOURCES:
  case GLFW_COCOA_MENUBAR:
    return;
  default:
    reportError(GLFW_INVALID_ENUM, "Invalid init hint 0x%08X", static_cast<unsigned>(hint));
  }
}

void glfwGetVersion(int* major, int* minor, int* revision) {
  if (major) *major = 3;
  if (minor) *minor = 3;
  if (revision) *revision = 8;
}

const char* glfwGetVersionString() {
  return "3.3.8 OSMesa offscreen capture";
}

} // extern "C"
