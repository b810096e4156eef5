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
  // of GLFW 3.4: ANGLE, platform, XCB, libdecor
  case 0x00050002:
  case 0x00050003:
  case 0x00052001:
  case 0x00053001:
    return;
  default:
    reportError(GLFW_INVALID_ENUM, "Invalid init hint 0x%08X", static_cast<unsigned>(hint));
  }
}

void glfwGetVersion(int* major, int* minor, int* revision) {
  if (major) *major = GLFW_VERSION_MAJOR;
  if (minor) *minor = GLFW_VERSION_MINOR;
  if (revision) *revision = GLFW_VERSION_REVISION;
}

const char* glfwGetVersionString() {
#define GG_TEXT(number) #number
#define GG_VERSION(major, minor, revision) GG_TEXT(major) "." GG_TEXT(minor) "." GG_TEXT(revision)
  return GG_VERSION(GLFW_VERSION_MAJOR, GLFW_VERSION_MINOR,
                    GLFW_VERSION_REVISION) " offscreen capture";
}

} // extern "C"
