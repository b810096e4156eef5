#include "tradeoff/analysis.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace ggrade::tradeoff;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

Point point(double ms, double error, int size = 0) {
  return {{{"size", size}}, {ms, ms, ms, ms, true}, {{"error", error}}, {}, {}};
}

/// A cost that is known to within so many milliseconds.
Point within(double ms, double off, double error) {
  return {{}, {ms, ms - off, ms + off, ms, true}, {{"error", error}}, {}, {}};
}

TEST(TradeoffSpread, IsTheMiddleHalf) {
  const Spread spread = spreadOf({9, 1, 3, 5, 7});
  EXPECT_DOUBLE_EQ(spread.median, 5);
  EXPECT_DOUBLE_EQ(spread.q1, 3);
  EXPECT_DOUBLE_EQ(spread.q3, 7);
  EXPECT_DOUBLE_EQ(spreadOf({1, 2}).median, 1.5);
  EXPECT_DOUBLE_EQ(spreadOf({1, 2}).q1, 1.25);
  EXPECT_DOUBLE_EQ(spreadOf({}).median, 0);
}

TEST(TradeoffFront, HoldsWhatNothingBeats) {
  EXPECT_THAT(paretoFront({point(5, 0.1), point(1, 0.4), point(2, 0.5), point(3, 0.2)}),
              ElementsAre(1, 3, 0));
}

TEST(TradeoffFront, OfEqualTimesHoldsTheBetterAndOfEqualErrorsTheFaster) {
  EXPECT_THAT(paretoFront({point(1, 0.4), point(1, 0.3), point(2, 0.3), point(3, 0.1)}),
              ElementsAre(1, 3));
  EXPECT_THAT(paretoFront({}), IsEmpty());
}

TEST(TradeoffFront, IsNotBeatenClearly) {
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> even(0, 1);
  std::vector<Point> points;
  for (int i = 0; i < 200; ++i) points.push_back(within(1 + 9 * even(engine), 0.05, even(engine)));
  const auto front = paretoFront(points);
  EXPECT_GT(front.size(), 3u);
  for (std::size_t k = 1; k < front.size(); ++k) {
    EXPECT_TRUE(faster(points[front[k - 1]].cost, points[front[k]].cost)) << k;
    EXPECT_GT(points[front[k - 1]].error(), points[front[k]].error()) << k;
  }
  for (const std::size_t index : front)
    EXPECT_TRUE(std::ranges::none_of(points, [&](const Point& other) {
      return faster(other.cost, points[index].cost) && other.error() < points[index].error();
    })) << index;
}

TEST(TradeoffFront, HoldsOfTimesThatMayBeTheSameTheLeastError) {
  // The first three may take the same time. Whichever seems to be the fastest, the third stands.
  for (const double seen : {0.96, 1.0, 1.04})
    EXPECT_THAT(paretoFront({within(seen, 0.1, 0.4), within(1.02, 0.1, 0.3), within(1.01, 0.1, 0.2),
                             within(3, 0.1, 0.1)}),
                ElementsAre(2, 3))
        << seen;
  // Apart, but by less than a run differs from the next.
  EXPECT_THAT(paretoFront({point(1.00, 0.4), point(1.04, 0.3)}), ElementsAre(1));
  EXPECT_THAT(paretoFront({point(1.00, 0.4), point(1.06, 0.3)}), ElementsAre(0, 1));
}

TEST(TradeoffFront, OfTwoRunsIsTheSame) {
  // 40 settings, twelve kinds of cost, measured to within 1% and seen with an interval of 2%.
  std::vector<std::vector<std::size_t>> fronts;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> noise(-1, 1);
    std::vector<Point> points;
    for (int i = 0; i < 40; ++i) {
      const double ms = 3 * std::pow(1.3, i % 12) * (1 + 0.01 * noise(engine));
      points.push_back(within(ms, 0.02 * ms, 0.5 / (1 + (i * 7) % 40)));
    }
    fronts.push_back(paretoFront(points));
  }
  for (const auto& front : fronts) EXPECT_EQ(front, fronts[0]);
}

TEST(TradeoffRecommendation, HasTheLeastErrorWithinTheBudget) {
  const std::vector<Point> points = {point(1, 0.4), point(4.9, 0.1), point(5.1, 0.01)};
  EXPECT_EQ(withinBudget(points, 5), 1u);
  EXPECT_EQ(withinBudget(points, 100), 2u);
  EXPECT_EQ(withinBudget(points, 0.5), std::nullopt);
  EXPECT_EQ(withinBudget({point(1, 0.4), within(4.9, 0.2, 0.1)}, 5), 0u) << "perhaps beyond it";
}

