#pragma once
/// \file
/// Pictures that show where two images differ.

#include "image/image.hpp"
#include "image/mask.hpp"

#include <array>

namespace ggrade {

/// The sRGB colour (0 to 1) of a number 0 to 1: from near black over violet, red and orange to pale
/// yellow. Perceptually uniform: equal steps are equal distances in Oklab (Ottosson 2020), and
/// lightness only rises, so that it reads the same in grey and to the colour-blind. Numbers beyond
/// 0 to 1 are clamped; NaN is cyan, which is no colour of the map.
std::array<float, 3> heatColour(float value);

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
