// glfw3native.h. Nothing of X11, GLX or EGL stands behind the window; OSMesa does. Declared here,
// since that header needs X11's.

#include "capture/channel_writer.hpp"
#include "capture/glfw/library.hpp"

#include <GL/osmesa.h>

using namespace ggrade::capture;

namespace {

/// What every X11, GLX and EGL handle is here.
template <typename Handle> Handle none(const char* name) {
  GG_REQUIRE_INIT_OR(Handle{});
  say("%s has nothing to return offscreen", name);
  return Handle{};
}

/// The window's context, or null after reporting that it has none.
OSMesaContext contextOf(const GLFWwindow* window) {
  GG_REQUIRE_INIT_OR(nullptr);
  if (window->context) return static_cast<OSMesaContext>(window->context->native());
  reportError(GLFW_NO_WINDOW_CONTEXT, "The window has no OpenGL context");
  return nullptr;
}

} // namespace

#define GG_NATIVE [[gnu::visibility("default")]]

extern "C" {

GG_NATIVE void* glfwGetX11Display() {
  return none<void*>("glfwGetX11Display");
}
GG_NATIVE unsigned long glfwGetX11Adapter(GLFWmonitor* /*monitor*/) {
  return none<unsigned long>("glfwGetX11Adapter");
}
GG_NATIVE unsigned long glfwGetX11Monitor(GLFWmonitor* /*monitor*/) {
  return none<unsigned long>("glfwGetX11Monitor");
}
GG_NATIVE unsigned long glfwGetX11Window(GLFWwindow* /*window*/) {
  return none<unsigned long>("glfwGetX11Window");
}
GG_NATIVE void* glfwGetGLXContext(GLFWwindow* /*window*/) {
  return none<void*>("glfwGetGLXContext");
}
GG_NATIVE unsigned long glfwGetGLXWindow(GLFWwindow* /*window*/) {
  return none<unsigned long>("glfwGetGLXWindow");
}
GG_NATIVE void* glfwGetEGLDisplay() {
  return none<void*>("glfwGetEGLDisplay");
}
GG_NATIVE void* glfwGetEGLContext(GLFWwindow* /*window*/) {
  return none<void*>("glfwGetEGLContext");
}
GG_NATIVE void* glfwGetEGLSurface(GLFWwindow* /*window*/) {
  return none<void*>("glfwGetEGLSurface");
}

GG_NATIVE void glfwSetX11SelectionString(const char* string) {
  glfwSetClipboardString(nullptr, string);
}
GG_NATIVE const char* glfwGetX11SelectionString() {
  return glfwGetClipboardString(nullptr);
}

GG_NATIVE void* glfwGetOSMesaContext(GLFWwindow* window) {
  return contextOf(window);
}

GG_NATIVE int glfwGetOSMesaColorBuffer(GLFWwindow* window, int* width, int* height, int* format,
                                       void** buffer) {
  const OSMesaContext context = contextOf(window);
  int values[3] = {};
  void* pixels = nullptr;
  const bool found =
      context && OSMesaGetColorBuffer(context, &values[0], &values[1], &values[2], &pixels);
  if (width) *width = values[0];
  if (height) *height = values[1];
  if (format) *format = values[2];
  if (buffer) *buffer = pixels;
  return found ? GLFW_TRUE : GLFW_FALSE;
}

GG_NATIVE int glfwGetOSMesaDepthBuffer(GLFWwindow* window, int* width, int* height,
                                       int* bytesPerValue, void** buffer) {
  const OSMesaContext context = contextOf(window);
  int values[3] = {};
  void* depths = nullptr;
  const bool found =
      context && OSMesaGetDepthBuffer(context, &values[0], &values[1], &values[2], &depths);
  if (width) *width = values[0];
  if (height) *height = values[1];
  if (bytesPerValue) *bytesPerValue = values[2];
  if (buffer) *buffer = depths;
  return found ? GLFW_TRUE : GLFW_FALSE;
}

} // extern "C"
