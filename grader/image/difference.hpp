#pragma once
/// \file
/// Pictures that show where two images differ.

#include "image/image.hpp"
#include "image/window.hpp"

#include <array>

namespace ggrade {

/// Heat map of |student - reference|, the largest of the colour channels (alpha is left out): RGBA,
/// opaque, 0 to 1. A difference of `fullScale` or more has the brightest colour; NaN is cyan. Empty
/// if the images differ in size or one is empty: there is nothing to show then. Throws
/// std::invalid_argument unless `fullScale` is above 0.
Image differencePicture(const Image& student, const Image& reference, float fullScale = 0.25f);

/// A one-channel image (FLIP's map) through the same colours, which aren't the magma of FLIP's
/// authors: RGBA, opaque. Empty if the map is.
Image heatPicture(const Image& map);

/// Draws a frame of `thickness` pixels just outside `window`, clipped to the image. Alpha, if any,
/// becomes 1; a grey image gets the colour's mean. A window without area draws nothing.
void markWindow(Image& image, const Window& window, std::array<float, 3> colour = {0, 1, 0},
                int thickness = 2);

} // namespace ggrade
