#include "capture/context.hpp"

#include "capture/recorder/pixel_state.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <type_traits>

#include <dlfcn.h>
#include <unistd.h>

namespace ggrade::capture {
namespace {

// From EGL/egl.h and EGL/eglext.h, which a build doesn't need.
using EGLDisplay = void*;
using EGLConfig = void*;
using EGLContext = void*;
using EGLSurface = void*;
using EGLDevice = void*;
using EGLint = int;
using EGLBoolean = unsigned int;
using EGLenum = unsigned int;
constexpr EGLint kEglNone = 0x3038;
constexpr EGLint kAlphaSize = 0x3021, kBlueSize = 0x3022, kGreenSize = 0x3023, kRedSize = 0x3024;
constexpr EGLint kDepthSize = 0x3025, kStencilSize = 0x3026;
constexpr EGLint kSurfaceType = 0x3033, kPbufferBit = 1;
constexpr EGLint kRenderableType = 0x3040, kOpenglBit = 8;
constexpr EGLint kEglHeight = 0x3056, kEglWidth = 0x3057;
constexpr EGLint kMajorVersion = 0x3098, kMinorVersion = 0x30FB;
constexpr EGLint kProfileMask = 0x30FD, kCoreProfileBit = 1, kCompatProfileBit = 2;
constexpr EGLint kExtensions = 0x3055;
constexpr EGLenum kOpenglApi = 0x30A2;
constexpr EGLenum kPlatformSurfaceless = 0x31DD; // EGL_PLATFORM_SURFACELESS_MESA
constexpr EGLenum kPlatformDevice = 0x313F;      // EGL_PLATFORM_DEVICE_EXT

struct EglFunctions {
  EGLBoolean (*initialize)(EGLDisplay, EGLint*, EGLint*) = nullptr;
  EGLDisplay (*platformDisplay)(EGLenum, void*, const std::intptr_t*) = nullptr;
  EGLBoolean (*bindApi)(EGLenum) = nullptr;
  EGLBoolean (*chooseConfig)(EGLDisplay, const EGLint*, EGLConfig*, EGLint, EGLint*) = nullptr;
  EGLContext (*createContext)(EGLDisplay, EGLConfig, EGLContext, const EGLint*) = nullptr;
  EGLBoolean (*destroyContext)(EGLDisplay, EGLContext) = nullptr;
  EGLSurface (*createPbuffer)(EGLDisplay, EGLConfig, const EGLint*) = nullptr;
  EGLBoolean (*destroySurface)(EGLDisplay, EGLSurface) = nullptr;
  EGLBoolean (*makeCurrent)(EGLDisplay, EGLSurface, EGLSurface, EGLContext) = nullptr;
  EGLContext (*currentContext)() = nullptr;
  GlFunction (*procAddress)(const char*) = nullptr;
};

/// A display without a window system, and the functions that it is used with.
struct Display : EglFunctions {
  EGLDisplay display = nullptr;
  /// To be called before contexts are made, asked for or let go: each thread has its own.
  void useOpenGl() const { bindApi(kOpenglApi); }
};

class EglContext : public Context {
public:
  EglContext(const Display& egl, EGLConfig config, EGLContext context)
      : egl_(egl), config_(config), context_(context) {}

  ~EglContext() override {
    if (isCurrent()) egl_.makeCurrent(egl_.display, nullptr, nullptr, nullptr);
    if (window_) egl_.destroySurface(egl_.display, window_);
    egl_.destroyContext(egl_.display, context_);
  }

  void finish() override {
    static const auto glReadPixels = real<decltype(&::glReadPixels)>("glReadPixels");
    static const auto glReadBuffer = real<decltype(&::glReadBuffer)>("glReadBuffer");
    const recorder::ReadState state;
    const WindowBinding binding;
    const auto before = static_cast<GLenum>(integer(GL_READ_BUFFER));
    const GLenum only = contextLibrary().windowBuffer();
    if (before != only) glReadBuffer(only);
    glReadPixels(0, 0, size_.width, size_.height, GL_RGBA, GL_UNSIGNED_BYTE, buffer_.data());
    if (before != only) glReadBuffer(before);
  }

  void* native() const override { return context_; }

protected:
  bool attach(Size size) override {
    egl_.useOpenGl();
    if (window_ && size == windowSize_)
      return egl_.makeCurrent(egl_.display, window_, window_, context_);
    const EGLint attributes[] = {kEglWidth, size.width, kEglHeight, size.height, kEglNone};
    const EGLSurface window = egl_.createPbuffer(egl_.display, config_, attributes);
    if (!window) return false;
    if (!egl_.makeCurrent(egl_.display, window, window, context_)) {
      egl_.destroySurface(egl_.display, window);
      return false;
    }
    if (window_) {
      egl_.destroySurface(egl_.display, window_);
    } else {
      // Mesa says that it draws to GL_BACK, which a pbuffer of it doesn't have: glClearBuffer then
      // clears nothing.
      const GLenum only = contextLibrary().windowBuffer();
      useBuffers(only, only);
    }
    window_ = window;
    windowSize_ = size;
    return true;
  }

  bool isCurrent() const override {
    egl_.useOpenGl();
    return egl_.currentContext() == context_;
  }

private:
  const Display& egl_;
  EGLConfig config_;
  EGLContext context_;
  EGLSurface window_ = nullptr;
  Size windowSize_;
};

class Egl : public ContextLibrary {
public:
  explicit Egl(const Display& egl) : egl_(egl), procOffset_(findProcOffset()) {}

