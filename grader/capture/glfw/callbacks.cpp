// The setters of window and input callbacks. They all exchange one pointer.

#include "capture/glfw/library.hpp"

using namespace ggrade::capture;

#define GG_CALLBACK(setter, Type, member)                                                          \
  Type setter(GLFWwindow* window, Type callback) {                                                 \
    GG_REQUIRE_INIT_OR(nullptr);                                                                   \
    return exchange(window->callbacks.member, callback);                                           \
  }

extern "C" {

GG_CALLBACK(glfwSetWindowPosCallback, GLFWwindowposfun, pos)
GG_CALLBACK(glfwSetWindowSizeCallback, GLFWwindowsizefun, size)
GG_CALLBACK(glfwSetWindowCloseCallback, GLFWwindowclosefun, close)
GG_CALLBACK(glfwSetWindowRefreshCallback, GLFWwindowrefreshfun, refresh)
GG_CALLBACK(glfwSetWindowFocusCallback, GLFWwindowfocusfun, focus)
GG_CALLBACK(glfwSetWindowIconifyCallback, GLFWwindowiconifyfun, iconify)
GG_CALLBACK(glfwSetWindowMaximizeCallback, GLFWwindowmaximizefun, maximize)
GG_CALLBACK(glfwSetFramebufferSizeCallback, GLFWframebuffersizefun, framebufferSize)
GG_CALLBACK(glfwSetWindowContentScaleCallback, GLFWwindowcontentscalefun, contentScale)
GG_CALLBACK(glfwSetMouseButtonCallback, GLFWmousebuttonfun, mouseButton)
GG_CALLBACK(glfwSetCursorPosCallback, GLFWcursorposfun, cursorPos)
GG_CALLBACK(glfwSetCursorEnterCallback, GLFWcursorenterfun, cursorEnter)
GG_CALLBACK(glfwSetScrollCallback, GLFWscrollfun, scroll)
GG_CALLBACK(glfwSetKeyCallback, GLFWkeyfun, key)
GG_CALLBACK(glfwSetCharCallback, GLFWcharfun, character)
GG_CALLBACK(glfwSetCharModsCallback, GLFWcharmodsfun, charMods)
GG_CALLBACK(glfwSetDropCallback, GLFWdropfun, drop)

} // extern "C"