TEST(TradeoffRecommendation, IsTheFastestWithinTheError) {
  const std::vector<Point> points = {point(9, 0.001), point(3, 0.009), point(1, 0.011)};
  EXPECT_EQ(withinError(points, 0.01), 1u);
  EXPECT_EQ(withinError(points, 0.011), 2u);
  EXPECT_EQ(withinError(points, 0.0001), std::nullopt);
}

TEST(TradeoffRecommendation, OfTheSameTimeHasTheLesserError) {
  EXPECT_EQ(withinError({point(1.00, 0.009), point(1.04, 0.002)}, 0.01), 1u);
  EXPECT_EQ(withinError({point(1.00, 0.009), point(1.06, 0.002)}, 0.01), 0u);
}

TEST(TradeoffRecommendation, TakesErrorsForEqualWithinTwoPerCentOrOneInTenThousand) {
  EXPECT_TRUE(nearlyEqual(0.100, 0.102));
  EXPECT_FALSE(nearlyEqual(0.100, 0.1021));
  EXPECT_TRUE(nearlyEqual(0.00001, 0.00010));
  EXPECT_FALSE(nearlyEqual(0.0001, 0.00021));
}

TEST(TradeoffRecommendation, OfNearlyEqualErrorsIsTheFasterTenTimesOfTen) {
  // Frames vary by a fifth and one in six is disturbed; the faster is faster by a tenth.
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> noise(0, 0.2);
    std::vector<double> slow, quick;
    for (int frame = 0; frame < 240; ++frame) {
      const double disturbed = frame % 6 == 0 ? 20 : 0;
      slow.push_back(4.4 + noise(engine) + disturbed);
      quick.push_back(4.0 + noise(engine) + disturbed);
    }
    std::vector<Point> points = {point(0, 0.0100), point(0, 0.0101), point(0.1, 0.3)};
    points[0].cost = costOf({slow, std::vector<double>(slow.size())});
    points[1].cost = costOf({quick, std::vector<double>(quick.size())});
    EXPECT_EQ(withinBudget(points, 10), 1u) << "seed " << seed;
    EXPECT_EQ(withinError(points, 0.02), 1u) << "seed " << seed;
  }
}

TEST(TradeoffRecommendation, DoesNotTakeALargerErrorForSpeed) {
  EXPECT_EQ(withinBudget({point(4, 0.0100), point(1, 0.0103)}, 10), 0u);
}

TEST(TradeoffPresets, FollowTheirRules) {
  const std::vector<Point> points = {point(1, 0.50, 1),   point(2, 0.039, 2),  point(3, 0.015, 3),
                                     point(8, 0.0109, 4), point(40, 0.010, 5), point(50, 0.02, 6)};
  const auto presets = presetsOf(points, {{"size", 6}});
  ASSERT_EQ(presets.size(), 4u);
  EXPECT_EQ(presets[0].name, "fast");
  EXPECT_EQ(presets[0].point, 1u);
  EXPECT_EQ(presets[0].rule, "the fastest with at most 4 times the least error");
  EXPECT_EQ(presets[1].name, "balanced");
  EXPECT_EQ(presets[1].point, 2u);
  EXPECT_EQ(presets[2].name, "accurate");
  EXPECT_EQ(presets[2].point, 3u);
  EXPECT_EQ(presets[2].rule, "the fastest within 10% of the least error");
  EXPECT_EQ(presets[3].name, "reference");
  EXPECT_EQ(presets[3].point, 5u);
}

TEST(TradeoffPresets, AreNotChosenByNoise) {
  std::vector<Point> points = {point(149, 0.0487), within(160, 12, 0.0446), point(300, 0.0445)};
  const auto presets = presetsOf(points, {});
  EXPECT_EQ(presets[0].point, 1u) << "it may be as fast as the first";
  EXPECT_EQ(presets[2].point, 1u);
  points[1] = within(160, 5, 0.0446);
  EXPECT_EQ(presetsOf(points, {})[2].point, 0u) << "it is slower";
}

TEST(TradeoffPresets, OfOneSettingAreThatSetting) {
  const auto presets = presetsOf({point(0, 0, 1)}, {{"size", 9}});
  ASSERT_EQ(presets.size(), 3u) << "there is no reference if it was not measured";
  for (const Preset& preset : presets) EXPECT_EQ(preset.point, 0u);
}

