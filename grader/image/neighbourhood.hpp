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
  /// Moves to the next row; the first call moves to row 0.
  void advance();
  /// `width * channels` values of the current row.
  std::span<const float> low() const { return low_; }
  std::span<const float> high() const { return high_; }

private:
  void scanRow(int y);

  const Image& image_;
  int radius_;
  int row_ = -1;
  int scanned_ = 0;           // rows whose horizontal range is in the ring, from the top
  std::vector<float> padded_; // a row with its edge pixels repeated `radius` times
  std::vector<std::vector<float>> ringLow_, ringHigh_; // row y in slot y % (2 radius + 1)
  std::vector<float> low_, high_;
};

} // namespace ggrade
