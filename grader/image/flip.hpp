#pragma once
/// \file
/// FLIP: how much two pictures differ to somebody who flips between them. For the report's number
/// and heat map, never for scores: a small missing shadow hardly moves the mean.
///
/// Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: "FLIP: A Difference Evaluator
/// for Alternating Images", Proc. ACM CGIT 3(2), 2020, doi 10.1145/3406183. Andersson, Nilsson,
/// Shirley, Akenine-Moller: "Visualizing Errors in Rendered High Dynamic Range Images",
/// Eurographics short papers, 2021, doi 10.2312/egs.20211015.

#include "image/image.hpp"

namespace ggrade {

/// Pixels that one degree of the viewer's sight covers under the paper's conditions: a screen 0.7 m
/// and 3840 pixels wide, seen from 0.7 m. The paper's 67, unrounded.
inline constexpr double kFlipPixelsPerDegree = 67.02064327658226;
inline constexpr double kFlipMinPixelsPerDegree = 1, kFlipMaxPixelsPerDegree = 1000;

/// What FLIP found, 0 (no difference to be seen) to 1.
struct Flip {
  double mean = 0;
  Image map; ///< an error a pixel, one channel
};

/// FLIP of display values (sRGB, 0 to 1; what lies outside is clamped). Identical images give
/// exactly 0. One channel is grey, alpha is ignored.
///
/// Throws std::invalid_argument if the sizes differ, an image is empty or has 2 channels, a colour
/// is NaN or infinite, or `pixelsPerDegree` is not 1 to 1000. The time goes with the area of the
/// box around the pixels that differ: around it the error is 0.
Flip ldrFlip(const Image& student, const Image& reference,
             double pixelsPerDegree = kFlipPixelsPerDegree);

/// Exposures that HDR-FLIP looks at: `count` of them from `start` to `stop`, in equal steps, in
/// stops (powers of two).
struct Exposures {
  double start = 0, stop = 0;
  int count = 2;
};

/// Most exposures that are looked at: a range of more stops is looked at in larger steps.
inline constexpr int kFlipMaxExposures = 40;

/// The paper's choice: from where the reference's largest luminance reaches 0.85 of white after
/// tone mapping (ACES, Narkowicz 2016) to where its median does, a stop apart. Where the paper
/// leaves it open: values below 0 count as 0; if the median is 0 it is taken over the pixels that
/// are not black; a black reference is looked at as it is. Throws like `hdrFlip`.
Exposures flipExposures(const Image& reference);

/// FLIP of linear RGB of any range: the largest LDR error over `flipExposures(reference)`. Negative
/// light counts as none. Not symmetric: the reference chooses the exposures. Throws like `ldrFlip`.
Flip hdrFlip(const Image& student, const Image& reference,
             double pixelsPerDegree = kFlipPixelsPerDegree);

} // namespace ggrade
