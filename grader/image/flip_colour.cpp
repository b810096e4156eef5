#include "image/flip_colour.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ggrade::flip {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

// XYZ from linear sRGB, each row divided by its sum: white is (1, 1, 1).
constexpr Matrix whiteRelative(Matrix m) {
  for (auto& row : m) {
    const double sum = row[0] + row[1] + row[2];
    for (double& value : row) value /= sum;
  }
  return m;
}
constexpr Matrix inverse(const Matrix& m) {
  Matrix result{};
  double determinant = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3;
    determinant += m[0][i] * (m[1][a] * m[2][b] - m[1][b] * m[2][a]);
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t c = (j + 1) % 3, d = (j + 2) % 3;
      result[i][j] = m[c][a] * m[d][b] - m[c][b] * m[d][a];
    }
  }
  for (auto& row : result)
    for (double& value : row) value /= determinant;
  return result;
}
// IEC 61966-2-1's primaries and D65 as exact fractions.
constexpr Matrix kXyzFromRgb = whiteRelative(
    {{{10135552, 8788810, 4435075}, {2613072, 8788810, 887015}, {1425312, 8788810, 70074185}}});
constexpr Matrix kRgbFromXyz = inverse(kXyzFromRgb);

// Three rows of floats to three others; without branches, so that it vectorises.
void transform(const Matrix& matrix, const Rows& v, int length) {
  float m[9];
  for (std::size_t i = 0; i < 9; ++i) m[i] = float(matrix[i / 3][i % 3]);
  float* __restrict a = v[0];
  float* __restrict b = v[1];
  float* __restrict c = v[2];
  for (int i = 0; i < length; ++i) {
    const float x = a[i], y = b[i], z = c[i];
    a[i] = m[0] * x + m[1] * y + m[2] * z;
    b[i] = m[3] * x + m[4] * y + m[5] * z;
    c[i] = m[6] * x + m[7] * y + m[8] * z;
  }
}

// The cube root of a normal float above 0, to 2e-7: a guess from the exponent, 4% off at most, and
// two steps of Halley's, which cube the error. std::cbrt doesn't vectorise.
float cubeRoot(float v) {
  float root = std::bit_cast<float>(
      std::int32_t(float(std::bit_cast<std::int32_t>(v)) * (1.0f / 3)) + 709921077);
  for (int step = 0; step < 2; ++step) {
    const float cube = root * root * root;
    root *= (cube + 2 * v) / (2 * cube + v);
  }
  return root;
}

// CIELAB's f, of relative X, Y or Z.
float labCurve(float v) {
  constexpr float delta = 6.0f / 29;
  const float root = cubeRoot(std::max(v, delta * delta * delta));
  const float line = v * (1 / (3 * delta * delta)) + 4.0f / 29;
  return v > delta * delta * delta ? root : line;
}

constexpr float kColourExponent = 0.7f;             // q_c
constexpr float kKneeAt = 0.4f, kKneeError = 0.95f; // p_c and p_t

} // namespace

void xyzFromRgb(const Rows& rgb, int length) {
  transform(kXyzFromRgb, rgb, length);
}
void rgbFromXyz(const Rows& xyz, int length) {
  transform(kRgbFromXyz, xyz, length);
}

void huntLabFromXyz(const Rows& xyz, int length) {
  float* __restrict x = xyz[0];
  float* __restrict y = xyz[1];
  float* __restrict z = xyz[2];
  for (int i = 0; i < length; ++i) {
    const float fx = labCurve(x[i]), fy = labCurve(y[i]), fz = labCurve(z[i]);
    const float lightness = 116 * fy - 16;
    x[i] = lightness;
    y[i] = 0.01f * lightness * (500 * (fx - fy));
    z[i] = 0.01f * lightness * (200 * (fy - fz));
  }
}

float hyab(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  const float da = a[1] - b[1], db = a[2] - b[2];
  return std::abs(a[0] - b[0]) + std::sqrt(da * da + db * db);
}

namespace {

// The largest distance that there is on a screen, of green and blue, raised to q_c.
float largestDistance() {
  std::array<float, 2> r{0, 0}, g{1, 0}, b{0, 1};
  const Rows rows{r.data(), g.data(), b.data()};
  xyzFromRgb(rows, 2);
  huntLabFromXyz(rows, 2);
  return std::pow(hyab({r[0], g[0], b[0]}, {r[1], g[1], b[1]}), kColourExponent);
}

} // namespace

float colourError(float distance) {
  static const float largest = largestDistance();
  const float knee = kKneeAt * largest;
  const float compressed = std::pow(distance, kColourExponent);
  if (compressed < knee) return compressed * (kKneeError / knee);
  return kKneeError + (compressed - knee) / (largest - knee) * (1 - kKneeError);
}

} // namespace ggrade::flip
