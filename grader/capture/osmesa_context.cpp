#include "capture/context.hpp"

#include <dlfcn.h>

namespace ggrade::capture {
namespace {

// From GL/osmesa.h, which newer systems don't have.
using OSMesaContext = void*;
constexpr int kOsmesaFormat = 0x22;
constexpr int kOsmesaRgba = 0x1908; // GL_RGBA
constexpr int kOsmesaDepthBits = 0x30;
constexpr int kOsmesaStencilBits = 0x31;
constexpr int kOsmesaProfile = 0x33;
constexpr int kOsmesaCoreProfile = 0x34;
constexpr int kOsmesaCompatProfile = 0x35;
constexpr int kOsmesaMajorVersion = 0x36;
constexpr int kOsmesaMinorVersion = 0x37;

struct OsmesaFunctions {
  OSMesaContext (*create)(const int* attributes, OSMesaContext share) = nullptr;
  void (*destroy)(OSMesaContext context) = nullptr;
  unsigned char (*makeCurrent)(OSMesaContext context, void* buffer, GLenum type, GLsizei width,
                               GLsizei height) = nullptr;
  OSMesaContext (*current)() = nullptr;
  GlFunction (*procAddress)(const char* name) = nullptr;
};

class OsmesaContext : public Context {
public:
  OsmesaContext(const OsmesaFunctions& osmesa, OSMesaContext context)
      : osmesa_(osmesa), context_(context) {}

  ~OsmesaContext() override {
    if (isCurrent()) osmesa_.makeCurrent(nullptr, nullptr, 0, 0, 0);
    osmesa_.destroy(context_);
  }

  void finish() override {
    static const auto glFinish = real<void (*)()>("glFinish");
    // OSMesa copies the window out only while it is the draw framebuffer.
    const WindowBinding binding;
    glFinish();
  }

  void* native() const override { return context_; }

protected:
  bool attach(Size size) override {
    return osmesa_.makeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, size.width, size.height);
  }
  bool isCurrent() const override { return osmesa_.current() == context_; }

private:
  const OsmesaFunctions& osmesa_;
  OSMesaContext context_;
};

class Osmesa : public ContextLibrary {
public:
  explicit Osmesa(void* library)
      : library_(library), functions_{get(functions_.create, "OSMesaCreateContextAttribs"),
                                      get(functions_.destroy, "OSMesaDestroyContext"),
                                      get(functions_.makeCurrent, "OSMesaMakeCurrent"),
                                      get(functions_.current, "OSMesaGetCurrentContext"),
                                      get(functions_.procAddress, "OSMesaGetProcAddress")},
        procOffset_(findProcOffset()) {}

  bool isWhole() const {
    return functions_.create && functions_.destroy && functions_.makeCurrent &&
           functions_.current && functions_.procAddress;
  }

  std::unique_ptr<Context> create(const ContextRequest& request, const Context* share) override {
    const int attributes[] = {kOsmesaFormat,
                              kOsmesaRgba,
                              kOsmesaDepthBits,
                              request.depthBits,
                              kOsmesaStencilBits,
                              request.stencilBits,
                              kOsmesaProfile,
                              request.core ? kOsmesaCoreProfile : kOsmesaCompatProfile,
                              kOsmesaMajorVersion,
                              request.major,
                              kOsmesaMinorVersion,
                              request.minor,
                              0};
    const OSMesaContext context = functions_.create(attributes, share ? share->native() : nullptr);
    if (!context) return nullptr;
    return std::make_unique<OsmesaContext>(functions_, context);
  }

  void clearCurrent() override { functions_.makeCurrent(nullptr, nullptr, 0, 0, 0); }
  void* current() override { return functions_.current(); }

  GlFunction function(const char* name) override {
    if (procOffset_ && procOffset_(name) < 0) return nullptr;
    return functions_.procAddress(name);
  }

  // GL_BACK seems to work there, but glClearBuffer then clears nothing.
  GLenum windowBuffer() const override { return GL_FRONT; }

  void* osmesaFunction(const char* name) override { return dlsym(library_, name); }

private:
  template <typename Function> Function get(Function /*kind*/, const char* name) const {
    return reinterpret_cast<Function>(dlsym(library_, name));
  }

  void* library_;
  OsmesaFunctions functions_;
  ProcOffset procOffset_;
};

} // namespace

std::unique_ptr<ContextLibrary> openOsmesa(std::string& why) {
  void* const library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    why = dlerror();
    return nullptr;
  }
  auto osmesa = std::make_unique<Osmesa>(library);
  if (osmesa->isWhole()) return osmesa;
  why = "libOSMesa.so.8 lacks functions of OSMesa";
  return nullptr;
}

} // namespace ggrade::capture
