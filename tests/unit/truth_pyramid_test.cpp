#include "../../solutions/floor/truth_pyramid.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

using namespace floor_truth;
using ggrade::truth::Edge;
using ggrade::truth::Light;
using glm::dvec3;

namespace {

Light constant(int width, int height, const dvec3& color) {
  Light light(width, height);
  for (dvec3& pixel : light.pixels) pixel = color;
  return light;
}

double greatestChange(const Light& light, const dvec3& color) {
  double most = 0;
  for (const dvec3& pixel : light.pixels)
    for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(pixel[c] - color[c]));
  return most;
}

TEST(TruthPyramid, EvenLightStaysEven) {
  const dvec3 color(0.2, 3, 40);
  for (int kind = 0; kind < 4; ++kind)
    for (const Edge edge : {Edge::clamp, Edge::mirror})
      for (const Size size : {Size{16, 8}, {13, 7}, {1, 9}, {1, 1}}) {
        const Light light = constant(size.width, size.height, color);
        EXPECT_LT(greatestChange(levelSum(light, 6, kind, edge), color), 1e-12);
        EXPECT_LT(greatestChange(gaussianSum(light, 6, kind, edge), color), 1e-12);
      }
}

TEST(TruthPyramid, FiltersAreRoundAndWeighWhatTheirAuthorsWrote) {
  // An impulse in the middle of a 2 to 1 step down: the four target pixels about it.
  Light impulse(16, 16);
  impulse.at(8, 8) = dvec3(1);
  const auto at = [&](int kind, int x, int y) {
    return apply(impulse, downFilter(kind, {16, 16}, {8, 8}, Edge::clamp)).at(x, y).x;
  };
  // Target pixel 4 lies at 9, half a pixel from pixel 8's centre.
  const double binomial = (6 + 4) / 32.0; // 0 and one pixel on, in halves
  EXPECT_NEAR(at(0, 4, 4), binomial * binomial, 1e-15);
  EXPECT_NEAR(at(1, 4, 4), (0.5 + 0.125) / 4, 1e-15) << "the middle and one corner, a quarter each";
  EXPECT_NEAR(at(2, 4, 4), 0.25 / 4 * (0.5 + 0.5), 1e-15);
  EXPECT_NEAR(at(3, 4, 4), 9.0 / 64, 1e-15);
  EXPECT_NEAR(at(3, 3, 4), 3.0 / 64, 1e-15);
  // 2 to 1 up: a target pixel lies a quarter from the source's centre.
  Light small(4, 4);
  small.at(1, 1) = dvec3(1);
  const auto up = [&](int kind, int x, int y) {
    return apply(small, upFilter(kind, {4, 4}, {8, 8}, Edge::clamp)).at(x, y).x;
  };
  EXPECT_NEAR(up(0, 2, 2), 9.0 / 16, 1e-15);
  EXPECT_NEAR(up(3, 2, 2), 9.0 / 16, 1e-15);
  EXPECT_NEAR(up(3, 1, 2), 3.0 / 16, 1e-15);
  EXPECT_NEAR(up(2, 2, 2), (0.5 * 0.75 + 0.25 * 0.25) * (0.5 * 0.75 + 0.25 * 0.25), 1e-15);
  // Dual: the corners half a pixel off see 0.75 or 0.25 along each axis; whole pixels 0.25 or 0.
  EXPECT_NEAR(up(1, 2, 2), 2. / 12 * (0.75 + 0.25) * (0.75 + 0.25) + 2. / 12 * 0.25 * 0.75, 1e-15);
}

TEST(TruthPyramid, LevelsHaveTheVarianceOfTheirFilters) {
  // On its way to level k and back light is spread by every step; a level's pixels are 2^k wide.
  const auto expected = [](double perStep, int level) {
    return perStep * (std::pow(4.0, level) - 1) / 3;
  };
  // Down the area filter has 3/4, the 5 x 5 between pixels 1 + 1/4; up bilinear has 3/4.
  for (const auto& [kind, perStep] : {std::pair(3, 1.5), std::pair(0, 2.0)}) {
    const auto all = levelVariances({2048, 1024}, 4, kind, Edge::mirror);
    ASSERT_EQ(all.size(), 4u);
    for (int k = 0; k < 4; ++k) {
      EXPECT_NEAR(all[std::size_t(k)].across, expected(perStep, k), 1e-9) << kind << " " << k;
      EXPECT_NEAR(all[std::size_t(k)].down, expected(perStep, k), 1e-9) << kind << " " << k;
    }
  }
}

