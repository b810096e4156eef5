#include "image/flip.hpp"

#include "image/flip_colour.hpp"
#include "image/flip_filters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace ggrade {
namespace {

using flip::Plane;
using flip::Rows;
using Planes = std::array<Plane, 3>;

constexpr double kLuminance[3] = {0.2126, 0.7152, 0.0722};

void check(const Image& image, const char* whose) {
  if (image.empty()) throw std::invalid_argument(std::string("FLIP: there is no ") + whose);
  if (image.channels() == 2)
    throw std::invalid_argument(std::string("FLIP: two channels are no colour (the ") + whose +
                                ")");
  if (const auto bad = findNonFinite(image, std::min(3, image.channels())))
    throw std::invalid_argument(std::string("FLIP: the ") + whose + ": " +
                                bad->text(image.channels()));
}

void check(const Image& student, const Image& reference, double ppd) {
  check(student, "image");
  check(reference, "reference image");
  if (!sameSize(student, reference))
    throw std::invalid_argument("FLIP: the image is " + student.sizeText() + ", the reference " +
                                reference.sizeText());
  if (!(ppd >= kFlipMinPixelsPerDegree && ppd <= kFlipMaxPixelsPerDegree))
    throw std::invalid_argument("FLIP: pixels per degree must be 1 to 1000");
}

struct Box {
  int x0, y0, x1, y1; // x1 and y1 lie outside
  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
};

// The colour of a pixel: grey has one channel.
std::array<float, 3> colour(const Image& image, int x, int y) {
  const auto pixel = image.pixel(x, y);
  if (pixel.size() < 3) return {pixel[0], pixel[0], pixel[0]};
  return {pixel[0], pixel[1], pixel[2]};
}

// The box around the pixels whose colours differ, empty (x1 <= x0) if there is none.
Box differing(const Image& a, const Image& b) {
  Box box{a.width(), a.height(), 0, 0};
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const auto p = colour(a, x, y), q = colour(b, x, y);
      if (p == q) continue;
      box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x + 1),
             std::max(box.y1, y + 1)};
    }
  return box;
}

// The box and `by` pixels around it, as far as the image goes.
Box grown(const Box& box, int by, const Image& image) {
  return {std::max(0, box.x0 - by), std::max(0, box.y0 - by), std::min(image.width(), box.x1 + by),
          std::min(image.height(), box.y1 + by)};
}

// Three planes of the box's colours, each value through `convert`.
template <class Convert> Planes planesOf(const Image& image, const Box& box, Convert convert) {
  const auto stride = std::size_t(image.channels());
  Planes planes;
  for (std::size_t c = 0; c < 3; ++c) {
    planes[c] = Plane(box.width(), box.height());
    for (int y = 0; y < box.height(); ++y) {
      const float* from = &image.pixel(box.x0, box.y0 + y)[stride < 3 ? 0 : c];
      float* row = planes[c].row(y);
      for (int x = 0; x < box.width(); ++x) row[x] = convert(from[std::size_t(x) * stride]);
    }
  }
  return planes;
}

