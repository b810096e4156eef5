#pragma once
/// \file
/// A picture as plain floats: what every comparison, mask and report works on.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ggrade {

/// Which row of a buffer comes first. OpenGL and the capture channel have the bottom row first.
enum class RowOrder { topFirst, bottomFirst };

/// `width x height x channels` floats, channels interleaved, row 0 on top. 8-bit values become 0 to
/// 1; float values are as stored. A default-constructed image is empty (no frame came).
class Image {
public:
  static constexpr int kMaxSide = 16384; ///< pixels
  /// Most pixels that a reader of files accepts: 1 GiB of RGBA. Larger is a mistake or an attack.
  static constexpr std::size_t kMaxFilePixels = std::size_t(1) << 26;

  Image() = default;
  /// Every value is `value`. Throws std::invalid_argument unless both sides are 1 to kMaxSide and
  /// `channels` is 1 to 4.
  Image(int width, int height, int channels, float value = 0);
  /// Bytes 0 to 255 become 0 to 1. Throws std::invalid_argument if `bytes` does not hold exactly
  /// `width * height * channels` values.
  static Image fromBytes(std::span<const std::uint8_t> bytes, int width, int height,
                         int channels = 4, RowOrder order = RowOrder::topFirst);
  /// Floats are copied as they are. Throws like `fromBytes`.
  static Image fromFloats(std::span<const float> values, int width, int height, int channels,
                          RowOrder order = RowOrder::topFirst);

  int width() const { return width_; }
  int height() const { return height_; }
  int channels() const { return channels_; }
  bool empty() const { return values_.empty(); }
  std::size_t pixelCount() const { return std::size_t(width_) * std::size_t(height_); }

  float& at(int x, int y, int channel = 0) { return values_[index(x, y, channel)]; }
  float at(int x, int y, int channel = 0) const { return values_[index(x, y, channel)]; }
  /// The `channels()` values of one pixel.
  std::span<float> pixel(int x, int y) {
    return {&values_[index(x, y, 0)], std::size_t(channels_)};
  }
  std::span<const float> pixel(int x, int y) const {
    return {&values_[index(x, y, 0)], std::size_t(channels_)};
  }
  /// The `width() * channels()` values of one row.
  std::span<float> row(int y) { return {&values_[index(0, y, 0)], rowLength()}; }
  std::span<const float> row(int y) const { return {&values_[index(0, y, 0)], rowLength()}; }
  std::span<float> values() { return values_; }
  std::span<const float> values() const { return values_; }

  /// "640x480", for messages.
  std::string sizeText() const;

private:
  std::size_t rowLength() const { return std::size_t(width_) * std::size_t(channels_); }
  std::size_t index(int x, int y, int channel) const {
    return (std::size_t(y) * std::size_t(width_) + std::size_t(x)) * std::size_t(channels_) +
           std::size_t(channel);
  }

  int width_ = 0, height_ = 0, channels_ = 0;
  std::vector<float> values_;
};

bool sameSize(const Image& a, const Image& b);
/// The image with its first `channels` channels only. Throws std::invalid_argument if it has fewer.
Image firstChannels(const Image& image, int channels);

/// Where an image holds NaN or infinity.
struct NonFinite {
  std::size_t pixels = 0; ///< pixels with such a value in any channel looked at
  int x = -1, y = -1;     ///< the first of them in row order, row 0 on top
  int channel = -1;
  float value = 0; ///< NaN, +Inf or -Inf

  /// "12 pixels hold NaN or Inf, the first NaN at (3,4), channel G".
  std::string text(int imageChannels) const;
};

/// Looks for NaN and Inf in the first `channels` channels (0: all). Empty when every value is
/// finite.
std::optional<NonFinite> findNonFinite(const Image& image, int channels = 0);

/// R, G, B, A; Y for the only channel of a grey image.
char channelName(int channel, int channels);

/// Pictures of a few megabytes come and go all the time. Keeps their pages with this process
/// instead of handing them back to the system and asking for them again: a third of the time of
/// judging.
void keepFreedMemory();

} // namespace ggrade
