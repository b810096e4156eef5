#pragma once
/// \file
/// The part of a picture where most is wrong: the cure for a small error drowned in a large right
/// background.

#include "image/mask.hpp"

#include <cstddef>

namespace ggrade {

/// A rectangle of pixels, (x,y) its top left corner, and how much in it is set.
struct Window {
  int x = 0, y = 0, width = 0, height = 0;
  std::size_t pixels = 0;       ///< pixels of the mask inside
  int middleX = 0, middleY = 0; ///< middle of the box around those pixels: the place to name
  /// `pixels` over the whole area of the window, 0 to 1, whatever region was looked at: a region of
  /// a few pixels cannot reach a large share (its own share says enough about it).
  double share = 0;
};

/// The window of `side x side` pixels (clipped to the picture's size) that holds most pixels of
/// `mask`, found through a summed-area table (Crow 1984). Among equals the first in row order,
/// moved so that what it holds is in its middle. An empty mask gives a default Window.
Window densestWindow(const Mask& mask, int side = 32);

} // namespace ggrade
