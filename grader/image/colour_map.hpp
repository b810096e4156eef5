#pragma once
/// \file
/// Colours for numbers.

#include <array>

namespace ggrade {

/// The sRGB colour (0 to 1) of a number 0 to 1: from near black over violet, red and orange to pale
/// yellow. Perceptually uniform: equal steps are equal distances in Oklab (Ottosson 2020), and
/// lightness only rises, so that it reads the same in grey and to the colour-blind. Numbers beyond
/// 0 to 1 are clamped; NaN is cyan, which is no colour of the map.
std::array<float, 3> heatColour(float value);

} // namespace ggrade
