// Sizes and places. Window coordinates are pixels; there are no frames around windows.

#include "capture/channel_writer.hpp"
#include "capture/glfw/library.hpp"
#include "capture/recorder/recorder.hpp"

#include <algorithm>

using namespace ggrade::capture;

namespace {

int clampTo(int value, int low, int high) {
  if (low != GLFW_DONT_CARE) value = std::max(value, low);
  if (high != GLFW_DONT_CARE) value = std::min(value, high);
  return value;
}

bool badLimit(int value) {
  return value != GLFW_DONT_CARE && value < 0;
}

} // namespace

namespace ggrade::capture {

void updateSize(GLFWwindow& window) {
  const bool captured = &window == library().captured;
  const Size asked = window.asked;
  const Size size = captured ? run().plannedSize(asked) : asked;
  if (size != window.size.load()) {
    window.size = size;
    window.sizeChanged = true;
    window.needsRefresh = true;
  }
  // A context that another thread has takes its new size at that thread's next swap.
  if (&window != currentWindow()) return;
  if (recordsPasses && size != window.context->size()) recorder::leave();
  window.context->makeCurrent(size);
  window.state.windowSize = window.context->size();
}

} // namespace ggrade::capture

extern "C" {

void glfwGetWindowPos(GLFWwindow* window, int* x, int* y) {
  if (x) *x = 0;
  if (y) *y = 0;
  GG_REQUIRE_INIT();
  if (x) *x = window->x;
  if (y) *y = window->y;
}

void glfwSetWindowPos(GLFWwindow* window, int x, int y) {
  GG_REQUIRE_INIT();
  if (window->monitor || (window->x == x && window->y == y)) return;
  window->x = x;
  window->y = y;
  if (const auto callback = window->callbacks.pos) callback(window, x, y);
}

void glfwGetWindowSize(GLFWwindow* window, int* width, int* height) {
  if (width) *width = 0;
  if (height) *height = 0;
  GG_REQUIRE_INIT();
  const Size size = window->size;
  if (width) *width = size.width;
  if (height) *height = size.height;
}

void glfwGetFramebufferSize(GLFWwindow* window, int* width, int* height) {
  glfwGetWindowSize(window, width, height);
}

void glfwSetWindowSize(GLFWwindow* window, int width, int height) {
  GG_REQUIRE_INIT();
  if (width <= 0 || height <= 0) {
    say("glfwSetWindowSize to %dx%d was ignored", width, height);
    return;
  }
  const auto& [minWidth, minHeight, maxWidth, maxHeight] = window->limits;
  const auto& [aspectX, aspectY] = window->aspect;
  Size asked{clampTo(width, minWidth, maxWidth), clampTo(height, minHeight, maxHeight)};
  if (aspectX > 0 && aspectY > 0) {
    asked.height = std::max(1, static_cast<int>(std::int64_t{asked.width} * aspectY / aspectX));
  }
  window->asked = asked;
  updateSize(*window);
  if (window->size.load() != asked)
    say("glfwSetWindowSize: the schedule decides on this frame's size");
  deliverSize(window);
}

void glfwSetWindowSizeLimits(GLFWwindow* window, int minWidth, int minHeight, int maxWidth,
                             int maxHeight) {
  GG_REQUIRE_INIT();
  if (badLimit(minWidth) || badLimit(minHeight)) {
    reportError(GLFW_INVALID_VALUE, "Invalid window minimum size %ix%i", minWidth, minHeight);
    return;
  }
  const auto below = [](int high, int low) {
    return high != GLFW_DONT_CARE && low != GLFW_DONT_CARE && high < low;
  };
  if (badLimit(maxWidth) || badLimit(maxHeight) || below(maxWidth, minWidth) ||
      below(maxHeight, minHeight)) {
    reportError(GLFW_INVALID_VALUE, "Invalid window maximum size %ix%i", maxWidth, maxHeight);
    return;
  }
  window->limits = {minWidth, minHeight, maxWidth, maxHeight};
  const Size asked = window->asked;
  if (!window->monitor) glfwSetWindowSize(window, asked.width, asked.height);
}

void glfwSetWindowAspectRatio(GLFWwindow* window, int numerator, int denominator) {
  GG_REQUIRE_INIT();
  if (numerator == 0 || denominator == 0 || badLimit(numerator) || badLimit(denominator)) {
    reportError(GLFW_INVALID_VALUE, "Invalid window aspect ratio %i:%i", numerator, denominator);
    return;
  }
  window->aspect = {numerator, denominator};
  const Size asked = window->asked;
  if (!window->monitor) glfwSetWindowSize(window, asked.width, asked.height);
}

void glfwGetWindowFrameSize(GLFWwindow* /*window*/, int* left, int* top, int* right, int* bottom) {
  if (left) *left = 0;
  if (top) *top = 0;
  if (right) *right = 0;
  if (bottom) *bottom = 0;
  GG_REQUIRE_INIT();
}

void glfwGetWindowContentScale(GLFWwindow* /*window*/, float* x, float* y) {
  if (x) *x = 0;
  if (y) *y = 0;
  GG_REQUIRE_INIT();
  if (x) *x = 1;
  if (y) *y = 1;
}

GLFWmonitor* glfwGetWindowMonitor(GLFWwindow* window) {
  GG_REQUIRE_INIT_OR(nullptr);
  return window->monitor;
}

void glfwSetWindowMonitor(GLFWwindow* window, GLFWmonitor* monitor, int x, int y, int width,
                          int height, int refreshRate) {
  GG_REQUIRE_INIT();
  if (width <= 0 || height <= 0) {
    reportError(GLFW_INVALID_VALUE, "Invalid window size %ix%i", width, height);
    return;
  }
  if (refreshRate < 0 && refreshRate != GLFW_DONT_CARE) {
    reportError(GLFW_INVALID_VALUE, "Invalid refresh rate %i", refreshRate);
    return;
  }
  if (monitor) say("full screen: the window keeps the size that was asked for");
  window->monitor = monitor;
  if (!monitor) {
    window->x = x;
    window->y = y;
  }
  glfwSetWindowSize(window, width, height);
}

} // extern "C"
