#include "trace/picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ggrade::trace {
namespace {

constexpr std::array<float, 3> kMagenta = {1, 0, 1};
constexpr std::array<float, 3> kCyan = {0, 1, 1};

void set(std::span<float> to, const std::array<float, 3>& colour) {
  std::copy(colour.begin(), colour.end(), to.begin());
}

/// Paints a pixel with a value that is no number; false if all are numbers.
bool markNonFinite(std::span<const float> from, std::span<float> to) {
  const bool nan = std::any_of(from.begin(), from.end(), [](float v) { return std::isnan(v); });
  const bool infinite =
      std::any_of(from.begin(), from.end(), [](float v) { return std::isinf(v); });
  if (nan || infinite) set(to, nan ? kMagenta : kCyan);
  return nan || infinite;
}

template <typename Paint> void forEachPixel(const Image& from, Image& to, Paint paint) {
  for (int y = 0; y < from.height(); ++y)
    for (int x = 0; x < from.width(); ++x)
      if (!markNonFinite(from.pixel(x, y), to.pixel(x, y))) paint(from.pixel(x, y), to.pixel(x, y));
}

bool onlyRed(std::uint32_t format) {
  const std::string name = glName(format);
  return name == "R8" || name == "R16" || name == "R16F" || name == "R32F" || name == "RED";
}

CopyPicture colourPicture(const Image& from, bool grey) {
  CopyPicture result{Image(from.width(), from.height(), 3), "as stored", 0, 1};
  float greatest = 0;
  for (int y = 0; y < from.height(); ++y)
    for (int x = 0; x < from.width(); ++x)
      for (const float value : from.pixel(x, y).first(3))
        if (std::isfinite(value)) greatest = std::max(greatest, value);
  if (greatest > 1) {
    result.scale = "divided by the greatest value";
    result.high = greatest;
  }
  const float factor = greatest > 1 ? 1 / greatest : 1;
  forEachPixel(from, result.rgb, [&](std::span<const float> values, std::span<float> to) {
    for (std::size_t c = 0; c < 3; ++c)
      to[c] = std::clamp(values[grey ? 0 : c] * factor, 0.0F, 1.0F);
  });
  return result;
}

/// A colour far from that of the next numbers: hues a golden angle apart.
std::array<float, 3> distinctColour(std::uint64_t value) {
  if (value == 0) return {0, 0, 0};
  const double turn = double(value % 6765) * 0.6180339887498949; // 6765: so that turns stay exact
  const auto channel = [&](double shift) {
    const double hue = turn + shift - std::floor(turn + shift);
    return float(std::clamp(std::abs(hue * 6 - 3) - 1, 0.0, 1.0) * 0.8 + 0.2);
  };
  return {channel(0), channel(2.0 / 3), channel(1.0 / 3)};
}

CopyPicture integerPicture(const Image& from) {
  CopyPicture result{Image(from.width(), from.height(), 3), "a colour a value", 0, 1};
  // The fourth channel is 1 where the format has none.
  const std::size_t channels = from.channels() == 1 ? 1 : 3;
  float greatest = 0;
  forEachPixel(from, result.rgb, [&](std::span<const float> values, std::span<float> to) {
    std::uint64_t mixed = 0;
    for (const float value : values.first(channels)) {
      mixed = mixed * 31 + static_cast<std::uint64_t>(static_cast<std::int64_t>(value));
      greatest = std::max(greatest, value);
    }
    set(to, distinctColour(mixed));
  });
  result.high = greatest;
  return result;
}

CopyPicture depthPicture(const Image& from, const std::optional<DepthScale>& scale) {
  CopyPicture result{Image(from.width(), from.height(), 3), "stretched depth", 0, 1};
  float nearest = 1, farthest = 0;
  for (const float depth : from.values()) {
    if (!(depth < 1)) continue; // only cleared, or no number
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  if (nearest <= farthest) {
    result.low = scale ? scale->distance(nearest) : nearest;
    result.high = scale ? scale->distance(farthest) : farthest;
  }
  if (scale) result.scale += " by " + scale->matrix;
  const double low = evenDepth(nearest), range = std::max(evenDepth(farthest) - low, 1e-9);
  forEachPixel(from, result.rgb, [&](std::span<const float> values, std::span<float> to) {
    const double grey = values[0] < 1 ? (evenDepth(values[0]) - low) / range : 1;
    std::fill(to.begin(), to.end(), float(std::clamp(grey, 0.0, 1.0)));
  });
  return result;
}

struct Row {
  double x, y, z, w;
};
Row rowOf(const MatrixRecord& matrix, std::size_t row) {
  const float* m = matrix.values;
  return {m[row], m[4 + row], m[8 + row], m[12 + row]};
}
double dot(const Row& a, const Row& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Of projection times anything affine, the row of z is the row of w times a factor, but for the
/// last column.
std::optional<DepthScale> depthScale(const MatrixRecord& matrix) {
  const Row z = rowOf(matrix, 2), w = rowOf(matrix, 3);
  const double length = dot(w, w);
  if (!(length > 1e-12) || !std::isfinite(length)) return {};
  const double offset = dot(z, w) / length;
  const Row rest = {z.x - offset * w.x, z.y - offset * w.y, z.z - offset * w.z, z.w - offset * w.w};
  if (!(dot(rest, rest) < 1e-8 * length) || !(std::abs(rest.w) > 1e-9)) return {};
  const DepthScale scale{matrix.name, rest.w, offset};
  const double nearest = scale.distance(0);
  if (!(nearest > 0) && !(scale.distance(1) > 0)) return {};
  return scale;
}

bool isPureProjection(const MatrixRecord& matrix) {
  const Row w = rowOf(matrix, 3);
  return w.x == 0 && w.y == 0 && w.z == -1 && w.w == 0;
}

} // namespace

double evenDepth(double depth) {
  return -std::log2(1 - std::clamp(depth, 0.0, 1.0) + 0x1p-12) / 12;
}

std::optional<DepthScale> depthScale(const Trace& trace, const PassRecord& pass) {
  std::optional<DepthScale> product;
  for (const StepRecord& step : trace.stepsOf(pass))
    for (const MatrixRecord& matrix : trace.matricesOf(step)) {
      const std::optional<DepthScale> scale = depthScale(matrix);
      if (scale && isPureProjection(matrix)) return scale;
      if (scale && !product) product = scale;
    }
  return product;
}

CopyPicture picture(const Trace& trace, const CopyRecord& copy) {
  const Image values = trace.image(copy);
  const PassRecord& pass = trace.passes.at(copy.pass);
  switch (static_cast<PixelType>(copy.type)) {
  case PixelType::f32x1:
    return depthPicture(values, depthScale(trace, pass));
  case PixelType::u8x1:
  case PixelType::i32x4:
  case PixelType::u32x4:
    return integerPicture(values);
  default:
    return colourPicture(values, onlyRed(pass.images[copy.attachment].format));
  }
}

} // namespace ggrade::trace
