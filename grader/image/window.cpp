#include "image/window.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace ggrade {
namespace {

// Entry (x,y) is the number of pixels above and left of corner (x,y).
class SummedArea {
public:
  explicit SummedArea(const Mask& mask)
      : stride_(std::size_t(mask.width()) + 1), sums_(stride_ * (std::size_t(mask.height()) + 1)) {
    for (int y = 0; y < mask.height(); ++y) {
      const auto row = mask.row(y);
      std::uint32_t rowSum = 0;
      for (int x = 0; x < mask.width(); ++x) {
        rowSum += row[std::size_t(x)];
        sums_[index(x + 1, y + 1)] = sums_[index(x + 1, y)] + rowSum;
      }
    }
  }
  std::uint32_t inside(int x, int y, int width, int height) const {
    return sums_[index(x + width, y + height)] - sums_[index(x, y + height)] -
           sums_[index(x + width, y)] + sums_[index(x, y)];
  }

private:
  std::size_t index(int x, int y) const { return std::size_t(y) * stride_ + std::size_t(x); }

  std::size_t stride_;
  std::vector<std::uint32_t> sums_;
};

// Finds the middle of the box around the window's pixels; moves the window there if that loses
// none.
void centre(Window& window, const Mask& mask, const SummedArea& sums) {
  int left = mask.width(), right = -1, top = mask.height(), bottom = -1;
  for (int y = window.y; y < window.y + window.height; ++y)
    for (int x = window.x; x < window.x + window.width; ++x)
      if (mask.at(x, y)) {
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = std::max(bottom, y);
      }
  window.middleX = (left + right) / 2;
  window.middleY = (top + bottom) / 2;
  const int x = std::clamp((left + right + 1 - window.width) / 2, 0, mask.width() - window.width);
  const int y =
      std::clamp((top + bottom + 1 - window.height) / 2, 0, mask.height() - window.height);
  if (sums.inside(x, y, window.width, window.height) < window.pixels) return;
  window.x = x;
  window.y = y;
}

} // namespace

Window densestWindow(const Mask& mask, int side) {
  if (side < 1) throw std::invalid_argument("densestWindow: the side must be at least 1");
  Window best;
  if (mask.count() == 0) return best;
  best.width = std::min(side, mask.width());
  best.height = std::min(side, mask.height());
  const SummedArea sums(mask);
  for (int y = 0; y + best.height <= mask.height(); ++y)
    for (int x = 0; x + best.width <= mask.width(); ++x) {
      const std::size_t pixels = sums.inside(x, y, best.width, best.height);
      if (pixels <= best.pixels) continue;
      best.pixels = pixels;
      best.x = x;
      best.y = y;
    }
  centre(best, mask, sums);
  best.share = double(best.pixels) / (double(best.width) * double(best.height));
  return best;
}

} // namespace ggrade
