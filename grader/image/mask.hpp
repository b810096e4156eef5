#pragma once
/// \file
/// Which pixels of a picture a comparison looks at, and the part of it where most of them are.

#include "image/image.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ggrade {

/// `width x height` flags, row 0 on top.
class Mask {
public:
  Mask() = default;
  /// Throws std::invalid_argument unless both sides are 1 to Image::kMaxSide.
  Mask(int width, int height, bool value = false);

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return flags_.empty(); }

  bool at(int x, int y) const { return flags_[index(x, y)] != 0; }
  void set(int x, int y, bool value = true) { flags_[index(x, y)] = value ? 1 : 0; }
  /// One byte a pixel, 0 or 1.
  std::span<const std::uint8_t> row(int y) const {
    return {&flags_[index(0, y)], std::size_t(width_)};
  }
  /// For writing: nothing but 0 and 1.
  std::span<std::uint8_t> row(int y) { return {&flags_[index(0, y)], std::size_t(width_)}; }
  /// Number of pixels inside.
  std::size_t count() const;

  friend bool operator==(const Mask&, const Mask&) = default;

private:
  std::size_t index(int x, int y) const {
    return std::size_t(y) * std::size_t(width_) + std::size_t(x);
  }

  int width_ = 0, height_ = 0;
  std::vector<std::uint8_t> flags_;
};

/// Pixels in both, in either, in the other. Throw std::invalid_argument if the sizes differ.
Mask operator&(const Mask& a, const Mask& b);
Mask operator|(const Mask& a, const Mask& b);
Mask operator~(const Mask& mask);

/// Grows the mask by a square of `radius` pixels on every side.
Mask dilate(const Mask& mask, int radius);
/// Shrinks the mask likewise. The picture's border does not shrink it: `erode(m, r)` is
/// `~dilate(~m, r)`.
Mask erode(const Mask& mask, int radius);

/// Pixels where any of the first `channels` channels (0: all) differs by more than `threshold`, or
/// where only one of the images is finite. Throws std::invalid_argument if sizes or channels
/// differ.
Mask differenceMask(const Image& a, const Image& b, float threshold, int channels = 0);

/// A rectangle of pixels, (x,y) its top left corner, and how much in it is set.
struct Window {
  int x = 0, y = 0, width = 0, height = 0;
  std::size_t pixels = 0;       ///< pixels of the mask inside
  int middleX = 0, middleY = 0; ///< middle of the box around those pixels: the place to name
  /// `pixels` over the whole area of the window, 0 to 1, whatever region was looked at: a region of
  /// a few pixels cannot reach a large share (its own share says enough about it).
  double share = 0;
};

/// The cure for a small error drowned in a large right background: the window of `side x side`
/// pixels (clipped to the picture's size) that holds most pixels of `mask`, found through a
/// summed-area table (Crow 1984). Among equals the first in row order, moved so that what it holds
/// is in its middle. An empty mask gives a default Window.
Window densestWindow(const Mask& mask, int side = 32);

} // namespace ggrade
