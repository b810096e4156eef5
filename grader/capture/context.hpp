#pragma once
/// \file
/// A GL context whose window is a memory buffer, and the library that makes such contexts: OSMesa,
/// or EGL without a window system. Each is opened when a program asks for its first GL function or
/// window: neither is needed to build.

#include "capture/gl_hooks.hpp"
#include "capture/run.hpp"

#include <GL/gl.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace ggrade::capture {

struct ContextRequest {
  bool core = false;
  int major = 1;
  int minor = 0;
  int depthBits = 24;
  int stencilBits = 8;
};

class Context {
public:
  virtual ~Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// Makes the context current to the calling thread with a window of this size (pixels, at least
  /// 1). A change of size loses the window's content and keeps its draw and read buffer. False on
  /// failure.
  bool makeCurrent(Size size);

  /// Waits for all commands and brings the window's colours into `pixels`. The context must be
  /// current.
  virtual void finish() = 0;

  /// width x height x 4 bytes RGBA, row 0 at the bottom, as of the last `finish`.
  const std::uint8_t* pixels() const { return buffer_.data(); }
  Size size() const { return size_; }

  /// OSMesaContext or EGLContext.
  virtual void* native() const = 0;

protected:
  Context() = default;
  /// Makes the context current with the buffer's size, `size`; its window is new unless that is as
  /// before.
  virtual bool attach(Size size) = 0;
  virtual bool isCurrent() const = 0;
  /// The window is bound, and this buffer of it is drawn to and read.
  static void useBuffers(GLenum draw, GLenum read);

  std::vector<std::uint8_t> buffer_;
  Size size_; ///< empty until it is current for the first time
};

class ContextLibrary {
public:
  virtual ~ContextLibrary() = default;

  /// Null when the request can't be served. `share` may be null.
  virtual std::unique_ptr<Context> create(const ContextRequest& request, const Context* share) = 0;
  virtual void clearCurrent() = 0;
  /// The calling thread's current context as its `native`, or null.
  virtual void* current() = 0;
  /// The library's function, or null when it has none of that name.
  virtual GlFunction function(const char* name) = 0;
  /// The only colour buffer that a window has, GL_FRONT or GL_BACK. A context must be current.
  virtual GLenum windowBuffer() const = 0;
  /// GL_FRAMEBUFFER_SRGB changes what is written to the window, which a monitor's never does by
  /// default (GLFW_SRGB_CAPABLE).
  virtual bool encodesSrgb() const { return false; }
  /// A function of OSMesa's own interface; null with EGL.
  virtual void* osmesaFunction(const char* /*name*/) { return nullptr; }
};

/// Null, with the reason in `why`, where the library or what it needs isn't there.
std::unique_ptr<ContextLibrary> openOsmesa(std::string& why);
enum class Device { llvmpipe, gpu };
std::unique_ptr<ContextLibrary> openEgl(Device device, std::string& why);

/// The library that GG_CAPTURE_CONTEXT names (`osmesa`, `egl`, or `gpu`: EGL on the first graphics
/// card); if it names none, OSMesa where it is, else EGL. Where there is none, one that serves
/// nothing, and says why.
ContextLibrary& contextLibrary();

/// Binds the window for drawing and reading, and what was bound before when it goes out of scope.
class WindowBinding {
public:
  WindowBinding();
  ~WindowBinding();
  WindowBinding(const WindowBinding&) = delete;
  WindowBinding& operator=(const WindowBinding&) = delete;

private:
  GLint draw_;
  GLint read_;
};

/// Mesa makes up a function for any name that it is asked for; its dispatch table knows which
/// exist. Looks for that table's index among the loaded libraries; null where it isn't found.
using ProcOffset = int (*)(const char*);
ProcOffset findProcOffset();

} // namespace ggrade::capture
