#pragma once

namespace ggrade::capture {

/// Of a window's framebuffer, in pixels.
struct Size {
  int width = 0;
  int height = 0;
  friend bool operator==(const Size&, const Size&) = default;
};

} // namespace ggrade::capture
