// Attributes, visibility and decoration: remembered, reported, shown to nobody.

#include "capture/channel_writer.hpp"
#include "capture/glfw/library.hpp"

using namespace ggrade::capture;

namespace {

void setIconified(GLFWwindow& window, bool iconified) {
  if (window.iconified == iconified) return;
  window.iconified = iconified;
  if (const auto callback = window.callbacks.iconify) callback(&window, iconified);
}

void setMaximized(GLFWwindow& window, bool maximized) {
  if (window.attributes.maximized == maximized) return;
  window.attributes.maximized = maximized;
  if (const auto callback = window.callbacks.maximize) callback(&window, maximized);
}

} // namespace

extern "C" {

void glfwSetWindowTitle(GLFWwindow* window, const char* title) {
  GG_REQUIRE_INIT();
  window->title = title;
}

void glfwSetWindowIcon(GLFWwindow* /*window*/, int /*count*/, const GLFWimage* /*images*/) {
  GG_REQUIRE_INIT();
}

float glfwGetWindowOpacity(GLFWwindow* window) {
  GG_REQUIRE_INIT_OR(1.0F);
  return window->opacity;
}

void glfwSetWindowOpacity(GLFWwindow* window, float opacity) {
  GG_REQUIRE_INIT();
  if (!(opacity >= 0 && opacity <= 1)) {
    reportError(GLFW_INVALID_VALUE, "Invalid window opacity %f", static_cast<double>(opacity));
    return;
  }
  say("the window's opacity changes nothing offscreen");
  window->opacity = opacity;
}

void glfwIconifyWindow(GLFWwindow* window) {
  GG_REQUIRE_INIT();
  say("iconifying changes nothing offscreen; frames go on");
  setIconified(*window, true);
}

void glfwRestoreWindow(GLFWwindow* window) {
  GG_REQUIRE_INIT();
  setIconified(*window, false);
  setMaximized(*window, false);
}

void glfwMaximizeWindow(GLFWwindow* window) {
  GG_REQUIRE_INIT();
  if (window->monitor) return;
  say("maximizing keeps the window's size offscreen");
  setMaximized(*window, true);
}

void glfwShowWindow(GLFWwindow* window) {
  GG_REQUIRE_INIT();
  window->attributes.visible = true;
}

void glfwHideWindow(GLFWwindow* window) {
  GG_REQUIRE_INIT();
  if (!window->monitor) window->attributes.visible = false;
}

void glfwFocusWindow(GLFWwindow* window) {
  GG_REQUIRE_INIT();
  if (window->attributes.focused) return;
  for (const auto& other : library().windows) other->attributes.focused = false;
  window->attributes.focused = true;
  if (const auto callback = window->callbacks.focus) callback(window, GLFW_TRUE);
}

void glfwRequestWindowAttention(GLFWwindow* /*window*/) {
  GG_REQUIRE_INIT();
}

void glfwSetWindowUserPointer(GLFWwindow* window, void* pointer) {
  GG_REQUIRE_INIT();
  window->userPointer = pointer;
}

void* glfwGetWindowUserPointer(GLFWwindow* window) {
  GG_REQUIRE_INIT_OR(nullptr);
  return window->userPointer;
}

int glfwGetWindowAttrib(GLFWwindow* window, int attribute) {
  GG_REQUIRE_INIT_OR(0);
  const WindowHints& state = window->attributes;
  const ContextHints& context = window->contextAttributes;
  switch (attribute) {
  case GLFW_FOCUSED:
    return state.focused && state.visible;
  case GLFW_ICONIFIED:
    return window->iconified;
  case GLFW_VISIBLE:
    return state.visible;
  case GLFW_MAXIMIZED:
    return state.maximized;
  case GLFW_HOVERED:
    return GLFW_FALSE;
  case GLFW_FOCUS_ON_SHOW:
    return state.focusOnShow;
  case GLFW_TRANSPARENT_FRAMEBUFFER:
    return GLFW_FALSE;
  case GLFW_RESIZABLE:
    return state.resizable;
  case GLFW_DECORATED:
    return state.decorated;
  case GLFW_FLOATING:
    return state.floating;
  case GLFW_AUTO_ICONIFY:
    return state.autoIconify;
  case GLFW_CLIENT_API:
    return context.client;
  case GLFW_CONTEXT_CREATION_API:
    return context.source;
  case GLFW_CONTEXT_VERSION_MAJOR:
    return context.major;
  case GLFW_CONTEXT_VERSION_MINOR:
    return context.minor;
  case GLFW_CONTEXT_REVISION:
    return 0;
  case GLFW_CONTEXT_ROBUSTNESS:
    return context.robustness;
  case GLFW_OPENGL_FORWARD_COMPAT:
    return context.forward;
  case GLFW_OPENGL_DEBUG_CONTEXT:
    return context.debug;
  case GLFW_OPENGL_PROFILE:
    return context.profile;
  case GLFW_CONTEXT_RELEASE_BEHAVIOR:
    return context.release;
  case GLFW_CONTEXT_NO_ERROR:
    return context.noError;
  default:
    reportError(GLFW_INVALID_ENUM, "Invalid window attribute 0x%08X",
                static_cast<unsigned>(attribute));
    return 0;
  }
}

void glfwSetWindowAttrib(GLFWwindow* window, int attribute, int value) {
  GG_REQUIRE_INIT();
  const bool on = value != GLFW_FALSE;
  switch (attribute) {
  case GLFW_AUTO_ICONIFY:
    window->attributes.autoIconify = on;
    return;
  case GLFW_RESIZABLE:
    window->attributes.resizable = on;
    return;
  case GLFW_DECORATED:
    window->attributes.decorated = on;
    return;
  case GLFW_FLOATING:
    window->attributes.floating = on;
    return;
  case GLFW_FOCUS_ON_SHOW:
    window->attributes.focusOnShow = on;
    return;
  default:
    reportError(GLFW_INVALID_ENUM, "Invalid window attribute 0x%08X",
                static_cast<unsigned>(attribute));
  }
}

} // extern "C"
