#pragma once
/// \file
/// Structural similarity, for the report's number.

#include "image/image.hpp"

namespace ggrade {

/// Mean SSIM of luma (0.2989 R + 0.5870 G + 0.1140 B; alpha is ignored, two channels are averaged),
/// 1 for identical images, exactly. Values are display values 0 to 1; beyond that the constants
/// lose their meaning.
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
