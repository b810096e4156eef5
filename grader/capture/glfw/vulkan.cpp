// There is no Vulkan here; every function says so as GLFW does without a Vulkan loader.

#include "capture/glfw/library.hpp"

using namespace ggrade::capture;

namespace {

constexpr int kInitializationFailed = -3; // VK_ERROR_INITIALIZATION_FAILED

bool requireVulkan() {
  if (requireInit()) reportError(GLFW_API_UNAVAILABLE, "Vulkan: Loader not found");
  return false;
}

} // namespace

// Declared by glfw3.h only after Vulkan's own header.
extern "C" {

int glfwVulkanSupported() {
  GG_REQUIRE_INIT_OR(GLFW_FALSE);
  return GLFW_FALSE;
}

const char** glfwGetRequiredInstanceExtensions(uint32_t* count) {
  *count = 0;
  requireVulkan();
  return nullptr;
}

[[gnu::visibility("default")]] GLFWvkproc glfwGetInstanceProcAddress(void* /*instance*/,
                                                                     const char* /*name*/) {
  requireVulkan();
  return nullptr;
}

[[gnu::visibility("default")]] int glfwGetPhysicalDevicePresentationSupport(void* /*instance*/,
                                                                            void* /*device*/,
                                                                            uint32_t /*family*/) {
  requireVulkan();
  return GLFW_FALSE;
}

[[gnu::visibility("default")]] int glfwCreateWindowSurface(void* /*instance*/,
                                                           GLFWwindow* /*window*/,
                                                           const void* /*allocator*/,
                                                           uint64_t* surface) {
  *surface = 0;
  requireVulkan();
  return kInitializationFailed;
}

} // extern "C"
