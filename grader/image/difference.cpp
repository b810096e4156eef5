#include "image/difference.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace ggrade {
namespace {

using Colour = std::array<double, 3>;

// The way through colour space: sRGB bytes, joined by straight lines in Oklab.
constexpr std::array<Colour, 5> kStops{
    {{0, 0, 4}, {87, 16, 110}, {188, 55, 84}, {249, 142, 9}, {252, 255, 164}}};

double linearFromSrgb(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}
double srgbFromLinear(double v) {
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

// Matrices of B. Ottosson, "A perceptual color space for image processing", 2020.
Colour oklabFromSrgbBytes(const Colour& bytes) {
  const double r = linearFromSrgb(bytes[0] / 255), g = linearFromSrgb(bytes[1] / 255),
               b = linearFromSrgb(bytes[2] / 255);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Colour srgbFromOklab(const Colour& lab) {
  const auto cube = [](double v) { return v * v * v; };
  const double l = cube(lab[0] + 0.3963377774 * lab[1] + 0.2158037573 * lab[2]);
  const double m = cube(lab[0] - 0.1055613458 * lab[1] - 0.0638541728 * lab[2]);
  const double s = cube(lab[0] - 0.0894841775 * lab[1] - 1.2914855480 * lab[2]);
  const auto encode = [](double v) { return srgbFromLinear(std::clamp(v, 0.0, 1.0)); };
  return {encode(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          encode(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          encode(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

double distance(const Colour& a, const Colour& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

constexpr std::size_t kEntries = 256;

std::vector<std::array<float, 3>> makeTable() {
  std::array<Colour, kStops.size()> stops;
  std::array<double, kStops.size()> along{}; // length of the way up to each stop
  for (std::size_t i = 0; i < stops.size(); ++i) {
    stops[i] = oklabFromSrgbBytes(kStops[i]);
    if (i > 0) along[i] = along[i - 1] + distance(stops[i - 1], stops[i]);
  }
  std::vector<std::array<float, 3>> table;
  for (std::size_t entry = 0; entry < kEntries; ++entry) {
    const double at = along.back() * double(entry) / double(kEntries - 1);
    std::size_t next = 1;
    while (next + 1 < stops.size() && at > along[next]) ++next;
    const double t = (at - along[next - 1]) / (along[next] - along[next - 1]);
    Colour lab;
    for (std::size_t i = 0; i < 3; ++i)
      lab[i] = stops[next - 1][i] + t * (stops[next][i] - stops[next - 1][i]);
    const Colour rgb = srgbFromOklab(lab);
    table.push_back({float(rgb[0]), float(rgb[1]), float(rgb[2])});
  }
  return table;
}

} // namespace

std::array<float, 3> heatColour(float value) {
  if (std::isnan(value)) return {0, 1, 1};
  static const auto table = makeTable();
  const float clamped = std::clamp(value, 0.0f, 1.0f);
  return table[std::size_t(std::lround(clamped * float(kEntries - 1)))];
}

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