  std::unique_ptr<Context> create(const ContextRequest& request, const Context* share) override {
    egl_.useOpenGl();
    const EGLConfig config = configFor(request);
    if (!config) return nullptr;
    std::vector<EGLint> attributes = {kMajorVersion, request.major, kMinorVersion, request.minor};
    if (request.major > 3 || (request.major == 3 && request.minor >= 2))
      attributes.insert(attributes.end(),
                        {kProfileMask, request.core ? kCoreProfileBit : kCompatProfileBit});
    attributes.push_back(kEglNone);
    const EGLContext context = egl_.createContext(
        egl_.display, config, share ? share->native() : nullptr, attributes.data());
    if (!context) return nullptr;
    return std::make_unique<EglContext>(egl_, config, context);
  }

  void clearCurrent() override {
    egl_.useOpenGl();
    egl_.makeCurrent(egl_.display, nullptr, nullptr, nullptr);
  }

  void* current() override {
    egl_.useOpenGl();
    return egl_.currentContext();
  }

  GlFunction function(const char* name) override {
    if (std::strncmp(name, "gl", 2) != 0 || (procOffset_ && procOffset_(name) < 0)) return nullptr;
    return egl_.procAddress(name);
  }

  GLenum windowBuffer() const override {
    static const GLenum buffer = integer(GL_DOUBLEBUFFER) ? GL_BACK : GL_FRONT;
    return buffer;
  }
  bool encodesSrgb() const override { return true; }

private:
  EGLConfig configFor(const ContextRequest& request) const {
    // The fewest bits that are enough come first. No driver has 32 bits of depth for a window.
    const EGLint attributes[] = {kSurfaceType,    kPbufferBit,
                                 kRenderableType, kOpenglBit,
                                 kRedSize,        8,
                                 kGreenSize,      8,
                                 kBlueSize,       8,
                                 kAlphaSize,      8,
                                 kDepthSize,      std::min(request.depthBits, 24),
                                 kStencilSize,    request.stencilBits,
                                 kEglNone};
    EGLConfig config = nullptr;
    EGLint count = 0;
    egl_.chooseConfig(egl_.display, attributes, &config, 1, &count);
    return count > 0 ? config : nullptr;
  }

  Display egl_;
  ProcOffset procOffset_;
};

/// The first graphics card, as a display that needs no window system. Null if there is none.
EGLDisplay displayOfGpu(const EglFunctions& egl) {
  const auto queryDevices = reinterpret_cast<EGLBoolean (*)(EGLint, EGLDevice*, EGLint*)>(
      egl.procAddress("eglQueryDevicesEXT"));
  const auto deviceString = reinterpret_cast<const char* (*)(EGLDevice, EGLint)>(
      egl.procAddress("eglQueryDeviceStringEXT"));
  if (!queryDevices || !deviceString) return nullptr;
  std::array<EGLDevice, 16> devices{};
  EGLint count = 0;
  if (!queryDevices(EGLint(devices.size()), devices.data(), &count)) return nullptr;
  for (EGLint i = 0; i < count; ++i) {
    const char* const extensions = deviceString(devices[std::size_t(i)], kExtensions);
    if (!extensions || !std::strstr(extensions, "EGL_MESA_device_software"))
      return egl.platformDisplay(kPlatformDevice, devices[std::size_t(i)], nullptr);
  }
  return nullptr;
}

/// Grades come from one renderer, whatever cards a machine has and whatever its user has set.
void pinLlvmpipe() {
  setenv("LIBGL_ALWAYS_SOFTWARE", "true", 1);
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  for (const char* name : {"LIBGL_DRIVERS_PATH", "LIBGL_DRIVERS_DIR", "GBM_BACKENDS_PATH",
                           "MESA_LOADER_DRIVER_OVERRIDE", "EGL_PLATFORM",
                           "__EGL_VENDOR_LIBRARY_DIRS", "__EGL_VENDOR_LIBRARY_FILENAMES"})
    unsetenv(name);
  for (const char* file :
       {"/usr/share/glvnd/egl_vendor.d/50_mesa.json", "/etc/glvnd/egl_vendor.d/50_mesa.json"})
    if (access(file, R_OK) == 0) setenv("__EGL_VENDOR_LIBRARY_FILENAMES", file, 1);
}

bool load(void* library, EglFunctions& egl) {
  const auto get = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
    return function != nullptr;
  };
  return get(egl.initialize, "eglInitialize") &&
         get(egl.platformDisplay, "eglGetPlatformDisplay") && get(egl.bindApi, "eglBindAPI") &&
         get(egl.chooseConfig, "eglChooseConfig") && get(egl.createContext, "eglCreateContext") &&
         get(egl.destroyContext, "eglDestroyContext") &&
         get(egl.createPbuffer, "eglCreatePbufferSurface") &&
         get(egl.destroySurface, "eglDestroySurface") && get(egl.makeCurrent, "eglMakeCurrent") &&
         get(egl.currentContext, "eglGetCurrentContext") &&
         get(egl.procAddress, "eglGetProcAddress");
}

} // namespace

std::unique_ptr<ContextLibrary> openEgl(Device device, std::string& why) {
  if (device == Device::llvmpipe) pinLlvmpipe();
  void* const library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    why = dlerror();
    return nullptr;
  }
  Display egl;
  if (!load(library, egl)) {
    why = "libEGL.so.1 lacks functions of EGL 1.5";
    return nullptr;
  }
  egl.display = device == Device::gpu ? displayOfGpu(egl)
                                      : egl.platformDisplay(kPlatformSurfaceless, nullptr, nullptr);
  if (!egl.display || !egl.initialize(egl.display, nullptr, nullptr)) {
    why = device == Device::gpu ? "EGL finds no graphics card that it can draw with"
                                : "EGL can't draw without a window system: is Mesa's libEGL_mesa "
                                  "or its driver missing?";
    return nullptr;
  }
  return std::make_unique<Egl>(egl);
}

} // namespace ggrade::capture
