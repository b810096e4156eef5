#include "image/flip_filters.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numbers>

namespace ggrade::flip {
namespace {

using std::numbers::pi;
using enum LineFilter::Kind;

// One term of a contrast sensitivity function: `amplitude` and `width` are table 1's a and b.
struct Sensitivity {
  double amplitude, width;
};
constexpr Sensitivity kY{1, 0.0047}, kCx{1, 0.0053}, kCz1{34.1, 0.04}, kCz2{13.5, 0.025};
// Width in degrees of the features that the eye takes for edges and points.
constexpr double kFeatureWidth = 0.082;

// How many pixels the widest Gaussian reaches, three standard deviations.
int spatialRadius(double ppd) {
  return int(std::ceil(3 * std::sqrt(kCz1.width / (2 * pi * pi)) * ppd));
}
double featureDeviation(double ppd) {
  return 0.5 * kFeatureWidth * ppd;
}
int featureRadius(double ppd) {
  return int(std::ceil(3 * featureDeviation(ppd)));
}

// The sum over the whole line of an even filter's half.
double lineSum(const std::vector<double>& half) {
  double sum = half[0];
  for (std::size_t i = 1; i < half.size(); ++i) sum += 2 * half[i];
  return sum;
}

LineFilter lineFilter(LineFilter::Kind kind, const std::vector<double>& half, double factor) {
  constexpr double kNothing = 1e-10; // a float's step is 6e-8
  double largest = 0;
  for (const double weight : half) largest = std::max(largest, std::abs(weight));
  std::size_t count = half.size();
  while (count > 1 && std::abs(half[count - 1]) < kNothing * largest) --count;
  LineFilter filter{kind, {}};
  for (std::size_t i = 0; i < count; ++i) filter.weights.push_back(float(factor * half[i]));
  return filter;
}

std::vector<double> sensitivityLine(const Sensitivity& term, double ppd) {
  std::vector<double> half;
  for (int i = 0; i <= spatialRadius(ppd); ++i)
    half.push_back(std::exp(-pi * pi * (i / ppd) * (i / ppd) / term.width));
  return half;
}

// The amplitude of a 2D term is shared by its two line filters.
double sharedAmplitude(const Sensitivity& term) {
  return std::sqrt(term.amplitude * std::sqrt(pi / term.width));
}

// GCC 12 spoils the plain loop (it vectorises over the taps): the vectors are written out.
using Four = float __attribute__((vector_size(16)));
constexpr int kFours = 4, kBlock = 4 * kFours;

Four load(const float* from) {
  Four value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

// out[i] = sum over k of w_k pair(before, centre, after), where `at(k)` gives the line shifted by
// k. A block of results stays in registers while the taps go by; every result is added up in the
// same order, wherever it lies.
template <class At, class Pair>
void filterPairs(const LineFilter& filter, int length, float* out, At at, Pair pair) {
  const float own = filter.kind == LineFilter::Kind::even ? filter.weights[0] : 0;
  int first = 0;
  for (; first + kBlock <= length; first += kBlock) {
    Four centres[kFours], sums[kFours];
    for (int i = 0; i < kFours; ++i) {
      centres[i] = load(at(0) + first + 4 * i);
      sums[i] = own * centres[i];
    }
    for (int k = 1; k <= filter.radius(); ++k) {
      const float weight = filter.weights[std::size_t(k)];
      const float *before = at(-k) + first, *after = at(k) + first;
      for (int i = 0; i < kFours; ++i)
        sums[i] += weight * pair(load(before + 4 * i), centres[i], load(after + 4 * i));
    }
    std::memcpy(out + first, sums, sizeof sums);
  }
  for (; first < length; ++first) {
    const float centre = at(0)[first];
    float sum = own * centre;
    for (int k = 1; k <= filter.radius(); ++k)
      sum += filter.weights[std::size_t(k)] * pair(at(-k)[first], centre, at(k)[first]);
    out[first] = sum;
  }
}

template <class At> void filterLine(const LineFilter& filter, int length, float* out, At at) {
  switch (filter.kind) {
  case LineFilter::Kind::even:
    return filterPairs(filter, length, out, at, [](auto b, auto, auto a) { return b + a; });
  case LineFilter::Kind::odd:
    return filterPairs(filter, length, out, at, [](auto b, auto, auto a) { return a - b; });
  case LineFilter::Kind::second:
    return filterPairs(filter, length, out, at,
                       [](auto b, auto c, auto a) { return (b - c) + (a - c); });
  }
}

} // namespace

SpatialFilters spatialFilters(double ppd) {
  const auto alone = [&](const Sensitivity& term) {
    const auto half = sensitivityLine(term, ppd);
    return lineFilter(even, half, 1 / lineSum(half));
  };
  // The two terms of Cz are normalised together: the 2D filter sums to 1.
  const auto half1 = sensitivityLine(kCz1, ppd), half2 = sensitivityLine(kCz2, ppd);
  const double amplitude1 = sharedAmplitude(kCz1), amplitude2 = sharedAmplitude(kCz2);
  const double whole = std::hypot(amplitude1 * lineSum(half1), amplitude2 * lineSum(half2));
  return {alone(kY), alone(kCx), lineFilter(even, half1, amplitude1 / whole),
          lineFilter(even, half2, amplitude2 / whole)};
}

FeatureFilters featureFilters(double ppd) {
  const double deviation = featureDeviation(ppd);
  std::vector<double> gauss, edge, point;
  double positiveEdge = 0, positivePoint = 0, negativePoint = 0;
  for (int i = 0; i <= featureRadius(ppd); ++i) {
    const double g = std::exp(-0.5 * (i / deviation) * (i / deviation));
    const double curve = ((i / deviation) * (i / deviation) - 1) * g;
    gauss.push_back(g);
    edge.push_back(-i * g);
    point.push_back(curve);
    positiveEdge += i * g;
    (curve > 0 ? positivePoint : negativePoint) += (i == 0 ? 1 : 2) * std::abs(curve);
  }
  for (double& weight : point) weight /= weight > 0 ? positivePoint : negativePoint;
  return {lineFilter(even, gauss, 1 / lineSum(gauss)), lineFilter(odd, edge, 1 / positiveEdge),
          lineFilter(second, point, 1)};
}

int filterReach(double ppd) {
  return std::max(spatialRadius(ppd), featureRadius(ppd));
}

Plane alongRows(const Plane& in, const LineFilter& filter) {
  const int radius = filter.radius();
  Plane out(in.width, in.height);
  std::vector<float> padded(std::size_t(in.width + 2 * radius));
  const float* middle = padded.data() + radius;
  for (int y = 0; y < in.height; ++y) {
    const float* from = in.row(y);
    std::fill_n(padded.begin(), radius, from[0]);
    std::copy_n(from, in.width, padded.begin() + radius);
    std::fill_n(padded.end() - radius, radius, from[in.width - 1]);
    filterLine(filter, in.width, out.row(y), [&](int k) { return middle + k; });
  }
  return out;
}

void alongColumns(const Plane& in, const LineFilter& filter, int y, float* out) {
  filterLine(filter, in.width, out,
             [&](int k) { return in.row(std::clamp(y + k, 0, in.height - 1)); });
}

} // namespace ggrade::flip
