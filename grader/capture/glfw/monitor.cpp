// One monitor of 1920x1080 with one video mode.

#include "capture/channel_writer.hpp"
#include "capture/glfw/library.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>

struct GLFWmonitor {
  void* userPointer = nullptr;
  std::vector<unsigned short> red, green, blue;
  GLFWgammaramp ramp{};
};

using namespace ggrade::capture;

namespace {

constexpr GLFWvidmode kMode{1920, 1080, 8, 8, 8, 60};
constexpr unsigned kRampSize = 256;
GLFWmonitor theMonitor;
GLFWmonitorfun monitorCallback = nullptr;

void storeRamp(const GLFWgammaramp& from) {
  GLFWmonitor& monitor = theMonitor;
  monitor.red.assign(from.red, from.red + from.size);
  monitor.green.assign(from.green, from.green + from.size);
  monitor.blue.assign(from.blue, from.blue + from.size);
  monitor.ramp = {monitor.red.data(), monitor.green.data(), monitor.blue.data(), from.size};
}

void storeGamma(float gamma) {
  std::vector<unsigned short> values(kRampSize);
  for (unsigned i = 0; i < kRampSize; ++i) {
    const double value =
        std::pow(i / double{kRampSize - 1}, 1.0 / static_cast<double>(gamma)) * 65535 + 0.5;
    values[i] = static_cast<unsigned short>(std::min(value, 65535.0));
  }
  storeRamp({values.data(), values.data(), values.data(), kRampSize});
}

} // namespace

namespace ggrade::capture {
void resetMonitor() {
  theMonitor = {};
  monitorCallback = nullptr;
}
} // namespace ggrade::capture

extern "C" {

GLFWmonitor** glfwGetMonitors(int* count) {
  static GLFWmonitor* list[] = {&theMonitor};
  *count = 0;
  GG_REQUIRE_INIT_OR(nullptr);
  *count = 1;
  return list;
}

GLFWmonitor* glfwGetPrimaryMonitor() {
  GG_REQUIRE_INIT_OR(nullptr);
  return &theMonitor;
}

void glfwGetMonitorPos(GLFWmonitor* /*monitor*/, int* x, int* y) {
  if (x) *x = 0;
  if (y) *y = 0;
  GG_REQUIRE_INIT();
}

void glfwGetMonitorWorkarea(GLFWmonitor* /*monitor*/, int* x, int* y, int* width, int* height) {
  if (x) *x = 0;
  if (y) *y = 0;
  if (width) *width = 0;
  if (height) *height = 0;
  GG_REQUIRE_INIT();
  if (width) *width = kMode.width;
  if (height) *height = kMode.height;
}

void glfwGetMonitorPhysicalSize(GLFWmonitor* /*monitor*/, int* width, int* height) {
  if (width) *width = 0;
  if (height) *height = 0;
  GG_REQUIRE_INIT();
  // millimetres at 96 dots an inch
  if (width) *width = 508;
  if (height) *height = 286;
}

void glfwGetMonitorContentScale(GLFWmonitor* /*monitor*/, float* x, float* y) {
  if (x) *x = 0;
  if (y) *y = 0;
  GG_REQUIRE_INIT();
  if (x) *x = 1;
  if (y) *y = 1;
}

const char* glfwGetMonitorName(GLFWmonitor* /*monitor*/) {
  GG_REQUIRE_INIT_OR(nullptr);
  return "Offscreen";
}

void glfwSetMonitorUserPointer(GLFWmonitor* monitor, void* pointer) {
  GG_REQUIRE_INIT();
  monitor->userPointer = pointer;
}

void* glfwGetMonitorUserPointer(GLFWmonitor* monitor) {
  GG_REQUIRE_INIT_OR(nullptr);
  return monitor->userPointer;
}

GLFWmonitorfun glfwSetMonitorCallback(GLFWmonitorfun callback) {
  GG_REQUIRE_INIT_OR(nullptr);
  return exchange(monitorCallback, callback);
}

const GLFWvidmode* glfwGetVideoModes(GLFWmonitor* /*monitor*/, int* count) {
  *count = 0;
  GG_REQUIRE_INIT_OR(nullptr);
  *count = 1;
  return &kMode;
}

const GLFWvidmode* glfwGetVideoMode(GLFWmonitor* /*monitor*/) {
  GG_REQUIRE_INIT_OR(nullptr);
  return &kMode;
}

void glfwSetGamma(GLFWmonitor* /*monitor*/, float gamma) {
  GG_REQUIRE_INIT();
  if (std::isnan(gamma) || gamma <= 0 || gamma > FLT_MAX) {
    reportError(GLFW_INVALID_VALUE, "Invalid gamma value %f", static_cast<double>(gamma));
    return;
  }
  say("the monitor's gamma changes nothing offscreen");
  storeGamma(gamma);
}

const GLFWgammaramp* glfwGetGammaRamp(GLFWmonitor* monitor) {
  GG_REQUIRE_INIT_OR(nullptr);
  if (monitor->ramp.size == 0) storeGamma(1);
  return &monitor->ramp;
}

void glfwSetGammaRamp(GLFWmonitor* /*monitor*/, const GLFWgammaramp* ramp) {
  GG_REQUIRE_INIT();
  say("the monitor's gamma changes nothing offscreen");
  storeRamp(*ramp);
}

} // extern "C"