float linearFromSrgb(float v) {
  return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

// Nearly all images come from bytes, whose 256 values are known.
class Decoder {
public:
  Decoder() {
    for (std::size_t i = 0; i < linear_.size(); ++i) {
      values_[i] = float(i) / 255.0f;
      linear_[i] = linearFromSrgb(values_[i]);
    }
  }
  float operator()(float value) const {
    const float v = std::clamp(value, 0.0f, 1.0f);
    const int byte = int(v * 255 + 0.5f);
    return values_[std::size_t(byte)] == v ? linear_[std::size_t(byte)] : linearFromSrgb(v);
  }

private:
  std::array<float, 256> values_, linear_;
};

// YCxCz of linear RGB 0 to 1, without its factors and offsets, which cancel.
struct Opponent {
  Plane cx, y, cz;
};

Opponent opponent(Planes rgb) {
  const int width = rgb[0].width;
  for (int row = 0; row < rgb[0].height; ++row) {
    const Rows v{rgb[0].row(row), rgb[1].row(row), rgb[2].row(row)};
    flip::xyzFromRgb(v, width);
    for (int i = 0; i < width; ++i) {
      v[0][i] -= v[1][i];
      v[2][i] = v[1][i] - v[2][i];
    }
  }
  return {std::move(rgb[0]), std::move(rgb[1]), std::move(rgb[2])};
}

struct Filters {
  flip::SpatialFilters spatial;
  flip::FeatureFilters feature;
};

// One image after all that is done along rows; gives the rest row by row.
class Filtered {
public:
  Filtered(const Opponent& image, const Filters& filters)
      : filters_(filters), width_(image.y.width), y_(alongRows(image.y, filters.spatial.y)),
        cx_(alongRows(image.cx, filters.spatial.cx)),
        cz1_(alongRows(image.cz, filters.spatial.cz1)),
        cz2_(alongRows(image.cz, filters.spatial.cz2)),
        gauss_(alongRows(image.y, filters.feature.gauss)),
        edge_(alongRows(image.y, filters.feature.edge)),
        point_(alongRows(image.y, filters.feature.point)) {
    for (auto* row : {&x_, &luminance_, &z_, &z2_, &edges_, &points_, &down_})
      row->resize(std::size_t(width_));
  }

  void advance(int y) {
    const auto& spatial = filters_.spatial;
    alongColumns(cx_, spatial.cx, y, x_.data());
    alongColumns(y_, spatial.y, y, luminance_.data());
    alongColumns(cz1_, spatial.cz1, y, z_.data());
    alongColumns(cz2_, spatial.cz2, y, z2_.data());
    for (std::size_t i = 0; i < x_.size(); ++i) {
      x_[i] += luminance_[i];
      z_[i] = luminance_[i] - (z_[i] + z2_[i]);
    }
    const Rows rows{x_.data(), luminance_.data(), z_.data()};
    flip::rgbFromXyz(rows, width_);
    for (float* row : rows) // no screen shows what lies outside
      for (int i = 0; i < width_; ++i) row[i] = std::clamp(row[i], 0.0f, 1.0f);
    flip::xyzFromRgb(rows, width_);
    flip::huntLabFromXyz(rows, width_);
    strength(edge_, filters_.feature.edge, y, edges_);
    strength(point_, filters_.feature.point, y, points_);
  }

  /// Of the current row: CIELAB with Hunt's effect of what the eye resolves.
  std::array<float, 3> lab(std::size_t x) const { return {x_[x], luminance_[x], z_[x]}; }
  /// How much of an edge and of a point the pixel is.
  float edge(std::size_t x) const { return edges_[x]; }
  float point(std::size_t x) const { return points_[x]; }

private:
  void strength(const Plane& across, const flip::LineFilter& derivative, int y,
                std::vector<float>& out) {
    alongColumns(across, filters_.feature.gauss, y, out.data());
    alongColumns(gauss_, derivative, y, down_.data());
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = std::sqrt(out[i] * out[i] + down_[i] * down_[i]);
  }

  const Filters& filters_;
  int width_;
  Plane y_, cx_, cz1_, cz2_, gauss_, edge_, point_;
  std::vector<float> x_, luminance_, z_, z2_, edges_, points_, down_;
};

// LDR-FLIP of linear RGB 0 to 1, section 4.3: features make a difference of colour count more.
Plane errorsOf(Planes student, Planes reference, const Filters& filters) {
  const int width = reference[0].width, height = reference[0].height;
  Filtered a(opponent(std::move(student)), filters), b(opponent(std::move(reference)), filters);
  Plane errors(width, height);
  for (int y = 0; y < height; ++y) {
    a.advance(y);
    b.advance(y);
    float* out = errors.row(y);
    for (int i = 0; i < width; ++i) {
      const auto x = std::size_t(i);
      const float distance = flip::hyab(a.lab(x), b.lab(x));
      if (distance == 0) continue; // no colour to make more of
      const float feature =
          std::max(std::abs(a.edge(x) - b.edge(x)), std::abs(a.point(x) - b.point(x)));
      const float featureError = std::sqrt(feature * std::numbers::sqrt2_v<float> / 2);
      out[i] = std::clamp(std::pow(flip::colourError(distance), 1 - featureError), 0.0f, 1.0f);
    }
  }
  return errors;
}

// The largest error of every pixel over what `errorsIn(box)` gives, one plane after another.
template <class ErrorsIn>
Flip flipOf(const Image& student, const Image& reference, double ppd, ErrorsIn errorsIn) {
  Flip result;
  result.map = Image(reference.width(), reference.height(), 1);
  const Box box = differing(student, reference);
  if (box.x1 <= box.x0) return result;
  // Beyond the filters' reach both images are the same, whatever lies further out.
  const int reach = flip::filterReach(ppd);
  const Box area = grown(box, 2 * reach, reference);
  const Plane errors = errorsIn(area);
  for (int y = 0; y < area.height(); ++y)
    std::copy_n(errors.row(y), area.width(), result.map.row(area.y0 + y).begin() + area.x0);
  const auto values = result.map.values();
  result.mean = std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
  return result;
}

// ACES as Narkowicz fits it, with the 0.6 that his curve takes off the exposure put back:
// (a x^2 + b x) / (c x^2 + d x + e).
constexpr double kA = 0.6 * 0.6 * 2.51, kB = 0.6 * 0.03, kC = 0.6 * 0.6 * 2.43, kD = 0.6 * 0.59,
                 kE = 0.14;
float toneMapped(float x) {
  return (float(kA) * x * x + float(kB) * x) / (float(kC) * x * x + float(kD) * x + float(kE));
}

// The value that the curve maps to `t`.
double toneMapInverse(double t) {
  const double a = kA - t * kC, b = kB - t * kD, c = -t * kE;
  return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

} // namespace

Flip ldrFlip(const Image& student, const Image& reference, double ppd) {
  check(student, reference, ppd);
  static const Decoder decode;
  const Filters filters{flip::spatialFilters(ppd), flip::featureFilters(ppd)};
  return flipOf(student, reference, ppd, [&](const Box& area) {
    return errorsOf(planesOf(student, area, decode), planesOf(reference, area, decode), filters);
  });
}

Exposures flipExposures(const Image& reference) {
  check(reference, "reference image");
  std::vector<double> luminances;
  luminances.reserve(reference.pixelCount());
  for (int y = 0; y < reference.height(); ++y)
    for (int x = 0; x < reference.width(); ++x) {
      const auto rgb = colour(reference, x, y);
      double sum = 0;
      for (std::size_t c = 0; c < 3; ++c) sum += kLuminance[c] * std::max(0.0, double(rgb[c]));
      luminances.push_back(sum);
    }
  const auto medianOf = [](std::vector<double>& all) {
    const auto middle = all.begin() + std::ptrdiff_t(all.size() / 2);
    std::ranges::nth_element(all, middle);
    return *middle;
  };
  double median = medianOf(luminances);
  if (median == 0) {
    std::erase(luminances, 0.0);
    if (luminances.empty()) return {0, 0, 1};
    median = medianOf(luminances);
  }
  const double target = toneMapInverse(0.85), largest = *std::ranges::max_element(luminances);
  Exposures exposures{std::log2(target / largest), std::log2(target / median), 2};
  exposures.count =
      int(std::clamp(std::ceil(exposures.stop - exposures.start), 2.0, double(kFlipMaxExposures)));
  return exposures;
}

Flip hdrFlip(const Image& student, const Image& reference, double ppd) {
  check(student, reference, ppd);
  const Exposures exposures = flipExposures(reference);
  const Filters filters{flip::spatialFilters(ppd), flip::featureFilters(ppd)};
  return flipOf(student, reference, ppd, [&](const Box& area) {
    Plane largest(area.width(), area.height());
    for (int i = 0; i < exposures.count; ++i) {
      const double step =
          exposures.count > 1 ? (exposures.stop - exposures.start) / (exposures.count - 1) : 0;
      const double factor = std::exp2(exposures.start + i * step);
      // Beyond 100 the curve is past 1, and the square of a huge value past a float's range.
      const auto shown = [&](float value) {
        return std::min(toneMapped(float(std::clamp(double(value) * factor, 0.0, 100.0))), 1.0f);
      };
      const Plane errors =
          errorsOf(planesOf(student, area, shown), planesOf(reference, area, shown), filters);
      for (std::size_t k = 0; k < largest.values.size(); ++k)
        largest.values[k] = std::max(largest.values[k], errors.values[k]);
    }
    return largest;
  });
}

} // namespace ggrade