TEST(TruthPyramid, GaussiansSpreadAsTheLevelsDo) {
  // Second moments of what one bright pixel becomes, by the levels and by the Gaussians.
  Light impulse(256, 1);
  impulse.at(128, 0) = dvec3(1);
  for (int kind = 0; kind < 4; ++kind) {
    const auto second = [](const Light& light) {
      double sum = 0, mean = 0;
      for (int x = 0; x < light.width; ++x)
        sum += light.at(x, 0).x * std::pow(x - 128, 2), mean += light.at(x, 0).x * (x - 128);
      return sum - mean * mean;
    };
    const double levels = second(levelSum(impulse, 4, kind, Edge::mirror));
    const double gaussians = second(gaussianSum(impulse, 4, kind, Edge::mirror));
    EXPECT_NEAR(levels / gaussians, 1, 0.15) << kind; // where a pixel lies in its level matters
  }
}

TEST(TruthPyramid, LevelSizesHalveDownToOne) {
  const auto sizes = levelSizes({45, 5}, 6);
  std::vector<std::pair<int, int>> all;
  for (const Size& size : sizes) all.emplace_back(size.width, size.height);
  EXPECT_THAT(all, testing::ElementsAre(std::pair(22, 2), std::pair(11, 1), std::pair(5, 1),
                                        std::pair(2, 1), std::pair(1, 1), std::pair(1, 1)));
}

TEST(TruthPyramid, BrightPassKeepsTheHue) {
  const Light bright = brightPass(constant(8, 6, {2, 0.5, 0}), 1);
  EXPECT_EQ(bright.width, 4);
  EXPECT_EQ(bright.height, 3);
  EXPECT_LT(greatestChange(bright, {1, 0.25, 0}), 1e-15);
  EXPECT_LT(greatestChange(brightPass(constant(8, 6, {1, 0.5, 0}), 1), dvec3(0)), 1e-15);
  EXPECT_LT(greatestChange(brightPass(constant(8, 6, {3, 1, 1}), 0), {3, 1, 1}), 1e-15);
}

TEST(TruthPyramid, BrightPassTakesFourSamplesAtThreeQuarters) {
  Light light(8, 8);
  light.at(3, 4) = dvec3(64);
  const Light bright = brightPass(light, 0);
  EXPECT_NEAR(bright.at(1, 2).x, 9, 1e-12);
  EXPECT_NEAR(bright.at(2, 2).x, 3, 1e-12);
  EXPECT_NEAR(bright.at(2, 1).x, 1, 1e-12);
  EXPECT_EQ(bright.at(0, 2).x, 0);
}

TEST(TruthPyramid, WhatCannotBeAddedIsMadeFinite) {
  Light light(3, 1);
  const double infinity = std::numeric_limits<double>::infinity();
  light.at(0, 0) = {std::nan(""), -1, infinity};
  light.at(1, 0) = {7e4, 65504, 0.5};
  light.at(2, 0) = {-infinity, -0.0, 1e-9};
  const Light clean = finite(light);
  EXPECT_EQ(clean.at(0, 0), dvec3(0, 0, 65504));
  EXPECT_EQ(clean.at(1, 0), dvec3(65504, 65504, 0.5));
  EXPECT_EQ(clean.at(2, 0), dvec3(0, 0, 1e-9));
}

TEST(TruthPyramid, ComparisonIsRelativeWhereThereIsLight) {
  Light wanted(2, 1), found(2, 1);
  wanted.at(0, 0) = {1, 0, 0};
  found.at(0, 0) = {1.01, 1e-5, 0};
  const LightErrors errors = compareLight(found, wanted);
  EXPECT_NEAR(errors.greatest, 0.01, 1e-12) << "1e-5 where nothing is wanted counts as 1%";
  EXPECT_NEAR(errors.mean, 0.02 / 6, 1e-12);
  EXPECT_NEAR(errors.energy, 0.01001, 1e-12);
  EXPECT_NEAR(errors.misplaced, 0.01001, 1e-12);
  EXPECT_EQ(compareLight(wanted, wanted).greatest, 0);
  EXPECT_EQ(compareLight(Light(2, 1), Light(2, 1)).energy, 0);
  EXPECT_EQ(compareLight(found, Light(2, 1)).energy, 1) << "all of it is wrong";
  EXPECT_THROW(compareLight(Light(2, 1), Light(1, 2)), std::invalid_argument);
}

TEST(TruthPyramid, RefusesAFilterThatIsNotThere) {
  EXPECT_THAT([] { levelSum(Light(4, 4), 2, 4, Edge::clamp); },
              testing::ThrowsMessage<std::invalid_argument>("quality.bloom_filter 4: there are "
                                                            "filters 0 to 3"));
}

} // namespace
