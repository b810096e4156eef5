#pragma once
/// \file
/// Exact filters in double precision: Gaussians, and the steps between the levels of a pyramid,
/// as sums over source pixels, not as texture samples.

#include "image/image.hpp"

#include <glm/vec3.hpp>

#include <vector>

namespace ggrade::truth {

/// RGB in double precision, row by row.
struct Light {
  int width = 0, height = 0;
  std::vector<glm::dvec3> pixels;

  Light() = default;
  Light(int w, int h) : width(w), height(h), pixels(std::size_t(w) * std::size_t(h)) {}
  glm::dvec3& at(int x, int y) {
    return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
  const glm::dvec3& at(int x, int y) const {
    return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
};

/// The first three channels, as they are.
Light lightOf(const Image& image);
Image imageOf(const Light& light);

/// What stands for a pixel beyond the edge: the nearest one, or the one mirrored at the edge.
enum class Edge { clamp, mirror };
/// The pixel of 0 to size-1 that stands for `at`, however far out.
int inside(int at, int size, Edge edge);

/// A filter along one axis: what every target pixel takes of the source pixels.
struct Axis {
  struct Share {
    int source;
    double weight;
  };
  int from = 0;                           ///< source pixels
  std::vector<std::vector<Share>> shares; ///< one list a target pixel
};

/// Shares of the source at `offset` source pixels from each target pixel's centre, between two
/// pixels by linear interpolation, times `weight`; all added up.
struct Sample {
  double offset, weight;
};
Axis samples(int from, int to, const std::vector<Sample>& all, Edge edge);

/// Every source pixel by its share of the tent (linear B-spline) about a target pixel that is two
/// target pixels wide; from >= to. The shares of a target pixel add up to 1.
Axis areaDown(int from, int to, Edge edge);
/// Its transpose, divided by the gain of size; from <= to.
Axis areaUp(int from, int to, Edge edge);

/// A Gaussian of this variance (square pixels); the sum is 1 and the variance exact, to 1e-12.
/// Below 4 square pixels it is the discrete Gaussian exp(-v) I_n(v) (Lindeberg 1990), whose
/// variance is exact also where samples of the continuous one are not.
std::vector<double> gaussianWeights(double variance); ///< of pixels -r to r
Axis gaussian(int size, double variance, Edge edge);

/// The second moment about a target pixel's centre, in square source pixels, averaged over those
/// target pixels that no edge touches (over all if there are none).
double variance(const Axis& axis);

/// Both axes, one after the other.
Light apply(const Light& light, const Axis& across, const Axis& down);
/// `sum += weight * light`; equal sizes.
void addTo(Light& sum, double weight, const Light& light);

} // namespace ggrade::truth
