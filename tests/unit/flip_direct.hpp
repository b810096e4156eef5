#pragma once
/// \file
/// LDR-FLIP straight from the paper's definitions: double precision, two-dimensional filters, no
/// shortcut. Shares nothing with grader/image; slow, for images of a few thousand pixels.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <vector>

namespace flip_direct {

using Colour = std::array<double, 3>;

inline double linearFromSrgb(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

// IEC 61966-2-1's matrix and its inverse, to the digits of the XYZ of the white D65 that belong to
// it.
inline Colour xyzFromLinear(const Colour& c) {
  return {0.4123865632529917 * c[0] + 0.35759149092062537 * c[1] + 0.18045049120356368 * c[2],
          0.21263682167732384 * c[0] + 0.7151829818412507 * c[1] + 0.07218019648142547 * c[2],
          0.019330620152483987 * c[0] + 0.11919716364020845 * c[1] + 0.9503725870054354 * c[2]};
}
inline const Colour kWhite = xyzFromLinear({1, 1, 1});

// Cramer's rule on the matrix above, whose columns are the XYZ of red, green and blue.
inline Colour linearFromXyz(const Colour& xyz) {
  const Colour r = xyzFromLinear({1, 0, 0}), g = xyzFromLinear({0, 1, 0}),
               b = xyzFromLinear({0, 0, 1});
  const auto determinant = [](const Colour& u, const Colour& v, const Colour& w) {
    return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
           u[2] * (v[0] * w[1] - v[1] * w[0]);
  };
  const double whole = determinant(r, g, b);
  return {determinant(xyz, g, b) / whole, determinant(r, xyz, b) / whole,
          determinant(r, g, xyz) / whole};
}

inline Colour ycxczFromLinear(const Colour& rgb) {
  const Colour xyz = xyzFromLinear(rgb);
  const double x = xyz[0] / kWhite[0], y = xyz[1] / kWhite[1], z = xyz[2] / kWhite[2];
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}
inline Colour linearFromYcxcz(const Colour& c) {
  const double y = (c[0] + 16) / 116;
  return linearFromXyz({(y + c[1] / 500) * kWhite[0], y * kWhite[1], (y - c[2] / 200) * kWhite[2]});
}

// CIELAB, its a and b times L / 100.
inline Colour huntLab(const Colour& linear) {
  const Colour xyz = xyzFromLinear(linear);
  const auto f = [](double t) {
    const double delta = 6.0 / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
  };
  const double fx = f(xyz[0] / kWhite[0]), fy = f(xyz[1] / kWhite[1]), fz = f(xyz[2] / kWhite[2]);
  const double l = 116 * fy - 16;
  return {l, 500 * (fx - fy) * l / 100, 200 * (fy - fz) * l / 100};
}

inline double hyab(const Colour& a, const Colour& b) {
  return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

/// The error of two colours (linear RGB) that fill the whole sight: section 4.1 without filters.
inline double colourError(const Colour& a, const Colour& b) {
  const double largest = std::pow(hyab(huntLab({0, 1, 0}), huntLab({0, 0, 1})), 0.7);
  const double error = std::pow(hyab(huntLab(a), huntLab(b)), 0.7);
  if (error < 0.4 * largest) return 0.95 * error / (0.4 * largest);
  return 0.95 + 0.05 * (error - 0.4 * largest) / (0.6 * largest);
}

/// `side x side` weights, side odd.
struct Kernel {
  int radius = 0;
  std::vector<double> weights;
  double at(int x, int y) const {
    return weights[std::size_t(y + radius) * std::size_t(2 * radius + 1) + std::size_t(x + radius)];
  }
};

inline Kernel kernel(int radius, const std::function<double(int, int)>& weight) {
  Kernel result{radius, {}};
  for (int y = -radius; y <= radius; ++y)
    for (int x = -radius; x <= radius; ++x) result.weights.push_back(weight(x, y));
  return result;
}

/// Contrast sensitivity of one plane of YCxCz (0, 1, 2): table 1 of the paper.
inline Kernel sensitivity(int plane, double ppd) {
  using std::numbers::pi;
  struct Term {
    double a, b;
  };
  const std::vector<Term> terms = plane == 0   ? std::vector<Term>{{1, 0.0047}}
                                  : plane == 1 ? std::vector<Term>{{1, 0.0053}}
                                               : std::vector<Term>{{34.1, 0.04}, {13.5, 0.025}};
  Kernel result =
      kernel(int(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd)), [&](int x, int y) {
        double sum = 0;
        for (const Term& t : terms)
          sum += t.a * std::sqrt(pi / t.b) *
                 std::exp(-pi * pi * (double(x) * x + double(y) * y) / (ppd * ppd) / t.b);
        return sum;
      });
  double sum = 0;
  for (const double w : result.weights) sum += w;
  for (double& w : result.weights) w /= sum;
  return result;
}

/// Edges (a Gaussian's first derivative) or points (its second) along x: section 4.2.
inline Kernel feature(bool point, double ppd) {
  const double deviation = 0.5 * 0.082 * ppd;
  Kernel result = kernel(int(std::ceil(3 * deviation)), [&](int x, int y) {
    const double g = std::exp(-(double(x) * x + double(y) * y) / (2 * deviation * deviation));
    return (point ? x * x / (deviation * deviation) - 1 : -x) * g;
  });
  double positive = 0, negative = 0;
  for (const double w : result.weights) (w > 0 ? positive : negative) += std::abs(w);
  for (double& w : result.weights) w /= w > 0 ? positive : negative;
  return result;
}

/// Row after row.
struct Picture {
  int width = 0, height = 0;
  std::vector<Colour> pixels;
  const Colour& at(int x, int y) const {
    return pixels[std::size_t(std::clamp(y, 0, height - 1)) * std::size_t(width) +
                  std::size_t(std::clamp(x, 0, width - 1))];
  }
};

inline double filtered(const Picture& p, std::size_t plane, const Kernel& k, int x, int y,
                       bool turned = false) {
  double sum = 0;
  for (int j = -k.radius; j <= k.radius; ++j)
    for (int i = -k.radius; i <= k.radius; ++i)
      sum += (turned ? k.at(j, i) : k.at(i, j)) * p.at(x + i, y + j)[plane];
  return sum;
}

/// The error map of two pictures in linear RGB 0 to 1.
inline std::vector<double> errors(const Picture& a, const Picture& b, double ppd) {
  const Kernel csf[3] = {sensitivity(0, ppd), sensitivity(1, ppd), sensitivity(2, ppd)};
  const Kernel edge = feature(false, ppd), point = feature(true, ppd);
  const auto opponent = [](Picture p) {
    for (Colour& c : p.pixels) c = ycxczFromLinear(c);
    return p;
  };
  const Picture pictures[2] = {opponent(a), opponent(b)};
  std::vector<double> result;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      Colour seen[2];
      double edges[2], points[2];
      for (std::size_t i = 0; i < 2; ++i) {
        const Picture& p = pictures[i];
        Colour c;
        for (std::size_t plane = 0; plane < 3; ++plane)
          c[plane] = filtered(p, plane, csf[plane], x, y);
        c = linearFromYcxcz(c);
        for (double& v : c) v = std::clamp(v, 0.0, 1.0);
        seen[i] = c;
        // The kernels sum to 0: the offset of Y goes, its factor 116 is taken off.
        edges[i] = std::hypot(filtered(p, 0, edge, x, y), filtered(p, 0, edge, x, y, true)) / 116;
        points[i] =
            std::hypot(filtered(p, 0, point, x, y), filtered(p, 0, point, x, y, true)) / 116;
      }
      const double difference =
          std::max(std::abs(edges[0] - edges[1]), std::abs(points[0] - points[1]));
      result.push_back(
          std::pow(colourError(seen[0], seen[1]), 1 - std::sqrt(difference / std::numbers::sqrt2)));
    }
  return result;
}

} // namespace flip_direct
