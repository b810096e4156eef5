#include "capture/channel_writer.hpp"
#include "capture/glfw/library.hpp"

using namespace ggrade::capture;

namespace {

bool validContext(const ContextHints& hints, const GLFWwindow* share) {
  const auto refuse = [](int code, const char* what, int value) {
    reportError(code, "%s 0x%08X", what, static_cast<unsigned>(value));
    return false;
  };
  if (share && (hints.client == GLFW_NO_API || !share->context)) {
    reportError(GLFW_NO_WINDOW_CONTEXT, "Cannot share with a window that has no OpenGL context");
    return false;
  }
  if (hints.source != GLFW_NATIVE_CONTEXT_API && hints.source != GLFW_EGL_CONTEXT_API &&
      hints.source != GLFW_OSMESA_CONTEXT_API) {
    return refuse(GLFW_INVALID_ENUM, "Invalid context creation API", hints.source);
  }
  if (hints.client == GLFW_NO_API) return true;
  if (hints.client == GLFW_OPENGL_ES_API) {
    reportError(GLFW_API_UNAVAILABLE, "OpenGL ES is not available offscreen");
    return false;
  }
  if (hints.client != GLFW_OPENGL_API)
    return refuse(GLFW_INVALID_ENUM, "Invalid client API", hints.client);
  const int major = hints.major;
  const int minor = hints.minor;
  if (major < 1 || minor < 0 || (major == 1 && minor > 5) || (major == 2 && minor > 1) ||
      (major == 3 && minor > 3)) {
    reportError(GLFW_INVALID_VALUE, "Invalid OpenGL version %i.%i", major, minor);
    return false;
  }
  if (hints.profile != GLFW_OPENGL_ANY_PROFILE) {
    if (hints.profile != GLFW_OPENGL_CORE_PROFILE && hints.profile != GLFW_OPENGL_COMPAT_PROFILE) {
      return refuse(GLFW_INVALID_ENUM, "Invalid OpenGL profile", hints.profile);
    }
    if (major < 3 || (major == 3 && minor < 2)) {
      reportError(GLFW_INVALID_VALUE,
                  "Context profiles are only defined for OpenGL version 3.2 and above");
      return false;
    }
  }
  if (hints.forward && major < 3) {
    reportError(GLFW_INVALID_VALUE,
                "Forward-compatibility is only defined for OpenGL version 3.0 and above");
    return false;
  }
  if (hints.robustness != GLFW_NO_ROBUSTNESS && hints.robustness != GLFW_NO_RESET_NOTIFICATION &&
      hints.robustness != GLFW_LOSE_CONTEXT_ON_RESET) {
    return refuse(GLFW_INVALID_ENUM, "Invalid context robustness mode", hints.robustness);
  }
  if (hints.release != GLFW_ANY_RELEASE_BEHAVIOR && hints.release != GLFW_RELEASE_BEHAVIOR_FLUSH &&
      hints.release != GLFW_RELEASE_BEHAVIOR_NONE) {
    return refuse(GLFW_INVALID_ENUM, "Invalid context release behavior", hints.release);
  }
  return true;
}

ContextRequest requestFor(const ContextHints& context, const FramebufferHints& framebuffer) {
  ContextRequest request;
  const bool from32 = context.major > 3 || (context.major == 3 && context.minor >= 2);
  // Without a profile, GLX gives the core profile from 3.2 on.
  request.core = context.profile == GLFW_OPENGL_CORE_PROFILE || context.forward ||
                 (context.profile == GLFW_OPENGL_ANY_PROFILE && from32);
  request.major = context.major;
  request.minor = context.minor;
  const auto bits = [](int hint, int standard) { return hint == GLFW_DONT_CARE ? standard : hint; };
  request.stencilBits = bits(framebuffer.stencilBits, 8) > 0 ? 8 : 0;
  request.depthBits = bits(framebuffer.depthBits, 24);
  if (request.stencilBits) request.depthBits = 24;
  return request;
}

void sayUnsupported(const FramebufferHints& framebuffer, const ContextHints& context) {
  if (framebuffer.samples > 0) {
    say("GLFW_SAMPLES=%d: the window has one sample a pixel offscreen", framebuffer.samples);
  }
  if (framebuffer.srgb) say("GLFW_SRGB_CAPABLE: the window is linear offscreen");
  if (framebuffer.stereo) say("GLFW_STEREO: the window has no right-eye buffer offscreen");
  if (!framebuffer.doubleBuffer)
    say("GLFW_DOUBLEBUFFER=0: a frame is captured at glfwSwapBuffers only");
  if (context.noError) say("GLFW_CONTEXT_NO_ERROR: errors are still checked offscreen");
}

/// Reads back what the context is, as GLFW does. The context must be current.
void describeContext(GLFWwindow& window) {
  ContextHints& attributes = window.contextAttributes;
  attributes.major = integer(GL_MAJOR_VERSION);
  attributes.minor = integer(GL_MINOR_VERSION);
  attributes.profile = integer(GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_CORE_PROFILE_BIT
                           ? GLFW_OPENGL_CORE_PROFILE
                           : GLFW_OPENGL_COMPAT_PROFILE;
  attributes.robustness = GLFW_NO_ROBUSTNESS;
  attributes.noError = false;
}

bool createContext(GLFWwindow& window, const FramebufferHints& framebuffer,
                   const GLFWwindow* share) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const ContextHints& wanted = window.contextAttributes;
  window.context = contextLibrary().create(requestFor(wanted, framebuffer),
                                           share ? share->context.get() : nullptr);
  if (!window.context) {
    reportError(GLFW_VERSION_UNAVAILABLE, "OpenGL version %i.%i is not available offscreen",
                wanted.major, wanted.minor);
    return false;
  }
  static std::uint32_t groups = 0;
  window.state.shareGroup = share ? share->state.shareGroup : groups++;
  const Size size = window.size;
  GLFWwindow* const previous = currentWindow();
  if (!makeCurrent(&window)) {
    reportError(GLFW_PLATFORM_ERROR, "A window of %ix%i pixels is not available offscreen",
                size.width, size.height);
    window.context.reset();
    return false;
  }
  window.state.debug.debugContext = window.state.debug.output = wanted.debug;
  installDebugCallback(window.state);
  describeContext(window);
  const auto getString = real<decltype(&glGetString)>("glGetString");
  const auto* const version = reinterpret_cast<const char*>(getString(GL_VERSION));
  const auto* const renderer = reinterpret_cast<const char*>(getString(GL_RENDERER));
  window.lastSwap = Clock::now();
  writeContext(std::chrono::duration<double>(window.lastSwap - start).count(), version, renderer);
  makeCurrent(previous);
  return true;
}

/// The first window with a context is the captured one; a hidden one (a loader's helper) gives way
/// to the first visible one as long as no frame came from it.
bool takesCapture(const GLFWwindow& window) {
  const GLFWwindow* const captured = library().captured;
  if (!captured) return true;
  return !captured->attributes.visible && window.attributes.visible && run().frame() == 0;
}

} // namespace

