#include "truth/blur.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

using namespace ggrade::truth;
using glm::dvec3;
using testing::DoubleNear;
using testing::ElementsAre;

namespace {

/// What each target pixel takes, added up by source pixel.
std::vector<double> row(const Axis& axis, std::size_t target) {
  std::vector<double> all(std::size_t(axis.from));
  for (const Axis::Share& share : axis.shares[target])
    all[std::size_t(share.source)] += share.weight;
  return all;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(TruthBlur, EdgesRepeatOrMirror) {
  std::vector<int> clamped, mirrored;
  for (int i = -5; i < 9; ++i) {
    clamped.push_back(inside(i, 3, Edge::clamp));
    mirrored.push_back(inside(i, 3, Edge::mirror));
  }
  EXPECT_THAT(clamped, ElementsAre(0, 0, 0, 0, 0, 0, 1, 2, 2, 2, 2, 2, 2, 2));
  EXPECT_THAT(mirrored, ElementsAre(1, 2, 2, 1, 0, 0, 1, 2, 2, 1, 0, 0, 1, 2));
  EXPECT_EQ(inside(-7, 1, Edge::mirror), 0);
}

TEST(TruthBlur, GaussianHasSumOneAndItsVariance) {
  for (const double variance : {0.01, 0.3, 1.0, 3.9, 4.0, 25.0, 511.5, 4000.0}) {
    const std::vector<double> weights = gaussianWeights(variance);
    const int radius = int(weights.size() / 2);
    double mean = 0, second = 0;
    for (int n = -radius; n <= radius; ++n) {
      mean += n * weights[std::size_t(n + radius)];
      second += double(n) * n * weights[std::size_t(n + radius)];
    }
    EXPECT_NEAR(sum(weights), 1, 1e-12) << variance;
    EXPECT_NEAR(mean, 0, 1e-12) << variance;
    EXPECT_NEAR(second / variance, 1, 1e-12) << variance;
  }
  EXPECT_THAT(gaussianWeights(0), ElementsAre(1));
  const std::vector<double> one = gaussianWeights(4);
  EXPECT_NEAR(one[one.size() / 2 + 2] / one[one.size() / 2], std::exp(-0.5), 1e-15);
}

TEST(TruthBlur, TwoGaussiansAreOneOfBothVariances) {
  const int size = 161;
  Light impulse(size, 1);
  impulse.at(80, 0) = dvec3(1);
  const Axis still = gaussian(1, 0, Edge::clamp);
  const auto blurred = [&](const Light& light, double variance) {
    return apply(light, gaussian(size, variance, Edge::clamp), still);
  };
  // The discrete ones, and the sampled ones.
  for (const auto& [first, second] : {std::pair(1.5, 2.0), std::pair(9.0, 16.0)}) {
    const Light twice = blurred(blurred(impulse, first), second);
    const Light once = blurred(impulse, first + second);
    for (int x = 50; x < 111; ++x) EXPECT_NEAR(twice.at(x, 0).x, once.at(x, 0).x, 1e-10) << x;
  }
}

TEST(TruthBlur, GaussianFoldsAtEdges) {
  for (const Edge edge : {Edge::clamp, Edge::mirror})
    for (const int size : {1, 2, 7})
      for (const double variance : {0.5, 30.0}) {
        const Axis axis = gaussian(size, variance, edge);
        for (std::size_t i = 0; i < axis.shares.size(); ++i)
          EXPECT_NEAR(sum(row(axis, i)), 1, 1e-12);
      }
  // Far wider than the picture: mirrored it is even, clamped the edges have most.
  EXPECT_NEAR(row(gaussian(5, 1000, Edge::mirror), 0)[2], 0.2, 1e-9);
  EXPECT_GT(row(gaussian(5, 1000, Edge::clamp), 0)[0], 0.4);
}

TEST(TruthBlur, AreaWeightsAtTwoToOneAreTheLectures) {
  const auto near = [](double value) { return DoubleNear(value, 1e-15); };
  const Axis down = areaDown(8, 4, Edge::mirror);
  EXPECT_THAT(row(down, 1), ElementsAre(near(0), near(1. / 8), near(3. / 8), near(3. / 8),
                                        near(1. / 8), near(0), near(0), near(0)));
  EXPECT_THAT(row(down, 0), ElementsAre(near(4. / 8), near(3. / 8), near(1. / 8), near(0), near(0),
                                        near(0), near(0), near(0)));
  const Axis up = areaUp(4, 8, Edge::mirror);
  EXPECT_THAT(row(up, 2), ElementsAre(near(0.25), near(0.75), near(0), near(0)));
  EXPECT_THAT(row(up, 3), ElementsAre(near(0), near(0.75), near(0.25), near(0)));
  EXPECT_THAT(row(up, 0), ElementsAre(near(1), near(0), near(0), near(0)));
}

TEST(TruthBlur, AreaWeightsOfOddSizesAreWorkedOutByHand) {
  // 3 to 1: the tent is 3 wide to each side of the middle, 1.5.
  const auto near = [](double value) { return DoubleNear(value, 1e-15); };
  const Axis down = areaDown(3, 1, Edge::clamp);
  // Pixel 1 has |x| < 1/6 of the tent: 1/3 - 2 * (1/6)^2 / 2. Beyond the edges lie 1/8 + 1/8.
  EXPECT_THAT(row(down, 0),
              ElementsAre(near((1 - 11. / 36) / 2), near(11. / 36), near((1 - 11. / 36) / 2)));
  // Mirrored, what lies more than one pixel outside falls on pixel 1.
  EXPECT_GT(row(areaDown(3, 1, Edge::mirror), 0)[1], 11. / 36 + 0.01);
}

TEST(TruthBlur, EveryFilterGivesAwayWhole) {
  const std::vector<Sample> some = {{-2, 0.25}, {0.3, 0.5}, {1.75, 0.25}};
  for (const Edge edge : {Edge::clamp, Edge::mirror})
    for (int from = 1; from <= 40; ++from) {
      const int to = std::max(from / 2, 1);
      for (const Axis& axis : {areaDown(from, to, edge), areaUp(to, from, edge),
                               samples(from, to, some, edge), samples(to, from, some, edge)})
        for (std::size_t i = 0; i < axis.shares.size(); ++i)
          EXPECT_NEAR(sum(row(axis, i)), 1, 1e-12) << from;
    }
}

TEST(TruthBlur, SamplesLieBetweenPixels) {
  const auto near = [](double value) { return DoubleNear(value, 1e-15); };
  // Target 1 of 4 lies at 3 of 8: right between pixels 2 and 3; 0.75 on.
  EXPECT_THAT(
      row(samples(8, 4, {{0.75, 1}}, Edge::clamp), 1),
      ElementsAre(near(0), near(0), near(0), near(0.75), near(0.25), near(0), near(0), near(0)));
  EXPECT_THAT(row(samples(2, 1, {{-2, 1}}, Edge::clamp), 0), ElementsAre(near(1), near(0)));
  EXPECT_THAT(row(samples(2, 1, {{-2, 1}}, Edge::mirror), 0), ElementsAre(near(0.5), near(0.5)));
}

TEST(TruthBlur, VarianceIsAboutTheTargetsCentre) {
  EXPECT_NEAR(variance(areaDown(64, 32, Edge::mirror)), 0.75, 1e-12);
  EXPECT_NEAR(variance(areaUp(32, 64, Edge::mirror)), 0.75 / 4, 1e-12) << "in source pixels";
  EXPECT_NEAR(variance(samples(64, 64, {{1, 1}}, Edge::clamp)), 1, 1e-12) << "a shift counts";
  EXPECT_NEAR(variance(gaussian(201, 9, Edge::clamp)), 9, 0.5);
}

/// The energy that an impulse at each source pixel leaves, from what it leaves of each target's.
std::vector<double> energyBefore(const Axis& axis, const std::vector<double>& after) {
  std::vector<double> before(std::size_t(axis.from));
  for (std::size_t i = 0; i < after.size(); ++i)
    for (const Axis::Share& share : axis.shares[i])
      before[std::size_t(share.source)] += share.weight * after[i];
  return before;
}

TEST(TruthBlur, ImpulsesKeepTheirEnergyThroughSixAreaWeightedLevels) {
  double worst = 0, worstClamped = 0;
  for (const Edge edge : {Edge::mirror, Edge::clamp})
    for (int size = 1; size <= 130; ++size) {
      std::vector<int> sizes(1, size);
      while (sizes.size() < 6) sizes.push_back(std::max(sizes.back() / 2, 1));
      for (std::size_t level = 0; level < sizes.size(); ++level) {
        std::vector<double> energy(std::size_t(size), 1.0);
        for (std::size_t i = 1; i <= level; ++i)
          energy = energyBefore(areaUp(sizes[i], sizes[i - 1], edge), energy);
        for (std::size_t i = level; i > 0; --i)
          energy = energyBefore(areaDown(sizes[i - 1], sizes[i], edge), energy);
        double& most = edge == Edge::mirror ? worst : worstClamped;
        for (const double one : energy) most = std::max(most, std::abs(one - 1));
      }
    }
  EXPECT_LT(worst, 1e-12) << "1% would do";
  EXPECT_GT(worstClamped, 0.05) << "clamped edges don't conserve it: the test can tell";
}

TEST(TruthBlur, RefusesWhatDoesNotFit) {
  EXPECT_THROW(areaDown(4, 0, Edge::clamp), std::invalid_argument);
  EXPECT_THROW(gaussianWeights(-1), std::invalid_argument);
  EXPECT_THROW(apply(Light(3, 3), areaDown(4, 2, Edge::clamp), areaDown(3, 1, Edge::clamp)),
               std::invalid_argument);
  Light light(2, 2);
  EXPECT_THROW(addTo(light, 1, Light(2, 1)), std::invalid_argument);
}

} // namespace
