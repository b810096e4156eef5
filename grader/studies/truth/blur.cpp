#include "truth/blur.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ggrade::truth {

namespace {

/// The area under max(1 - |x|, 0) between `low` and `high`: pieces of straight lines.
double tentArea(double low, double high) {
  const auto height = [](double x) { return std::max(1 - std::abs(x), 0.0); };
  double sum = 0;
  for (const auto& [a, b] : {std::pair(-1.0, 0.0), std::pair(0.0, 1.0)}) {
    const double left = std::clamp(low, a, b), right = std::clamp(high, a, b);
    sum += (right - left) * (height(left) + height(right)) / 2;
  }
  return sum;
}

Axis emptyAxis(int from, int to) {
  if (from < 1 || to < 1) throw std::invalid_argument("a filter needs at least one pixel");
  Axis axis;
  axis.from = from;
  axis.shares.resize(std::size_t(to));
  return axis;
}

} // namespace

Light lightOf(const Image& image) {
  Light light(image.width(), image.height());
  for (int y = 0; y < light.height; ++y)
    for (int x = 0; x < light.width; ++x)
      for (int c = 0; c < 3; ++c) light.at(x, y)[c] = double(image.at(x, y, c));
  return light;
}

Image imageOf(const Light& light) {
  Image image(light.width, light.height, 3);
  for (int y = 0; y < light.height; ++y)
    for (int x = 0; x < light.width; ++x)
      for (int c = 0; c < 3; ++c) image.at(x, y, c) = float(light.at(x, y)[c]);
  return image;
}

int inside(int at, int size, Edge edge) {
  if (edge == Edge::clamp) return std::clamp(at, 0, size - 1);
  const int period = 2 * size;
  at = ((at % period) + period) % period;
  return at < size ? at : period - 1 - at;
}

Axis samples(int from, int to, const std::vector<Sample>& all, Edge edge) {
  Axis axis = emptyAxis(from, to);
  for (int i = 0; i < to; ++i)
    for (const Sample& one : all) {
      // In pixels from the first source pixel's centre.
      const double at = (i + 0.5) * from / to + one.offset - 0.5;
      const int first = int(std::floor(at));
      const double second = at - first;
      auto& shares = axis.shares[std::size_t(i)];
      shares.push_back({inside(first, from, edge), one.weight * (1 - second)});
      if (second > 0) shares.push_back({inside(first + 1, from, edge), one.weight * second});
    }
  return axis;
}

Axis areaDown(int from, int to, Edge edge) {
  Axis axis = emptyAxis(from, to);
  const double ratio = double(from) / to;
  for (int i = 0; i < to; ++i) {
    const double centre = (i + 0.5) * ratio;
    for (int j = int(std::floor(centre - ratio)); j < std::ceil(centre + ratio); ++j)
      axis.shares[std::size_t(i)].push_back(
          {inside(j, from, edge), tentArea((j - centre) / ratio, (j + 1 - centre) / ratio)});
  }
  return axis;
}

Axis areaUp(int from, int to, Edge edge) {
  Axis axis = emptyAxis(from, to);
  const double ratio = double(from) / to;
  for (int i = 0; i < to; ++i) {
    const double low = i * ratio, high = low + ratio;
    // Source pixel j has its tent about j + 0.5, one to each side.
    for (int j = int(std::floor(low - 0.5)); j < std::ceil(high + 0.5); ++j)
      axis.shares[std::size_t(i)].push_back(
          {inside(j, from, edge), tentArea(low - j - 0.5, high - j - 0.5) / ratio});
  }
  return axis;
}

std::vector<double> gaussianWeights(double variance) {
  if (!(variance >= 0)) throw std::invalid_argument("a variance is not negative");
  if (variance == 0) return {1};
  const int radius = int(std::ceil(8 * std::sqrt(variance))) + 16;
  std::vector<double> weights(std::size_t(2 * radius + 1));
  double sum = 0;
  for (int n = -radius; n <= radius; ++n)
    sum += weights[std::size_t(n + radius)] =
        variance < 4 ? std::exp(-variance) * std::cyl_bessel_i(double(std::abs(n)), variance)
                     : std::exp(-n * n / (2 * variance));
  for (double& weight : weights) weight /= sum;
  return weights;
}

Axis gaussian(int size, double variance, Edge edge) {
  Axis axis = emptyAxis(size, size);
  const std::vector<double> weights = gaussianWeights(variance);
  const int radius = int(weights.size() / 2);
  std::vector<double> row(std::size_t(size), 0.0);
  for (int i = 0; i < size; ++i) {
    // Folded first: far beyond the edge the same pixel comes many times.
    std::ranges::fill(row, 0.0);
    for (int n = -radius; n <= radius; ++n)
      row[std::size_t(inside(i + n, size, edge))] += weights[std::size_t(n + radius)];
    for (int j = 0; j < size; ++j)
      if (row[std::size_t(j)] > 0) axis.shares[std::size_t(i)].push_back({j, row[std::size_t(j)]});
  }
  return axis;
}

double variance(const Axis& axis) {
  const auto to = double(axis.shares.size());
  const auto about = [&](std::size_t i) {
    const double centre = (double(i) + 0.5) * axis.from / to;
    double sum = 0;
    for (const Axis::Share& share : axis.shares[i])
      sum += share.weight * (share.source + 0.5 - centre) * (share.source + 0.5 - centre);
    return sum;
  };
  const auto touchesEdge = [&](std::size_t i) {
    return std::ranges::any_of(axis.shares[i], [&](const Axis::Share& share) {
      return share.weight > 0 && (share.source == 0 || share.source == axis.from - 1);
    });
  };
  double all = 0, free = 0, freeCount = 0;
  for (std::size_t i = 0; i < axis.shares.size(); ++i) {
    const double one = about(i);
    all += one;
    if (!touchesEdge(i)) free += one, ++freeCount;
  }
  return freeCount > 0 ? free / freeCount : all / to;
}

Light apply(const Light& light, const Axis& across, const Axis& down) {
  if (across.from != light.width || down.from != light.height)
    throw std::invalid_argument("a filter is for a picture of another size");
  Light rows(int(across.shares.size()), light.height);
  for (int y = 0; y < rows.height; ++y)
    for (int x = 0; x < rows.width; ++x) {
      glm::dvec3 sum(0);
      for (const Axis::Share& share : across.shares[std::size_t(x)])
        sum += share.weight * light.at(share.source, y);
      rows.at(x, y) = sum;
    }
  Light out(rows.width, int(down.shares.size()));
  for (int y = 0; y < out.height; ++y)
    for (const Axis::Share& share : down.shares[std::size_t(y)])
      for (int x = 0; x < out.width; ++x) out.at(x, y) += share.weight * rows.at(x, share.source);
  return out;
}

void addTo(Light& sum, double weight, const Light& light) {
  if (sum.width != light.width || sum.height != light.height)
    throw std::invalid_argument("pictures of different sizes cannot be added");
  for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += weight * light.pixels[i];
}

} // namespace ggrade::truth
