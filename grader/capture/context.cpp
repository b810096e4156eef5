#include "capture/context.hpp"

#include "capture/channel_writer.hpp"

#include <GL/glext.h>

#include <cstdlib>
#include <string_view>

#include <dlfcn.h>
#include <link.h>

namespace ggrade::capture {
namespace {

struct Gl {
  decltype(&glDrawBuffer) drawBuffer = real<decltype(&glDrawBuffer)>("glDrawBuffer");
  decltype(&glReadBuffer) readBuffer = real<decltype(&glReadBuffer)>("glReadBuffer");
  PFNGLBINDFRAMEBUFFERPROC bindFramebuffer = real<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer");
};

const Gl& gl() {
  static const Gl functions;
  return functions;
}

/// Stands where no library could be opened.
class NoContexts : public ContextLibrary {
public:
  explicit NoContexts(std::string why) : why_(std::move(why)) {}
  std::unique_ptr<Context> create(const ContextRequest& /*request*/,
                                  const Context* /*share*/) override {
    say("%s", why_.c_str());
    return nullptr;
  }
  void clearCurrent() override {}
  void* current() override { return nullptr; }
  GlFunction function(const char* /*name*/) override { return nullptr; }
  GLenum windowBuffer() const override { return GL_BACK; }

private:
  std::string why_;
};

std::unique_ptr<ContextLibrary> openChosen() {
  const char* const variable = std::getenv("GG_CAPTURE_CONTEXT");
  const std::string_view chosen = variable ? variable : "";
  std::string whyOsmesa, whyEgl;
  if (chosen != "egl" && chosen != "gpu")
    if (auto library = openOsmesa(whyOsmesa)) return library;
  if (chosen != "osmesa")
    if (auto library = openEgl(chosen == "gpu" ? Device::gpu : Device::llvmpipe, whyEgl))
      return library;
  const char* const between = whyOsmesa.empty() || whyEgl.empty() ? "" : "; ";
  return std::make_unique<NoContexts>(whyOsmesa + between + whyEgl);
}

} // namespace

ContextLibrary& contextLibrary() {
  // Never closed: a program's own destructors may still call GL.
  static ContextLibrary& library = *openChosen().release();
  return library;
}

WindowBinding::WindowBinding()
    : draw_(integer(GL_DRAW_FRAMEBUFFER_BINDING)), read_(integer(GL_READ_FRAMEBUFFER_BINDING)) {
  if (draw_) gl().bindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  if (read_) gl().bindFramebuffer(GL_READ_FRAMEBUFFER, 0);
}

WindowBinding::~WindowBinding() {
  if (draw_) gl().bindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
  if (read_) gl().bindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
}

bool Context::makeCurrent(Size size) {
  const Size before = size_;
  if (size != before) {
    const auto pixels =
        static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    std::vector<std::uint8_t> buffer(4 * pixels, 0);
    if (before == Size{}) {
      buffer_.swap(buffer);
      size_ = size;
      return attach(size);
    }
    // A window of the new size is a new framebuffer; its draw and read buffer move over.
    if (!isCurrent() && !attach(before)) return false;
    const WindowBinding binding;
    const auto drawBuffer = static_cast<GLenum>(integer(GL_DRAW_BUFFER));
    const auto readBuffer = static_cast<GLenum>(integer(GL_READ_BUFFER));
    buffer_.swap(buffer);
    size_ = size;
    if (!attach(size)) return false;
    useBuffers(drawBuffer, readBuffer);
    return true;
  }
  return attach(size);
}

void Context::useBuffers(GLenum draw, GLenum read) {
  gl().drawBuffer(draw);
  gl().readBuffer(read);
}

ProcOffset findProcOffset() {
  ProcOffset found = nullptr;
  const auto look = [](dl_phdr_info* info, std::size_t, void* result) {
    const std::string_view name = info->dlpi_name ? info->dlpi_name : "";
    for (const char* part : {"libOSMesa", "libglapi", "libgallium"}) {
      if (name.find(part) == name.npos) continue;
      void* const library = dlopen(info->dlpi_name, RTLD_NOW | RTLD_NOLOAD);
      if (!library) continue;
      for (const char* symbol : {"_glapi_get_proc_offset", "_mesa_glapi_get_proc_offset"}) {
        if (void* const function = dlsym(library, symbol)) {
          *static_cast<ProcOffset*>(result) = reinterpret_cast<ProcOffset>(function);
          return 1;
        }
      }
    }
    return 0;
  };
  dl_iterate_phdr(look, &found);
  return found;
}

} // namespace ggrade::capture
