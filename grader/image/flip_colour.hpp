#pragma once
/// \file
/// FLIP's colours: from linear RGB to the distance that people see. Rows of floats, in place.

#include <array>

namespace ggrade::flip {

/// Three rows of `length` floats: R, G, B or X, Y, Z.
using Rows = std::array<float*, 3>;

/// Linear sRGB to XYZ relative to white (D65), which is (1, 1, 1), and back.
void xyzFromRgb(const Rows& rgb, int length);
void rgbFromXyz(const Rows& xyz, int length);

/// Relative XYZ, 0 to 1, to CIELAB whose a and b are multiplied by L / 100: colours look the more
/// colourful the brighter they are (Hunt).
void huntLabFromXyz(const Rows& xyz, int length);

/// HyAB's distance of two such colours (section 4.1.2 of the paper): lightness apart from the rest.
float hyab(const std::array<float, 3>& a, const std::array<float, 3>& b);

/// A distance as an error 0 to 1 (section 4.1.3): most of the range goes to the differences that
/// are met most often; 1 is the distance of green and blue.
float colourError(float distance);

} // namespace ggrade::flip
