#include "report/picture.hpp"

#include "image/png.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace ggrade::report {
namespace {

std::array<float, 3> colourAt(const Image& image, int x, int y) {
  const auto pixel = image.pixel(x, y);
  if (image.channels() < 3) return {pixel[0], pixel[0], pixel[0]};
  return {pixel[0], pixel[1], pixel[2]};
}

Image withoutAlpha(const Image& image) {
  Image rgb(image.width(), image.height(), 3);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      std::ranges::copy(colourAt(image, x, y), rgb.pixel(x, y).begin());
  return rgb;
}

// Mean of the source pixels [x0,x1) x [y0,y1). What isn't a number counts as black, as in a PNG.
std::array<float, 3> mean(const Image& image, int x0, int x1, int y0, int y1) {
  std::array<double, 3> sum{};
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      const auto colour = colourAt(image, x, y);
      for (std::size_t c = 0; c < 3; ++c)
        if (std::isfinite(colour[c])) sum[c] += std::clamp(colour[c], 0.0f, 1.0f);
    }
  const double count = double(x1 - x0) * (y1 - y0);
  return {float(sum[0] / count), float(sum[1] / count), float(sum[2] / count)};
}

} // namespace

std::string base64(std::span<const unsigned char> bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string pngDataUri(const Image& image) {
  if (image.empty()) return "";
  const bool plain = image.channels() == 1 || image.channels() == 3;
  return "data:image/png;base64," +
         base64(encodePng(plain ? image : withoutAlpha(image), PngEffort::fast));
}

Image thumbnail(const Image& image, int maxWidth, int maxHeight) {
  if (image.empty()) return {};
  const double scale =
      std::min({1.0, double(maxWidth) / image.width(), double(maxHeight) / image.height()});
  const int width = std::max(1, int(std::lround(image.width() * scale)));
  const int height = std::max(1, int(std::lround(image.height() * scale)));
  Image small(width, height, 3);
  const auto edge = [](int i, int count, int size) { return int(std::int64_t(i) * size / count); };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto colour =
          mean(image, edge(x, width, image.width()), edge(x + 1, width, image.width()),
               edge(y, height, image.height()), edge(y + 1, height, image.height()));
      std::ranges::copy(colour, small.pixel(x, y).begin());
    }
  return small;
}

} // namespace ggrade::report
