// glfw3native.h. Nothing of X11 or GLX stands behind the window, and of EGL nothing that has a
// window there; OSMesa may. Declared here, since that header needs X11's.

#include "capture/channel_writer.hpp"
#include "capture/glfw/library.hpp"

using namespace ggrade::capture;

namespace {

/// What every X11, GLX and EGL handle is here.
template <typename Handle> Handle none(const char* name) {
  GG_REQUIRE_INIT_OR(Handle{});
  say("%s has nothing to return offscreen", name);
  return Handle{};
}

/// The window's OSMesa context, or null after reporting that it has none.
void* contextOf(const GLFWwindow* window) {
  GG_REQUIRE_INIT_OR(nullptr);
  if (window->context && contextLibrary().osmesaFunction("OSMesaGetColorBuffer"))
    return window->context->native();
  reportError(GLFW_NO_WINDOW_CONTEXT, "The window has no OSMesa context");
  return nullptr;
}

/// OSMesa's own function of this name for the window's buffer of colours or depths.
bool buffer(GLFWwindow* window, const char* function, int* (&&into)[3], void** pixels) {
  int values[3] = {};
  void* found = nullptr;
  void* const context = contextOf(window);
  using Get = unsigned char (*)(void*, int*, int*, int*, void**);
  const auto get = reinterpret_cast<Get>(contextLibrary().osmesaFunction(function));
  const bool there = context && get && get(context, &values[0], &values[1], &values[2], &found);
  for (int i = 0; i < 3; ++i)
    if (into[i]) *into[i] = values[i];
  if (pixels) *pixels = found;
  return there;
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
                                       void** pixels) {
  return buffer(window, "OSMesaGetColorBuffer", {width, height, format}, pixels);
}

GG_NATIVE int glfwGetOSMesaDepthBuffer(GLFWwindow* window, int* width, int* height,
                                       int* bytesPerValue, void** depths) {
  return buffer(window, "OSMesaGetDepthBuffer", {width, height, bytesPerValue}, depths);
}

} // extern "C"
