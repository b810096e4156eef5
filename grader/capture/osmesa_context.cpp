#include "capture/osmesa_context.hpp"

#include <GL/osmesa.h>

#include <GL/glext.h>
#include <dlfcn.h>

namespace ggrade::capture {
namespace {

using ProcOffset = int (*)(const char*);

/// OSMesaGetProcAddress makes up a function for any name. Mesa's dispatch table knows which exist.
ProcOffset findProcOffset() {
  Dl_info info{};
  if (!dladdr(reinterpret_cast<void*>(&OSMesaGetProcAddress), &info)) return nullptr;
  void* const library = dlopen(info.dli_fname, RTLD_NOW | RTLD_NOLOAD);
  return library ? reinterpret_cast<ProcOffset>(dlsym(library, "_glapi_get_proc_offset")) : nullptr;
}

struct Gl {
  decltype(&glFinish) finish = real<decltype(&glFinish)>("glFinish");
  decltype(&glDrawBuffer) drawBuffer = real<decltype(&glDrawBuffer)>("glDrawBuffer");
  decltype(&glReadBuffer) readBuffer = real<decltype(&glReadBuffer)>("glReadBuffer");
  PFNGLBINDFRAMEBUFFERPROC bindFramebuffer = real<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer");
};

const Gl& gl() {
  static const Gl functions;
  return functions;
}

/// Binds the window for drawing and reading, and what was bound before when it goes out of scope.
class WindowBinding {
public:
  WindowBinding()
      : draw_(integer(GL_DRAW_FRAMEBUFFER_BINDING)), read_(integer(GL_READ_FRAMEBUFFER_BINDING)) {
    if (draw_) gl().bindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    if (read_) gl().bindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  }
  ~WindowBinding() {
    if (draw_) gl().bindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
    if (read_) gl().bindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
  }
  WindowBinding(const WindowBinding&) = delete;
  WindowBinding& operator=(const WindowBinding&) = delete;

private:
  GLint draw_;
  GLint read_;
};

} // namespace

std::unique_ptr<OsmesaContext> OsmesaContext::create(const ContextRequest& request,
                                                     const OsmesaContext* share) {
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            request.depthBits,
                            OSMESA_STENCIL_BITS,
                            request.stencilBits,
                            OSMESA_PROFILE,
                            request.core ? OSMESA_CORE_PROFILE : OSMESA_COMPAT_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            request.major,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            request.minor,
                            0};
  const OSMesaContext context = OSMesaCreateContextAttribs(
      attributes, share ? static_cast<OSMesaContext>(share->context_) : nullptr);
  if (!context) return nullptr;
  return std::unique_ptr<OsmesaContext>(new OsmesaContext(context));
}

OsmesaContext::~OsmesaContext() {
  if (OSMesaGetCurrentContext() == context_) clearCurrent();
  OSMesaDestroyContext(static_cast<OSMesaContext>(context_));
}

bool OsmesaContext::attach(Size size) {
  if (size != size_) {
    buffer_.assign(std::size_t{4} * static_cast<std::size_t>(size.width) *
                       static_cast<std::size_t>(size.height),
                   0);
    size_ = size;
  }
  return OSMesaMakeCurrent(static_cast<OSMesaContext>(context_), buffer_.data(), GL_UNSIGNED_BYTE,
                           size.width, size.height);
}

bool OsmesaContext::makeCurrent(Size size) {
  const bool resized = size_ != Size{} && size != size_;
  if (!resized) return attach(size);
  // OSMesa makes a new window framebuffer for the new size; its draw and read buffer move over.
  if (OSMesaGetCurrentContext() != context_ && !attach(size_)) return false;
  const WindowBinding binding;
  const auto drawBuffer = static_cast<GLenum>(integer(GL_DRAW_BUFFER));
  const auto readBuffer = static_cast<GLenum>(integer(GL_READ_BUFFER));
  if (!attach(size)) return false;
  gl().drawBuffer(drawBuffer);
  gl().readBuffer(readBuffer);
  return true;
}

void OsmesaContext::clearCurrent() {
  OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
}

void OsmesaContext::finish() {
  // OSMesa copies the window out only while it is the draw framebuffer.
  const WindowBinding binding;
  gl().finish();
}

GlFunction OsmesaContext::function(const char* name) {
  static const ProcOffset procOffset = findProcOffset();
  if (procOffset && procOffset(name) < 0) return nullptr;
  return reinterpret_cast<GlFunction>(OSMesaGetProcAddress(name));
}

} // namespace ggrade::capture