TEST(TradeoffGrowth, FindsThePower) {
  std::vector<double> x, y;
  for (double value : {64, 128, 256, 512}) {
    x.push_back(value);
    y.push_back(3e-5 * value * value);
  }
  const auto growth = growthOf(x, y);
  ASSERT_TRUE(growth);
  EXPECT_NEAR(growth->exponent, 2, 1e-9);
  EXPECT_NEAR(growth->factor, 3e-5, 1e-12);
  EXPECT_NEAR(growth->deviation, 0, 1e-9);
}

TEST(TradeoffGrowth, SaysHowFarTheLineIsOff) {
  // Half as much, twice as much by turns: a factor of 2 from the line, nearly.
  const auto growth = growthOf({1, 2, 4, 8}, {2, 0.5, 0.5, 2});
  ASSERT_TRUE(growth);
  EXPECT_NEAR(growth->exponent, 0, 1e-9);
  EXPECT_NEAR(growth->deviation, 1, 1e-9);
}

TEST(TradeoffGrowth, LeavesOutWhatHasNoLogarithm) {
  const auto growth = growthOf({0, 1, 2, 4}, {7, 1, 2, 4});
  ASSERT_TRUE(growth);
  EXPECT_NEAR(growth->exponent, 1, 1e-9);
  EXPECT_FALSE(growthOf({1, 2}, {-1, 3}));
  EXPECT_FALSE(growthOf({2, 2}, {1, 3}));
  EXPECT_FALSE(growthOf({}, {}));
}

TEST(TradeoffFall, IsToldWhereItHappens) {
  EXPECT_EQ(fallText("mirror_size", {"64", "128", "256"}, {0.4, 0.2, 0.1}),
            "The error falls with mirror_size: from 40.0% at 64 to 10.0% at 256.");
}

TEST(TradeoffFall, SaysFromWhereOnNothingIsGained) {
  EXPECT_EQ(fallText("mirror_size", {"64", "128", "256", "512"}, {0.04, 0.02, 0.01, 0.0101}),
            "The error does not fall beyond mirror_size 256: from 4.0% at 64 to 1.0% there; "
            "1.0% at 512 (+1.0%).");
  EXPECT_EQ(fallText("mirror_size", {"64", "128", "256"}, {0.04, 0.002, 0.00195}),
            "The error hardly falls beyond mirror_size 128: from 4.0% at 64 to 0.20% there; "
            "0.19% at 256 (-2.5%).");
}

TEST(TradeoffFall, SaysByHowMuchItRises) {
  EXPECT_EQ(fallText("pcf_radius", {"0", "1", "2"}, {0.010, 0.005, 0.009}),
            "The error does not fall beyond pcf_radius 1: from 1.0% at 0 to 0.50% there; it has "
            "risen to 0.90% at 2 (+80%).");
  EXPECT_EQ(fallText("pcf_radius", {"0", "1"}, {0.010, 0.015}),
            "The error does not fall with pcf_radius: 1.0% at 0, and it has risen to 1.5% at 1 "
            "(+50%).");
  EXPECT_EQ(fallText("shadow_bias", {"0", "1", "2"}, {0.03, 0, 0.01}),
            "The error does not fall beyond shadow_bias 1: from 3.0% at 0 to 0 there; it has risen "
            "to 1.0% at 2.");
  EXPECT_EQ(fallText("n", {"1", "2", "3"}, {0.2, 0.3, 0.1}),
            "The error falls with n: from 20.0% at 1 to 10.0% at 3. On the way it rises from "
            "20.0% at 1 to 30.0% at 2.");
}

TEST(TradeoffFall, SaysThatANumberMakesNoDifference) {
  EXPECT_EQ(fallText("shadow_bits", {"16", "24"}, {0.0101, 0.0100}),
            "shadow_bits makes no difference to the error here: 1.0% to 1.0% at every value.");
}

TEST(TradeoffText, HasTwoFiguresOfAnError) {
  EXPECT_EQ(errorText(0), "0");
  EXPECT_EQ(errorText(0.25), "25.0%");
  EXPECT_EQ(errorText(0.012), "1.2%");
  EXPECT_EQ(errorText(0.00034), "0.034%");
  EXPECT_EQ(errorText(3.1e-7), "3.1e-07");
}

} // namespace
