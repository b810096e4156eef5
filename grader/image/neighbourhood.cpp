#include "image/neighbourhood.hpp"

#include <algorithm>

namespace ggrade {
namespace {

void lower(float* __restrict into, const float* __restrict values, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) into[i] = values[i] < into[i] ? values[i] : into[i];
}

void raise(float* __restrict into, const float* __restrict values, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) into[i] = values[i] > into[i] ? values[i] : into[i];
}

} // namespace

NeighbourhoodRows::NeighbourhoodRows(const Image& image, int radius)
    : image_(image), radius_(radius),
      padded_(std::size_t(image.width() + 2 * radius) * std::size_t(image.channels())),
      ringLow_(std::size_t(2 * radius + 1)), ringHigh_(std::size_t(2 * radius + 1)) {}

void NeighbourhoodRows::scanRow(int y) {
  const auto row = image_.row(y);
  const auto channels = std::size_t(image_.channels());
  const auto side = std::size_t(radius_) * channels;
  // Repeating the edge pixel leaves minimum and maximum as if pixels outside did not exist.
  for (std::size_t i = 0; i < side; ++i) {
    padded_[i] = row[i % channels];
    padded_[side + row.size() + i] = row[row.size() - channels + i % channels];
  }
  std::copy(row.begin(), row.end(), padded_.begin() + std::ptrdiff_t(side));

  const auto slot = std::size_t(y) % ringLow_.size();
  auto &low = ringLow_[slot], &high = ringHigh_[slot];
  low.assign(padded_.begin(), padded_.begin() + std::ptrdiff_t(row.size()));
  high = low;
  for (std::size_t shift = channels; shift <= 2 * side; shift += channels) {
    lower(low.data(), padded_.data() + shift, row.size());
    raise(high.data(), padded_.data() + shift, row.size());
  }
}

void NeighbourhoodRows::moveTo(int row) {
  const int first = std::max(0, row - radius_);
  const int last = std::min(image_.height() - 1, row + radius_);
  for (scanned_ = std::max(scanned_, first); scanned_ <= last; ++scanned_) scanRow(scanned_);

  const auto slots = ringLow_.size();
  low_ = ringLow_[std::size_t(first) % slots];
  high_ = ringHigh_[std::size_t(first) % slots];
  for (int y = first + 1; y <= last; ++y) {
    lower(low_.data(), ringLow_[std::size_t(y) % slots].data(), low_.size());
    raise(high_.data(), ringHigh_[std::size_t(y) % slots].data(), high_.size());
  }
}

} // namespace ggrade
