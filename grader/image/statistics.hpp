#pragma once
/// \file
/// Numbers of two whole pictures, for reports: none of them can grade, because a large right
/// background dilutes what is wrong.

#include "image/image.hpp"

#include <cstddef>

namespace ggrade {

/// Of all pixels and channels alike, as `idiff` prints them and as OpenImageIO's
/// ImageBufAlgo::compare defines them.
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
/// finite (`findNonFinite` first): NaN would read as no difference.
ErrorStatistics errorStatistics(const Image& a, const Image& b, float fail = 1e-6f,
                                float warn = 1e-6f);

/// Structural similarity: mean SSIM of luma (0.2989 R + 0.5870 G + 0.1140 B; alpha is ignored, two
/// channels are averaged), 1 for identical images, exactly. Values are display values 0 to 1;
/// beyond that the constants lose their meaning.
///
/// Wang, Bovik, Sheikh, Simoncelli: "Image Quality Assessment: From Error Visibility to Structural
/// Similarity", IEEE TIP 13(4), 2004: Gaussian window of 11x11, sigma 1.5, K1 0.01, K2 0.03, L 1,
/// no downsampling, averaged over the windows that lie wholly inside the image. In a picture less
/// than 11 wide or high the window is the largest odd size that fits.
///
/// Throws std::invalid_argument if the sizes differ or an image is empty. Not for scores: a missing
/// small shadow has 0.998, a harmless shift by one pixel 0.958. A NaN makes the result NaN.
double ssim(const Image& a, const Image& b);

} // namespace ggrade
