#include "capture/channel_writer.hpp"
#include "capture/glfw/library.hpp"
#include "capture/recorder/recorder.hpp"
#include "capture/tape/calls.hpp"
#include "capture/tape/writer.hpp"

#include <algorithm>
#include <string_view>

using namespace ggrade::capture;

namespace ggrade::capture {
namespace {

thread_local GLFWwindow* current = nullptr;

/// False after reporting that no context is current.
bool requireContext(const char* action) {
  if (current) return true;
  reportError(GLFW_NO_CURRENT_CONTEXT, "Cannot %s without a current OpenGL or OpenGL ES context",
              action);
  return false;
}

channel::FrameRecord describeFrame(const GLFWwindow& window, bool reachable) {
  channel::FrameRecord record{};
  record.width = static_cast<std::uint32_t>(window.context->size().width);
  record.height = static_cast<std::uint32_t>(window.context->size().height);
  record.windowDraws = window.state.use.draws;
  record.windowClears = window.state.use.clears;
  record.windowSrgb = window.state.use.srgb;
  if (reachable) {
    GLint bound = 0;
    real<decltype(&glGetIntegerv)>("glGetIntegerv")(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    record.boundFramebuffer = static_cast<std::uint32_t>(bound);
  }
  return record;
}

/// `reachable`: the window's context is current to this thread.
void handOver(GLFWwindow& window, bool reachable) {
  channel::FrameRecord record = describeFrame(window, reachable);
  if (tape::isWanted) tape::swap();
  if (recordsPasses) recorder::swap(record, reachable);
  if (reachable) {
    collectError(window.state);
    window.context->finish();
  } else {
    say("glfwSwapBuffers on a window whose context is current to another thread; its last commands "
        "may be missing");
  }
  if (record.windowSrgb) {
    say("GL_FRAMEBUFFER_SRGB was on for the window, which is linear offscreen: colours stay as "
        "written");
  }
  const auto now = std::chrono::steady_clock::now();
  record.seconds = std::chrono::duration<double>(now - window.lastSwap).count();
  writeFrame(record, window.context->pixels());
  window.lastSwap = std::chrono::steady_clock::now();
  if (run().endFrame()) window.shouldClose = window.closeAsked = true;
  updateSize(window);
}

/// Calls `function(reachable)` with the window's context current, if no other thread has it.
template <typename Function> void withContext(GLFWwindow& window, const Function& function) {
  if (current == &window || window.isCurrent) {
    function(current == &window);
    return;
  }
  GLFWwindow* const previous = current;
  makeCurrent(&window);
  function(true);
  makeCurrent(previous);
}

} // namespace

GLFWwindow* currentWindow() {
  return current;
}

bool makeCurrent(GLFWwindow* window) {
  if (recordsPasses) recorder::leave();
  if (current) current->isCurrent = false;
  current = nullptr;
  setCurrentState(nullptr);
  if (!window) {
    contextLibrary().clearCurrent();
    return true;
  }
  if (!window->context->makeCurrent(window->size)) return false;
  current = window;
  current->isCurrent = true;
  setCurrentState(&window->state);
  window->state.windowSize = window->context->size();
  return true;
}

} // namespace ggrade::capture

extern "C" {

void glfwMakeContextCurrent(GLFWwindow* window) {
  GG_REQUIRE_INIT();
  if (window && !window->context) {
    reportError(GLFW_NO_WINDOW_CONTEXT,
                "Cannot make current with a window that has no OpenGL or OpenGL ES context");
    return;
  }
  if (window && window != current && window->isCurrent) {
    reportError(GLFW_PLATFORM_ERROR, "The context is current to another thread");
    return;
  }
  if (!makeCurrent(window)) reportError(GLFW_PLATFORM_ERROR, "The context cannot be made current");
}

GLFWwindow* glfwGetCurrentContext() {
  GG_REQUIRE_INIT_OR(nullptr);
  return current;
}

void glfwSwapBuffers(GLFWwindow* window) {
  GG_REQUIRE_INIT();
  if (!window->context) {
    reportError(GLFW_NO_WINDOW_CONTEXT,
                "Cannot swap buffers of a window that has no OpenGL or OpenGL ES context");
    return;
  }
  if (!library().captured) library().captured = window;
  if (window == library().captured) {
    withContext(*window, [&](bool reachable) { handOver(*window, reachable); });
  } else if (recordsPasses && window == current) {
    recorder::leave();
  }
  window->state.use = {};
  deliverEvents(window);
}

void glfwSwapInterval(int /*interval*/) {
  GG_REQUIRE_INIT();
  if (requireContext("set swap interval"))
    say("glfwSwapInterval: frames follow the schedule offscreen");
}

int glfwExtensionSupported(const char* extension) {
  GG_REQUIRE_INIT_OR(GLFW_FALSE);
  if (!requireContext("query extension")) return GLFW_FALSE;
  if (*extension == '\0') {
    reportError(GLFW_INVALID_VALUE, "Extension name cannot be an empty string");
    return GLFW_FALSE;
  }
  GLint count = 0;
  real<decltype(&glGetIntegerv)>("glGetIntegerv")(GL_NUM_EXTENSIONS, &count);
  const auto getStringi = real<PFNGLGETSTRINGIPROC>("glGetStringi");
  for (GLint i = 0; i < count; ++i) {
    const auto* const name =
        reinterpret_cast<const char*>(getStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
    if (name && std::string_view(name) == extension) return GLFW_TRUE;
  }
  return GLFW_FALSE;
}

GLFWglproc glfwGetProcAddress(const char* name) {
  GG_REQUIRE_INIT_OR(nullptr);
  if (!requireContext("query entry point")) return nullptr;
  return glFunction(name);
}

} // extern "C"
