#include "image/mask.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace ggrade {
namespace {

template <class Combine> Mask combined(const Mask& a, const Mask& b, Combine combine) {
  if (a.width() != b.width() || a.height() != b.height())
    throw std::invalid_argument("Mask: sizes differ: " + std::to_string(a.width()) + "x" +
                                std::to_string(a.height()) + " and " + std::to_string(b.width()) +
                                "x" + std::to_string(b.height()));
  Mask result = a;
  for (int y = 0; y < a.height(); ++y)
    std::ranges::transform(a.row(y), b.row(y), result.row(y).begin(), combine);
  return result;
}

// Grows a row one way, from its first pixel to its last or back. The cost does not depend on the
// radius: only the distance to the last pixel inside is carried along.
template <class In, class Out> void dilateRow(In in, In end, Out out, int radius) {
  for (int sinceInside = radius + 1; in != end; ++in, ++out) {
    sinceInside = *in ? 0 : sinceInside + 1;
    *out |= std::uint8_t(sinceInside <= radius);
  }
}

// The same down or up, for all columns at a time: rows lie in memory, columns don't.
void dilateColumns(const Mask& from, Mask& into, int radius, bool down) {
  const int height = from.height();
  std::vector<int> sinceInside(from.row(0).size(), radius + 1);
  for (int i = 0; i < height; ++i) {
    const int y = down ? i : height - 1 - i;
    const std::uint8_t* in = from.row(y).data();
    std::uint8_t* out = into.row(y).data();
    int* since = sinceInside.data();
    for (std::size_t x = 0; x < sinceInside.size(); ++x) {
      since[x] = in[x] ? 0 : since[x] + 1;
      out[x] |= std::uint8_t(since[x] <= radius);
    }
  }
}

// For every pixel of `channels` flags: does one of the first `looked` hold?
template <int channels, int looked>
void anyOf(const std::uint8_t* flags, std::span<std::uint8_t> out) {
  for (std::size_t x = 0; x < out.size(); ++x, flags += channels)
    for (int c = 0; c < looked; ++c) out[x] |= flags[c];
}

} // namespace

Mask::Mask(int width, int height, bool value) {
  if (width < 1 || height < 1 || width > Image::kMaxSide || height > Image::kMaxSide)
    throw std::invalid_argument("Mask: " + std::to_string(width) + "x" + std::to_string(height) +
                                " is not possible");
  width_ = width;
  height_ = height;
  flags_.assign(std::size_t(width) * std::size_t(height), value ? 1 : 0);
}

std::size_t Mask::count() const {
  return std::accumulate(flags_.begin(), flags_.end(), std::size_t(0));
}

Mask operator&(const Mask& a, const Mask& b) {
  return combined(a, b, std::bit_and<std::uint8_t>());
}
Mask operator|(const Mask& a, const Mask& b) {
  return combined(a, b, std::bit_or<std::uint8_t>());
}
Mask operator~(const Mask& mask) {
  return combined(mask, mask, [](std::uint8_t inside, std::uint8_t) { return inside ^ 1; });
}

Mask dilate(const Mask& mask, int radius) {
  if (radius < 0) throw std::invalid_argument("dilate: the radius is negative");
  Mask wide = mask;
  for (int y = 0; y < mask.height(); ++y) {
    const auto in = mask.row(y);
    const auto out = wide.row(y);
    dilateRow(in.begin(), in.end(), out.begin(), radius);
    dilateRow(in.rbegin(), in.rend(), out.rbegin(), radius);
  }
  Mask result = wide;
  for (const bool down : {true, false}) dilateColumns(wide, result, radius, down);
  return result;
}

Mask erode(const Mask& mask, int radius) {
  return ~dilate(~mask, radius);
}

Mask differenceMask(const Image& a, const Image& b, float threshold, int channels) {
  if (!sameSize(a, b) || a.channels() != b.channels())
    throw std::invalid_argument("differenceMask: " + a.sizeText() + "x" +
                                std::to_string(a.channels()) + " and " + b.sizeText() + "x" +
                                std::to_string(b.channels()) + " differ");
  const int looked = channels == 0 ? a.channels() : std::min(channels, a.channels());
  Mask mask(a.width(), a.height());
  // Without branches and over a whole row of values at a time: so the compiler can use vectors.
  std::vector<std::uint8_t> differs(a.row(0).size());
  for (int y = 0; y < a.height(); ++y) {
    const float* p = a.row(y).data();
    const float* q = b.row(y).data();
    for (std::size_t i = 0; i < differs.size(); ++i) {
      // Written so that NaN against a number is a difference; equal infinities are not one.
      const bool bothNaN = (p[i] != p[i]) & (q[i] != q[i]);
      differs[i] = (p[i] != q[i]) & !bothNaN & !(std::abs(p[i] - q[i]) <= threshold);
    }
    const auto flags = mask.row(y);
    if (a.channels() == 3 && looked == 3)
      anyOf<3, 3>(differs.data(), flags);
    else if (a.channels() == 4 && looked == 3)
      anyOf<4, 3>(differs.data(), flags);
    else
      for (std::size_t x = 0; x < flags.size(); ++x)
        for (int c = 0; c < looked; ++c)
          flags[x] |= differs[x * std::size_t(a.channels()) + std::size_t(c)];
  }
  return mask;
}

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
