#include "capture/glfw/library.hpp"

using namespace ggrade::capture;

extern "C" {

void glfwDefaultWindowHints() {
  GG_REQUIRE_INIT();
  library().hints = {};
}

void glfwWindowHint(int hint, int value) {
  GG_REQUIRE_INIT();
  WindowHints& window = library().hints.window;
  ContextHints& context = library().hints.context;
  FramebufferHints& framebuffer = library().hints.framebuffer;
  const bool on = value != GLFW_FALSE;
  switch (hint) {
  case GLFW_RESIZABLE:
    window.resizable = on;
    return;
  case GLFW_VISIBLE:
    window.visible = on;
    return;
  case GLFW_DECORATED:
    window.decorated = on;
    return;
  case GLFW_FOCUSED:
    window.focused = on;
    return;
  case GLFW_AUTO_ICONIFY:
    window.autoIconify = on;
    return;
  case GLFW_FLOATING:
    window.floating = on;
    return;
  case GLFW_MAXIMIZED:
    window.maximized = on;
    return;
  case GLFW_FOCUS_ON_SHOW:
    window.focusOnShow = on;
    return;
  case GLFW_TRANSPARENT_FRAMEBUFFER:
    window.transparent = on;
    return;

  case GLFW_CLIENT_API:
    context.client = value;
    return;
  case GLFW_CONTEXT_CREATION_API:
    context.source = value;
    return;
  case GLFW_CONTEXT_VERSION_MAJOR:
    context.major = value;
    return;
  case GLFW_CONTEXT_VERSION_MINOR:
    context.minor = value;
    return;
  case GLFW_OPENGL_PROFILE:
    context.profile = value;
    return;
  case GLFW_CONTEXT_ROBUSTNESS:
    context.robustness = value;
    return;
  case GLFW_CONTEXT_RELEASE_BEHAVIOR:
    context.release = value;
    return;
  case GLFW_OPENGL_FORWARD_COMPAT:
    context.forward = on;
    return;
  case GLFW_OPENGL_DEBUG_CONTEXT:
    context.debug = on;
    return;
  case GLFW_CONTEXT_NO_ERROR:
    context.noError = on;
    return;

  case GLFW_DEPTH_BITS:
    framebuffer.depthBits = value;
    return;
  case GLFW_STENCIL_BITS:
    framebuffer.stencilBits = value;
    return;
  case GLFW_SAMPLES:
    framebuffer.samples = value;
    return;
  case GLFW_STEREO:
    framebuffer.stereo = on;
    return;
  case GLFW_SRGB_CAPABLE:
    framebuffer.srgb = on;
    return;
  case GLFW_DOUBLEBUFFER:
    framebuffer.doubleBuffer = on;
    return;

  // The buffer always has 8 bits a channel; the rest means nothing without a display.
  case GLFW_RED_BITS:
  case GLFW_GREEN_BITS:
  case GLFW_BLUE_BITS:
  case GLFW_ALPHA_BITS:
  case GLFW_ACCUM_RED_BITS:
  case GLFW_ACCUM_GREEN_BITS:
  case GLFW_ACCUM_BLUE_BITS:
  case GLFW_ACCUM_ALPHA_BITS:
  case GLFW_AUX_BUFFERS:
  case GLFW_REFRESH_RATE:
  case GLFW_CENTER_CURSOR:
  case GLFW_SCALE_TO_MONITOR:
  case GLFW_COCOA_RETINA_FRAMEBUFFER:
  case GLFW_COCOA_GRAPHICS_SWITCHING:
  // of GLFW 3.4: mouse passthrough, position, scaled framebuffer, Windows' menu and first showing
  case 0x0002000D:
  case 0x0002000E:
  case 0x0002000F:
  case 0x0002200D:
  case 0x00025001:
  case 0x00025002:
    return;
  default:
    reportError(GLFW_INVALID_ENUM, "Invalid window hint 0x%08X", static_cast<unsigned>(hint));
  }
}

void glfwWindowHintString(int hint, const char* /*value*/) {
  GG_REQUIRE_INIT();
  switch (hint) {
  case GLFW_COCOA_FRAME_NAME:
  case GLFW_X11_CLASS_NAME:
  case GLFW_X11_INSTANCE_NAME:
  case 0x00026001: // Wayland's, of GLFW 3.4
    return;
  default:
    reportError(GLFW_INVALID_ENUM, "Invalid window hint string 0x%08X",
                static_cast<unsigned>(hint));
  }
}

} // extern "C"
