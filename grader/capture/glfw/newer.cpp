// What GLFW 3.4 and 3.5 add to 3.3, for whichever version is installed: its header may not declare
// these.

#include "capture/channel_writer.hpp"
#include "capture/glfw/library.hpp"

using namespace ggrade::capture;

namespace {

constexpr int kPlatformNull = 0x00060005; // GLFW_PLATFORM_NULL

void* nothing(const char* name) {
  GG_REQUIRE_INIT_OR(nullptr);
  say("%s has nothing to return offscreen", name);
  return nullptr;
}

int nothingInto(const char* name, void** into) {
  if (into) *into = nullptr;
  nothing(name);
  return GLFW_FALSE;
}

} // namespace

#if GLFW_VERSION_MAJOR == 3 && GLFW_VERSION_MINOR < 4
struct GLFWallocator;
#endif

#define GG_NEWER [[gnu::visibility("default")]]

extern "C" {

GG_NEWER int glfwGetPlatform() {
  GG_REQUIRE_INIT_OR(0);
  return kPlatformNull;
}

GG_NEWER int glfwPlatformSupported(int platform) {
  return platform == kPlatformNull ? GLFW_TRUE : GLFW_FALSE;
}

/// Memory is the library's own either way.
GG_NEWER void glfwInitAllocator(const GLFWallocator* /*allocator*/) {}

/// There is no Vulkan here (vulkan.cpp).
GG_NEWER void glfwInitVulkanLoader(void (* /*loader*/)()) {}

GG_NEWER const char* glfwGetWindowTitle(GLFWwindow* window) {
  GG_REQUIRE_INIT_OR(nullptr);
  return window->title.c_str();
}

GG_NEWER void* glfwGetWaylandDisplay() {
  return nothing("glfwGetWaylandDisplay");
}
GG_NEWER void* glfwGetWaylandMonitor(GLFWmonitor* /*monitor*/) {
  return nothing("glfwGetWaylandMonitor");
}
GG_NEWER void* glfwGetWaylandWindow(GLFWwindow* /*window*/) {
  return nothing("glfwGetWaylandWindow");
}
GG_NEWER int glfwGetEGLConfig(GLFWwindow* /*window*/, void** config) {
  return nothingInto("glfwGetEGLConfig", config);
}
GG_NEWER int glfwGetGLXFBConfig(GLFWwindow* /*window*/, void** config) {
  return nothingInto("glfwGetGLXFBConfig", config);
}

} // extern "C"
