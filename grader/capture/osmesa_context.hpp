#pragma once
/// \file
/// A GL context whose window is a memory buffer. The only file pair that knows OSMesa: a context of
/// another kind (EGL without a surface) would stand beside it with the same functions.

#include "capture/gl_hooks.hpp"
#include "capture/run.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace ggrade::capture {

struct ContextRequest {
  bool core = false;
  int major = 1;
  int minor = 0;
  int depthBits = 24;
  int stencilBits = 8;
};

class OsmesaContext {
public:
  /// Null when OSMesa cannot serve the request. `share` may be null.
  static std::unique_ptr<OsmesaContext> create(const ContextRequest& request,
                                               const OsmesaContext* share);
  ~OsmesaContext();
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  /// Makes the context current to the calling thread with a window of this size (pixels, at least
  /// 1). A change of size loses the window's content and keeps its draw and read buffer. False on
  /// failure.
  bool makeCurrent(Size size);
  static void clearCurrent();

  /// Waits for all commands and brings the window's colours into `pixels`. The context must be
  /// current.
  void finish();

  /// width x height x 4 bytes RGBA, row 0 at the bottom, as of the last `finish`.
  const std::uint8_t* pixels() const { return buffer_.data(); }
  Size size() const { return size_; }

  void* native() const { return context_; }

  /// OSMesa's function, or null when OSMesa has none of that name.
  static GlFunction function(const char* name);

private:
  explicit OsmesaContext(void* context) : context_(context) {}
  bool attach(Size size);

  void* context_; ///< OSMesaContext
  Size size_;     ///< empty until it is current for the first time
  std::vector<std::uint8_t> buffer_;
};

} // namespace ggrade::capture
