// Nothing happens to the window but what the schedule does: sizes, a wish to see it drawn, the end.

#include "capture/channel_writer.hpp"
#include "capture/glfw/library.hpp"

#include <cfloat>
#include <chrono>
#include <thread>

using namespace ggrade::capture;

namespace ggrade::capture {

bool onMainThread() {
  return std::this_thread::get_id() == library().mainThread;
}

void deliverSize(GLFWwindow* window) {
  if (!onMainThread() || !window->sizeChanged.exchange(false)) return;
  const Size size = window->size;
  if (const auto callback = window->callbacks.framebufferSize)
    callback(window, size.width, size.height);
  if (!library().has(window)) return;
  if (const auto callback = window->callbacks.size) callback(window, size.width, size.height);
}

void deliverEvents(GLFWwindow* window) {
  if (!onMainThread()) return;
  deliverSize(window);
  if (!library().has(window) || !window->closeAsked.exchange(false)) return;
  if (const auto callback = window->callbacks.close) callback(window);
}

} // namespace ggrade::capture

namespace {

void deliverRefresh(GLFWwindow* window) {
  if (!library().has(window) || !window->needsRefresh.exchange(false)) return;
  if (const auto callback = window->callbacks.refresh) callback(window);
}

/// A callback may create and destroy windows.
template <typename Function> void forEachWindow(const Function& function) {
  std::vector<GLFWwindow*> windows;
  for (const auto& window : library().windows) windows.push_back(window.get());
  for (GLFWwindow* const window : windows) {
    if (library().has(window)) function(window);
  }
}

void deliverAll() {
  forEachWindow([](GLFWwindow* window) {
    deliverEvents(window);
    deliverRefresh(window);
  });
}

/// A program that sleeps until something happens is asked to draw again, or it would never reach
/// its next frame.
void wait() {
  static std::uint32_t lastFrame = 0;
  const std::uint32_t frame = run().frame();
  if (frame == lastFrame) forEachWindow([](GLFWwindow* window) { window->needsRefresh = true; });
  lastFrame = frame;
  // With no context here another thread may be drawing: leave it the processor.
  if (!currentWindow()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  deliverAll();
  run().waited();
}

} // namespace

extern "C" {

void glfwPollEvents() {
  GG_REQUIRE_INIT();
  deliverAll();
  run().polled();
}

void glfwWaitEvents() {
  GG_REQUIRE_INIT();
  wait();
}

void glfwWaitEventsTimeout(double timeout) {
  GG_REQUIRE_INIT();
  if (timeout != timeout || timeout < 0.0 || timeout > DBL_MAX) {
    reportError(GLFW_INVALID_VALUE, "Invalid time %f", timeout);
    return;
  }
  wait();
}

void glfwPostEmptyEvent() {
  GG_REQUIRE_INIT();
}

int glfwWindowShouldClose(GLFWwindow* window) {
  GG_REQUIRE_INIT_OR(GLFW_FALSE);
  // The first frame may have another size than the program asked for. A loop that draws before it
  // looks at events comes through here first.
  deliverSize(window);
  if (const ContextState* state = currentState()) run().asked(state->use.draws);
  return window->shouldClose;
}

void glfwSetWindowShouldClose(GLFWwindow* window, int value) {
  GG_REQUIRE_INIT();
  window->shouldClose = value != GLFW_FALSE;
}

} // extern "C"
