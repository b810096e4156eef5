#pragma once
/// \file
/// Pixel-by-pixel numbers as `idiff` of OpenImageIO prints them. For reports: none of them can
/// grade, because a large right background dilutes what is wrong.

#include "image/image.hpp"

#include <cstddef>

namespace ggrade {

/// Of all pixels and channels alike, as OpenImageIO's ImageBufAlgo::compare defines them.
struct ErrorStatistics {
  double meanError = 0; ///< mean of |a - b|
  double rmsError = 0;  ///< root of the mean of (a - b)^2
  double psnr =
      0; ///< dB: 20 log10(peak / rmsError), peak the largest magnitude, at least 1; may be infinite
  double maxError = 0;
  int maxX = 0, maxY = 0, maxChannel = 0; ///< the first place in row order with that error
  std::size_t failPixels = 0;             ///< pixels with any channel off by more than `fail`
  std::size_t warnPixels = 0;             ///< likewise `warn`
};

/// Throws std::invalid_argument if sizes or channels differ or an image is empty. Values must be
/// finite
/// (`findNonFinite` first): NaN would read as no difference.
ErrorStatistics errorStatistics(const Image& a, const Image& b, float fail = 1e-6f,
                                float warn = 1e-6f);

} // namespace ggrade
