#pragma once
/// \file
/// Smallest and largest value around every pixel.

#include "image/image.hpp"

#include <span>
#include <vector>

namespace ggrade {

/// Walks down an image and holds, for the current row, the minimum and maximum of every channel
/// over the `(2 radius + 1)^2` pixels around each pixel. Pixels outside the image do not count.
/// Separable, so the cost a pixel grows with `radius`, not with its square; memory is a few rows.
class NeighbourhoodRows {
public:
  /// `image` must outlive this object and hold finite values only.
  NeighbourhoodRows(const Image& image, int radius);
  /// Moves down to row `y`; rows must come in ascending order. Rows passed over cost nothing unless
  /// they are neighbours.
  void moveTo(int y);
  /// `width * channels` values of the current row.
  std::span<const float> low() const { return low_; }
  std::span<const float> high() const { return high_; }

private:
  void scanRow(int y);

  const Image& image_;
  int radius_;
  int scanned_ = 0;           // first row that was not yet looked at
  std::vector<float> padded_; // a row with its edge pixels repeated `radius` times
  std::vector<std::vector<float>> ringLow_, ringHigh_; // row y in slot y % (2 radius + 1)
  std::vector<float> low_, high_;
};

} // namespace ggrade
