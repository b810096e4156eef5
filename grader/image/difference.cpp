#include "image/difference.hpp"

#include "image/colour_map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ggrade {

Image differencePicture(const Image& student, const Image& reference, float fullScale) {
  if (!(fullScale > 0))
    throw std::invalid_argument("differencePicture: the full scale must be above 0");
  if (student.empty() || reference.empty() || !sameSize(student, reference)) return {};
  const int channels = std::min({3, student.channels(), reference.channels()});
  Image picture(reference.width(), reference.height(), 4, 1.0f);
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      float largest = 0;
      for (int c = 0; c < channels; ++c) {
        const float error = std::abs(student.at(x, y, c) - reference.at(x, y, c));
        // Once NaN it stays NaN: std::max would drop it.
        if (!(error <= largest) && !std::isnan(largest)) largest = error;
      }
      std::ranges::copy(heatColour(largest / fullScale), picture.pixel(x, y).begin());
    }
  return picture;
}

Image heatPicture(const Image& map) {
  if (map.empty()) return {};
  Image picture(map.width(), map.height(), 4, 1.0f);
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x)
      std::ranges::copy(heatColour(map.at(x, y)), picture.pixel(x, y).begin());
  return picture;
}

void markWindow(Image& image, const Window& window, std::array<float, 3> colour, int thickness) {
  if (window.width <= 0 || window.height <= 0) return;
  const auto paint = [&](int x, int y) {
    const auto pixel = image.pixel(x, y);
    std::ranges::fill(pixel, 1.0f);
    if (pixel.size() < 3)
      pixel[0] = (colour[0] + colour[1] + colour[2]) / 3;
    else
      std::ranges::copy(colour, pixel.begin());
  };
  const int right = window.x + window.width, bottom = window.y + window.height;
  const int x0 = std::max(0, window.x - thickness), x1 = std::min(image.width(), right + thickness);
  const int y0 = std::max(0, window.y - thickness),
            y1 = std::min(image.height(), bottom + thickness);
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      const bool inside = x >= window.x && x < right && y >= window.y && y < bottom;
      if (!inside) paint(x, y);
    }
}

} // namespace ggrade
