#include "tradeoff/summary.hpp"
#include "words/words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <random>

using namespace ggrade::tradeoff;
using testing::ElementsAre;

namespace {

struct InJapanese {
  InJapanese() { gg::setLanguage(gg::Language::japanese); }
  ~InJapanese() { gg::setLanguage(gg::Language::english); }
};

std::vector<double> upTo(int count) {
  std::vector<double> values(count);
  std::iota(values.begin(), values.end(), 1);
  return values;
}

void expectInterval(int count, double low, double high) {
  const Interval interval = medianInterval(upTo(count));
  EXPECT_EQ(interval.low, low) << count;
  EXPECT_EQ(interval.high, high) << count;
  EXPECT_EQ(interval.median, (1 + count) / 2.0) << count;
}

TEST(TradeoffInterval, IsThatOfTheTables) {
  // Ranks of the 95% interval of a median as tables of the sign test have them.
  expectInterval(5, 1, 5); // of 94% only
  expectInterval(6, 1, 6);
  expectInterval(8, 1, 8);
  expectInterval(9, 2, 8);
  expectInterval(12, 3, 10);
  expectInterval(20, 6, 15);
  expectInterval(25, 8, 18);
  expectInterval(50, 18, 33);
  EXPECT_EQ(medianInterval({}).high, 0);
  EXPECT_EQ(medianInterval({3, 1, 2, 9, 8, 7}).low, 1) << "the order doesn't matter";
}

TEST(TradeoffInterval, HoldsTheMedianNineteenTimesOfTwenty) {
  std::mt19937 engine(3);
  std::exponential_distribution<double> late(1); // lopsided, as times are
  int held = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<double> sample(12);
    for (double& value : sample) value = late(engine);
    const Interval interval = medianInterval(sample);
    held += interval.low <= std::log(2) && std::log(2) <= interval.high;
  }
  EXPECT_GE(held, 1900);
}

TEST(TradeoffCost, IsTheMedianOfWhatPairsDifferBy) {
  // The machine slows down to half on the way: each run alone says nothing.
  Pairs pairs;
  for (int i = 0; i < 9; ++i) {
    pairs.without.push_back(10 + 3 * i);
    pairs.with.push_back(10 + 3 * i + 4 + 0.1 * (i % 3));
  }
  const Cost cost = costOf(pairs);
  EXPECT_NEAR(cost.median, 4.1, 1e-9);
  EXPECT_NEAR(cost.low, 4, 1e-9);
  EXPECT_NEAR(cost.high, 4.2, 1e-9);
  EXPECT_NEAR(cost.whole, 26.1, 1e-9);
  EXPECT_TRUE(cost.narrow);
}

TEST(TradeoffCost, IsNeverBelowZero) {
  const Cost cost = costOf({{9, 10, 11, 10, 9, 11}, {10, 10, 10, 11, 11, 10.5}});
  EXPECT_EQ(cost.median, 0);
  EXPECT_EQ(cost.low, 0);
  EXPECT_EQ(cost.high, 1);
  EXPECT_TRUE(cost.hidden());
  EXPECT_EQ(cost.value(), 1);
}

TEST(TradeoffCost, NeedsPairsUntilItIsKnownToATenthOfTheFrame) {
  Pairs pairs{{20, 20, 20, 20, 20}, {0, 0, 0, 0, 0}};
  EXPECT_TRUE(needsMore(pairs)) << "five say nothing yet";
  pairs.with.push_back(21.9);
  pairs.without.push_back(0);
  EXPECT_FALSE(needsMore(pairs)) << "1.9 of 20";
  pairs.with.back() = 22.1;
  EXPECT_TRUE(needsMore(pairs)) << "2.1 of 20";
  EXPECT_FALSE(costOf(pairs).narrow);
  for (int i = 0; i < 3; ++i) {
    pairs.with.push_back(20);
    pairs.without.push_back(0);
  }
  EXPECT_FALSE(needsMore(pairs)) << "of nine, one is left out at either end";
}

TEST(TradeoffCost, NeedsPairsUntilItIsKnownToATenthOfItself) {
  const std::vector<double> without(6, 90);
  EXPECT_FALSE(needsMore({{100, 100, 100, 100, 100, 100.9}, without})) << "0.9 of 10";
  EXPECT_TRUE(needsMore({{100, 100, 100, 100, 100, 101.1}, without})) << "1.1 of 10";
  EXPECT_FALSE(needsMore({{89, 90, 90, 91, 91, 92.1}, without})) << "it may be nothing";
}

