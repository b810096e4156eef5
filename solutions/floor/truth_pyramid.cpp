#include "truth_pyramid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace floor_truth {

using truth::Axis;
using truth::Edge;
using truth::Light;
using truth::Sample;

namespace {

using Samples = std::vector<Sample>;

// Offsets in source pixels from a target pixel's centre, and weights.
const Samples kMiddle = {{0, 1}};
const Samples kBinomial = {{-2, 1. / 16}, {-1, 4. / 16}, {0, 6. / 16}, {1, 4. / 16}, {2, 1. / 16}};
const Samples kPair = {{-1, 0.5}, {1, 0.5}};
const Samples kHalfPair = {{-0.5, 0.5}, {0.5, 0.5}};
const Samples kThree = {{-1, 0.25}, {0, 0.5}, {1, 0.25}};
const Samples kWideThree = {{-2, 0.25}, {0, 0.5}, {2, 0.25}};

struct Product {
  double weight;
  const Samples &across, &down;
};

LevelFilter sampled(const std::vector<Product>& products, Size from, Size to, Edge edge) {
  LevelFilter filter;
  for (const Product& product : products)
    filter.terms.push_back({product.weight, samples(from.width, to.width, product.across, edge),
                            samples(from.height, to.height, product.down, edge)});
  return filter;
}

[[noreturn]] void refuse(int kind) {
  throw std::invalid_argument("quality.bloom_filter " + std::to_string(kind) +
                              ": there are filters 0 to 3");
}

Variances varianceOf(const LevelFilter& filter) {
  Variances sum{0, 0};
  for (const LevelFilter::Term& term : filter.terms) {
    sum.across += term.weight * variance(term.across);
    sum.down += term.weight * variance(term.down);
  }
  return sum;
}

} // namespace

LevelFilter downFilter(int kind, Size from, Size to, Edge edge) {
  switch (kind) {
  case 0:
    return sampled({{1, kBinomial, kBinomial}}, from, to, edge);
  case 1: // half the middle, an eighth of each corner
    return sampled({{0.5, kMiddle, kMiddle}, {0.5, kPair, kPair}}, from, to, edge);
  case 2: // the middle box of four samples weighs 1/2, the four about it 1/8 each
    return sampled({{0.5, kPair, kPair}, {0.5, kWideThree, kWideThree}}, from, to, edge);
  case 3:
    return {{{1, areaDown(from.width, to.width, edge), areaDown(from.height, to.height, edge)}}};
  }
  refuse(kind);
}

LevelFilter upFilter(int kind, Size from, Size to, Edge edge) {
  switch (kind) {
  case 0:
    return sampled({{1, kMiddle, kMiddle}}, from, to, edge);
  case 1: // corners half a pixel away weigh 2/12, whole pixels along the axes 1/12
    return sampled(
        {{8. / 12, kHalfPair, kHalfPair}, {2. / 12, kPair, kMiddle}, {2. / 12, kMiddle, kPair}},
        from, to, edge);
  case 2:
    return sampled({{1, kThree, kThree}}, from, to, edge);
  case 3:
    return {{{1, areaUp(from.width, to.width, edge), areaUp(from.height, to.height, edge)}}};
  }
  refuse(kind);
}

Light apply(const Light& light, const LevelFilter& filter) {
  Light sum;
  for (const LevelFilter::Term& term : filter.terms) {
    const Light one = truth::apply(light, term.across, term.down);
    if (sum.pixels.empty()) sum = Light(one.width, one.height);
    addTo(sum, term.weight, one);
  }
  return sum;
}

std::vector<Size> levelSizes(Size scene, int count) {
  std::vector<Size> sizes;
  for (int i = 0; i < count; ++i) {
    scene = {std::max(scene.width / 2, 1), std::max(scene.height / 2, 1)};
    sizes.push_back(scene);
  }
  return sizes;
}

Light finite(Light light) {
  for (glm::dvec3& pixel : light.pixels)
    for (int c = 0; c < 3; ++c) pixel[c] = pixel[c] > 0 ? std::min(pixel[c], 65504.0) : 0;
  return light;
}

Light brightPass(const Light& scene, double threshold) {
  const Size half = levelSizes({scene.width, scene.height}, 1)[0];
  Light bright = truth::apply(finite(scene), areaDown(scene.width, half.width, Edge::mirror),
                              areaDown(scene.height, half.height, Edge::mirror));
  for (glm::dvec3& pixel : bright.pixels) {
    const double brightness = std::max({pixel.x, pixel.y, pixel.z});
    pixel *= std::max(brightness - threshold, 0.0) / std::max(brightness, 1e-5);
  }
  return bright;
}

Light levelSum(const Light& bright, int count, int kind, Edge edge) {
  std::vector<Light> levels(1, Light(bright.width, bright.height));
  addTo(levels[0], 1.0 / count, bright);
  while (int(levels.size()) < count) {
    const Light& last = levels.back();
    const Size from{last.width, last.height};
    levels.push_back(apply(last, downFilter(kind, from, levelSizes(from, 1)[0], edge)));
  }
  for (std::size_t i = levels.size() - 1; i > 0; --i) {
    Light& to = levels[i - 1];
    const Size from{levels[i].width, levels[i].height};
    addTo(to, 1, apply(levels[i], upFilter(kind, from, {to.width, to.height}, edge)));
  }
  return levels[0];
}

std::vector<Variances> levelVariances(Size largest, int count, int kind, Edge edge) {
  std::vector<Variances> all(1, {0, 0});
  Size from = largest;
  while (int(all.size()) < count) {
    const Size to = levelSizes(from, 1)[0];
    // A pixel of either level, in pixels of level 0.
    const auto scaled = [&](const Variances& of, Size pixels) {
      return Variances{of.across * std::pow(double(largest.width) / pixels.width, 2),
                       of.down * std::pow(double(largest.height) / pixels.height, 2)};
    };
    const Variances down = scaled(varianceOf(downFilter(kind, from, to, edge)), from);
    const Variances up = scaled(varianceOf(upFilter(kind, to, from, edge)), to);
    all.push_back(
        {all.back().across + down.across + up.across, all.back().down + down.down + up.down});
    from = to;
  }
  return all;
}

Light gaussianSum(const Light& bright, int count, int kind, Edge edge) {
  Light sum(bright.width, bright.height);
  for (const Variances& of : levelVariances({bright.width, bright.height}, count, kind, edge))
    addTo(sum, 1.0 / count,
          truth::apply(bright, truth::gaussian(bright.width, of.across, edge),
                       truth::gaussian(bright.height, of.down, edge)));
  return sum;
}

LightErrors compareLight(const Light& found, const Light& wanted) {
  if (found.width != wanted.width || found.height != wanted.height)
    throw std::invalid_argument("light of different sizes cannot be compared");
  LightErrors errors{0, 0, 0, 0};
  double apart = 0, foundSum = 0, wantedSum = 0;
  for (std::size_t i = 0; i < wanted.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double a = found.pixels[i][c], b = wanted.pixels[i][c];
      const double relative = std::abs(a - b) / std::max(b, 1e-3);
      errors.greatest = std::max(errors.greatest, relative);
      errors.mean += relative / (3.0 * double(wanted.pixels.size()));
      apart += std::abs(a - b), foundSum += a, wantedSum += b;
    }
  // Where there is no light, any light is all wrong.
  const auto share = [&](double of) {
    return wantedSum > 0 ? of / wantedSum : foundSum > 0 ? 1.0 : 0.0;
  };
  errors.energy = share(std::abs(foundSum - wantedSum));
  errors.misplaced = share(apart);
  return errors;
}

} // namespace floor_truth