extern "C" {

GLFWwindow* glfwCreateWindow(int width, int height, const char* title, GLFWmonitor* monitor,
                             GLFWwindow* share) {
  GG_REQUIRE_INIT_OR(nullptr);
  if (width <= 0 || height <= 0) {
    reportError(GLFW_INVALID_VALUE, "Invalid window size %ix%i", width, height);
    return nullptr;
  }
  const Hints& hints = library().hints;
  if (!validContext(hints.context, share)) return nullptr;
  if (monitor) say("full screen: the window keeps the size that was asked for");

  auto owner = std::make_unique<GLFWwindow>();
  GLFWwindow& window = *owner;
  window.attributes = hints.window;
  window.contextAttributes = hints.context;
  window.monitor = monitor;
  window.title = title ? title : "";
  const Size asked{width, height};
  const bool hasContext = hints.context.client != GLFW_NO_API;
  const bool captured = hasContext && takesCapture(window);
  const Size size = captured ? run().plannedSize(asked) : asked;
  window.asked = asked;
  window.size = size;
  window.sizeChanged = size != asked;
  if (hasContext) {
    sayUnsupported(hints.framebuffer, hints.context);
    if (!createContext(window, hints.framebuffer, share)) return nullptr;
  }
  library().windows.push_back(std::move(owner));
  if (captured) {
    library().captured = &window;
  } else if (hasContext) {
    say("the program has several windows; only the first one's frames are captured");
  }
  return &window;
}

void glfwDestroyWindow(GLFWwindow* window) {
  GG_REQUIRE_INIT();
  if (!window) return;
  window->callbacks = {};
  if (window == currentWindow()) makeCurrent(nullptr);
  if (window == library().captured.load()) library().captured = nullptr;
  std::erase_if(library().windows, [window](const auto& known) { return known.get() == window; });
}

} // extern "C"
