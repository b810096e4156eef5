#pragma once
/// \file
/// Pictures that show what a copy holds, whatever its format.

#include "trace/trace.hpp"

#include <optional>
#include <string>

namespace ggrade::trace {

/// A picture of a copy for people. Where a value is NaN the pixel is magenta, where it is infinite
/// (and nowhere NaN) cyan.
struct CopyPicture {
  Image rgb; ///< 3 channels, 0 to 1
  /// What the picture's values mean:
  /// - "as stored": 0 to 1, values beyond clamped.
  /// - "divided by the greatest value": of colours above 1; black is 0, white `high`.
  /// - "stretched depth": `evenDepth` between the nearest that was drawn, black, and the farthest,
  ///   white, as everything at 1 is; `low` and `high` are their depths as stored.
  /// - "stretched depth by NAME": the same picture; `low` and `high` are distances from the eye,
  ///   found through the matrix NAME.
  /// - "a colour a value": integers and stencil; black is 0, equal colours are equal values.
  std::string scale;
  double low = 0, high = 1;
};

/// Depth 0 to 1 as -log2(1 - depth + 2^-12) / 12, from 0 to 1: even steps of distance in place of
/// the last thousandths where a perspective puts everything. All pictures of depth are made of it,
/// also those of the running program (framework/src/overlay.cpp).
double evenDepth(double depth);

/// Throws UsageError when the file of copies can't be read.
CopyPicture picture(const Trace& trace, const CopyRecord& copy);

/// How depth 0 to 1 becomes distance from the eye: `numerator / (2 * depth - 1 - offset)`.
struct DepthScale {
  std::string matrix; ///< the uniform it was found in
  double numerator = 0, offset = 0;

  double distance(double depth) const { return numerator / (2 * depth - 1 - offset); }
};

/// Of the perspective projection that the pass was drawn with: taken from a matrix that is one,
/// else from one that is the product of a projection and something affine. Nothing where no matrix
/// is perspective; a projection with an oblique near plane isn't either.
std::optional<DepthScale> depthScale(const Trace& trace, const PassRecord& pass);

} // namespace ggrade::trace
