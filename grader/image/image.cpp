#include "image/image.hpp"

#include "words/words.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <malloc.h>
#include <stdexcept>

namespace ggrade {
namespace {

// `store(source index, destination index)` for every row of values, turned so that the top is
// first.
template <class Store>
void storeRows(const Image& image, std::size_t given, RowOrder order, Store store) {
  if (given != image.values().size())
    throw std::invalid_argument("Image: " + std::to_string(given) + " values given, " +
                                image.sizeText() + "x" + std::to_string(image.channels()) +
                                " needs " + std::to_string(image.values().size()));
  const std::size_t length = image.values().size() / std::size_t(image.height());
  for (int y = 0; y < image.height(); ++y) {
    const int from = order == RowOrder::topFirst ? y : image.height() - 1 - y;
    store(std::size_t(from) * length, y, length);
  }
}

} // namespace

Image::Image(int width, int height, int channels, float value) {
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide || channels < 1 ||
      channels > 4)
    throw std::invalid_argument("Image: " + std::to_string(width) + "x" + std::to_string(height) +
                                " with " + std::to_string(channels) +
                                " channels is not possible: sides are 1 to " +
                                std::to_string(kMaxSide) + ", channels 1 to 4");
  width_ = width;
  height_ = height;
  channels_ = channels;
  values_.assign(pixelCount() * std::size_t(channels), value);
}

Image Image::fromBytes(std::span<const std::uint8_t> bytes, int width, int height, int channels,
                       RowOrder order) {
  Image image(width, height, channels);
  storeRows(image, bytes.size(), order, [&](std::size_t from, int y, std::size_t length) {
    float* out = image.row(y).data();
    for (std::size_t i = 0; i < length; ++i) out[i] = float(bytes[from + i]) / 255.0f;
  });
  return image;
}

Image Image::fromFloats(std::span<const float> values, int width, int height, int channels,
                        RowOrder order) {
  Image image(width, height, channels);
  storeRows(image, values.size(), order, [&](std::size_t from, int y, std::size_t length) {
    std::copy_n(values.begin() + std::ptrdiff_t(from), length, image.row(y).begin());
  });
  return image;
}

std::string Image::sizeText() const {
  return std::to_string(width_) + "x" + std::to_string(height_);
}

bool sameSize(const Image& a, const Image& b) {
  return a.width() == b.width() && a.height() == b.height();
}

Image firstChannels(const Image& image, int channels) {
  if (channels > image.channels())
    throw std::invalid_argument("firstChannels: the image has only " +
                                std::to_string(image.channels()) + " channels");
  Image result(image.width(), image.height(), channels);
  const float* from = image.values().data();
  float* to = result.values().data();
  for (std::size_t i = 0; i < image.pixelCount(); ++i, from += image.channels(), to += channels)
    for (int c = 0; c < channels; ++c) to[c] = from[c];
  return result;
}

std::string NonFinite::text(int imageChannels) const {
  const char* kind = std::isnan(value) ? "NaN" : value > 0 ? "Inf" : "-Inf";
  const char in = channelName(channel, imageChannels);
  return pixels == 1 ? gg::say("1 pixel holds NaN or Inf, the first {} at ({},{}), channel {}",
                               kind, x, y, in)
                     : gg::say("{} pixels hold NaN or Inf, the first {} at ({},{}), channel {}",
                               pixels, kind, x, y, in);
}

std::optional<NonFinite> findNonFinite(const Image& image, int channels) {
  const int looked = channels == 0 ? image.channels() : std::min(channels, image.channels());
  NonFinite found;
  for (int y = 0; y < image.height(); ++y) {
    // Nearly every row is finite: one pass that vectorises tells whether this one needs a closer
    // look.
    constexpr std::uint32_t exponent = 0x7f800000; // all ones in NaN and Inf only
    std::uint32_t anyBad = 0;
    for (const float value : image.row(y))
      anyBad |= std::uint32_t((std::bit_cast<std::uint32_t>(value) & exponent) == exponent);
    if (anyBad == 0) continue;
    for (int x = 0; x < image.width(); ++x) {
      const auto pixel = image.pixel(x, y).first(std::size_t(looked));
      const auto bad =
          std::find_if(pixel.begin(), pixel.end(), [](float v) { return !std::isfinite(v); });
      if (bad == pixel.end()) continue;
      if (found.pixels++ == 0) {
        found.x = x;
        found.y = y;
        found.channel = int(bad - pixel.begin());
        found.value = *bad;
      }
    }
  }
  if (found.pixels == 0) return std::nullopt;
  return found;
}

char channelName(int channel, int channels) {
  return channels == 1 ? 'Y' : "RGBA"[channel];
}

void keepFreedMemory() {
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
}

} // namespace ggrade