TEST(TradeoffCost, IsBelowWhatItIsKnownToBe) {
  EXPECT_EQ(costText({3, 2, 4, 20, true}), "3.00 ms");
  EXPECT_EQ(costText({0, 0, 1.28, 20, true}), "below 1.3 ms");
  EXPECT_EQ(costText({0.2, 0, 1.2, 20, true}), "below 1.2 ms");
  EXPECT_EQ(costText({0, 0, 0.0312, 20, true}), "below 0.032 ms");
  EXPECT_EQ(costText({0, 0, 121, 2000, true}), "below 130 ms");
  EXPECT_EQ(costText({0, 0, 0, 20, true}), "none");
  EXPECT_EQ(msText(12.345), "12.3 ms");
  EXPECT_EQ(msText(0.4149), "0.41 ms");
  EXPECT_EQ(msText(0.01234), "0.012 ms");
  const InJapanese japanese;
  EXPECT_EQ(costText({0, 0, 1.28, 20, true}), "1.3 ms未満");
}

PresetRow row(std::vector<std::string> names, Cost cost, double error) {
  return {names, {{"size", int(100 * cost.whole)}}, cost, error};
}

TEST(TradeoffPresetRows, AreOneOfASetting) {
  const std::vector<Point> points = {{{{"size", 1}}, {1, 1, 1, 9, true}, {{"e", 0.1}}, {}, {}},
                                     {{{"size", 2}}, {2, 2, 2, 10, true}, {{"e", 0.05}}, {}, {}}};
  const auto rows = presetRows(
      points, {{"fast", "", 0}, {"balanced", "", 0}, {"accurate", "", 1}, {"reference", "", 1}});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].name(), "fast, balanced");
  EXPECT_EQ(rows[1].name(), "accurate, reference");
  EXPECT_EQ(rows[1].error, 0.05);
}

TEST(TradeoffSentence, SaysWhatIsBought) {
  const PresetRow fast = row({"fast", "balanced"}, {1.2, 1.1, 1.3, 19.3, true}, 0.031),
                  accurate = row({"accurate"}, {3, 2.9, 3.1, 21, true}, 0.0042),
                  reference = row({"reference"}, {14, 13.8, 14.1, 32.1, true}, 0.004);
  EXPECT_EQ(tradeText({fast, reference}),
            "Between fast (1.20 ms, error 3.1%) and reference (14.0 ms, error 0.40%), a frame "
            "takes 32.1 ms instead of 19.3 ms, and the error falls to 12.9% of it.");
  EXPECT_EQ(tradeText({fast, accurate, reference}),
            "Between fast (1.20 ms, error 3.1%) and reference (14.0 ms, error 0.40%), a frame "
            "takes 32.1 ms instead of 19.3 ms, and the error falls to 12.9% of it. With accurate "
            "(3.00 ms, error 0.42%) the error is nearly the least.");
  const PresetRow hidden = row({"fast"}, {0.3, 0, 0.7, 19.3, true}, 0.004),
                  same = row({"accurate", "reference"}, {0.5, 0, 0.9, 19.6, true}, 0.00401);
  EXPECT_EQ(tradeText({hidden, same}),
            "Between fast (below 0.7 ms, error 0.40%) and reference (below 0.9 ms, error 0.40%), a "
            "frame takes no longer, and the error does not fall.");
  EXPECT_EQ(tradeText({row({"fast", "reference"}, {1.2, 1.1, 1.3, 19.3, true}, 0.031)}),
            "fast, reference are one setting (1.20 ms, error 3.1%): there is nothing to trade.");
  const InJapanese japanese;
  EXPECT_EQ(tradeText({fast, accurate, reference}),
            "fast（1.20 ms、誤差3.1%）からreference（14.0 ms、誤差0.40%）へ："
            "1フレームの時間は19.3 msから32.1 msへ、誤差はその12.9%へ。"
            "accurate（3.00 ms、誤差0.42%）でも誤差はほぼ最小。");
  EXPECT_EQ(tradeText({hidden, same}),
            "fast（0.7 ms未満、誤差0.40%）からreference（0.9 ms未満、誤差0.40%）へ："
            "1フレームの時間は変わらず、誤差は減らず。");
}

} // namespace
