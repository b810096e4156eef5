#include "not_finite.hpp"

#include "image/compare.hpp"
#include "image/neighbourhood.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <stdexcept>

using namespace ggrade;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace {

/// Stripes 4 pixels wide whose 15 edges lie at x = 2, 6, ..., 58, moved right by `shift`.
Image stripes(int shift) {
  Image image(61, 64, 3);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 61; ++x)
      for (int c = 0; c < 3; ++c) image.at(x, y, c) = (x - shift + 2) / 4 % 2 == 0 ? 0.2f : 0.9f;
  return image;
}

Image withLine(bool line) {
  Image image(32, 32, 3, 0.1f);
  for (int y = 0; line && y < 32; ++y) image.at(16, y, 1) = 0.8f;
  return image;
}

TEST(Compare, IdenticalImagesHaveNothingWrong) {
  const auto result = compare(stripes(0), stripes(0), {.tolerance = 0, .radius = 0});
  EXPECT_TRUE(result.compared());
  EXPECT_EQ(result.wrongShare, 0);
  EXPECT_EQ(result.meanAbsoluteError, 0);
  EXPECT_EQ(result.judgedPixels, 3904u);
  EXPECT_FALSE(result.worst);
  EXPECT_EQ(result.densest.width, 0);
  EXPECT_EQ(result.message, "0% of 3904 pixels differ");
}

TEST(Compare, ForgivesAShiftByTheRadiusAndNoMore) {
  EXPECT_EQ(compare(stripes(1), stripes(0)).wrongShare, 0);
  // Without a radius one column at every edge differs; shifted twice the radius, both columns do.
  EXPECT_DOUBLE_EQ(compare(stripes(1), stripes(0), {.radius = 0}).wrongShare, 15.0 / 61);
  EXPECT_DOUBLE_EQ(compare(stripes(2), stripes(0)).wrongShare, 30.0 / 61);
  EXPECT_EQ(compare(stripes(2), stripes(0), {.radius = 2}).wrongShare, 0);
}

TEST(Compare, CatchesASmallObjectThatIsMissing) {
  const Image student(640, 480, 4, 0.5f);
  Image reference = student;
  for (int y = 200; y < 208; ++y)
    for (int x = 100; x < 108; ++x) reference.at(x, y, 0) = 1.0f;
  const auto result = compare(student, reference, {.channels = 3});
  EXPECT_EQ(result.wrongPixels, 64u);
  EXPECT_DOUBLE_EQ(result.wrongShare, 64.0 / 307200);
  EXPECT_DOUBLE_EQ(result.densest.share, 64.0 / 1024);
  EXPECT_EQ(result.densest.x, 88);
  EXPECT_EQ(result.densest.y, 188);
  EXPECT_DOUBLE_EQ(result.meanDifference, -0.5 * 64 / (307200.0 * 3));
  EXPECT_DOUBLE_EQ(result.meanAbsoluteError, 0.5 * 64 / (307200.0 * 3));
  EXPECT_EQ(result.message, "0.0208% of 307200 pixels differ, densest at (103,203): 6% of 32x32, "
                            "worst at (100,200): R is 0.5, expected 1");
}

TEST(Compare, CatchesAThinLineMissingInEitherImage) {
  const auto missing = compare(withLine(false), withLine(true));
  EXPECT_EQ(missing.wrongPixels, 32u);
  EXPECT_TRUE(missing.wrong.at(16, 0));
  EXPECT_FALSE(missing.wrong.at(15, 0));
  EXPECT_LT(missing.meanDifference, 0);
  const auto extra = compare(withLine(true), withLine(false));
  EXPECT_EQ(extra.wrongPixels, 32u);
  EXPECT_EQ(extra.wrong, missing.wrong);
  EXPECT_GT(extra.meanDifference, 0);
}

TEST(Compare, PublishedToleranceIsThreeStepsOfEightBits) {
  for (int value = 0; value + 4 <= 255; ++value) {
    const auto share = [&](int steps) {
      const Image a(4, 4, 1, float(value) / 255.0f), b(4, 4, 1, float(value + steps) / 255.0f);
      return compare(a, b).wrongShare + compare(b, a).wrongShare;
    };
    EXPECT_EQ(share(3), 0) << value;
    EXPECT_EQ(share(4), 2) << value;
  }
}

TEST(Compare, ConstantImagesDifferEverywhere) {
  const auto result = compare(Image(64, 48, 3, 0.75f), Image(64, 48, 3, 0.25f));
  EXPECT_EQ(result.wrongShare, 1);
  EXPECT_EQ(result.densest.share, 1);
  EXPECT_DOUBLE_EQ(result.meanAbsoluteError, 0.5);
  EXPECT_DOUBLE_EQ(result.meanDifference, 0.5);
}

TEST(Compare, OnePixelImages) {
  EXPECT_EQ(compare(Image(1, 1, 1, 0.5f), Image(1, 1, 1, 0.5f)).wrongShare, 0);
  const auto result = compare(Image(1, 1, 1, 0.5f), Image(1, 1, 1, 1.0f), {.radius = kMaxRadius});
  EXPECT_EQ(result.wrongShare, 1);
  EXPECT_EQ(result.message, "100% of 1 pixels differ, densest at (0,0): 100% of 1x1, worst at "
                            "(0,0): Y is 0.5, expected 1");
}

TEST(Compare, WorstPixelIsTheFarthestOutsideTheRange) {
  Image reference(16, 16, 3, 0.5f);
  reference.at(8, 8, 0) = 0.9f; // widens the range of its neighbours
  Image student = reference;
  student.at(2, 3, 2) = 0.8f;
  student.at(9, 8, 0) = 1.0f; // 0.5 from its own pixel, only 0.1 outside the range
  const auto worst = compare(student, reference).worst;
  ASSERT_TRUE(worst);
  EXPECT_EQ(worst->x, 2);
  EXPECT_EQ(worst->y, 3);
  EXPECT_EQ(worst->channel, 2);
  EXPECT_FLOAT_EQ(worst->error, 0.3f);
  EXPECT_EQ(worst->student[2], 0.8f);
  EXPECT_EQ(worst->reference[2], 0.5f);
}

TEST(Compare, LooksOnlyInsideTheMask) {
  const Image student(10, 10, 3, 0.5f);
  Image reference = student;
  for (int x = 0; x < 10; ++x) reference.at(x, 2, 0) = 0.0f;
  Mask mask(10, 10);
  for (int y = 2; y < 4; ++y)
    for (int x = 0; x < 5; ++x) mask.set(x, y);
  const auto result = compare(student, reference, {.mask = &mask});
  EXPECT_EQ(result.judgedPixels, 10u);
  EXPECT_EQ(result.wrongPixels, 5u);
  EXPECT_DOUBLE_EQ(result.wrongShare, 0.5);
  EXPECT_DOUBLE_EQ(result.meanAbsoluteError, 0.5 * 5 / 30);
  EXPECT_EQ(result.wrong.count(), 5u);
}

TEST(Compare, AnEmptyMaskIsNotAPass) {
  const Image image(8, 8, 3);
  const Mask nothing(8, 8);
  const auto result = compare(image, image, {.mask = &nothing});
  EXPECT_EQ(result.status, ComparisonStatus::nothingToCompare);
  EXPECT_EQ(result.wrongShare, 1);
  EXPECT_EQ(result.message, "no pixel lies in the region to judge");
  EXPECT_EQ(compare(Image(), image).message, "there is no image");
  EXPECT_EQ(compare(image, Image()).message, "there is no reference image");
}

TEST(Compare, OtherSizesAreAnOutcomeNotAnException) {
  const Mask mask(640, 480, true);
  const auto result = compare(Image(320, 240, 4), Image(640, 480, 4), {.mask = &mask});
  EXPECT_EQ(result.status, ComparisonStatus::sizesDiffer);
  EXPECT_EQ(result.message, "the image is 320x240, the reference 640x480");
  EXPECT_EQ(result.wrongShare, 1);
}

TEST(Compare, ComparesLeadingChannelsOfDifferentLayouts) {
  Image rgba(4, 4, 4, 0.5f), rgb(4, 4, 3, 0.5f);
  EXPECT_EQ(compare(rgba, rgb).status, ComparisonStatus::channelsDiffer);
  EXPECT_EQ(compare(rgba, rgb).message,
            "the image has 4 channels, the reference 3; 3 are compared");
  EXPECT_EQ(compare(rgba, rgb, {.channels = 3}).wrongShare, 0);
  rgb.at(1, 1, 2) = 0.0f;
  EXPECT_EQ(compare(rgba, rgb, {.channels = 3}).wrongPixels, 1u);
  EXPECT_EQ(compare(rgba, rgb, {.channels = 2}).wrongPixels, 0u);
  EXPECT_EQ(compare(rgb, rgb, {.channels = 4}).status, ComparisonStatus::channelsDiffer);
}

TEST(Compare, IgnoresAlphaWhenColourIsAsked) {
  Image student(4, 4, 4, 0.5f);
  const Image reference = student;
  student.at(0, 0, 3) = 0;
  student.at(1, 1, 3) = kNaN;
  EXPECT_EQ(compare(student, reference, {.channels = 3}).wrongShare, 0);
  EXPECT_EQ(compare(student, reference).status, ComparisonStatus::studentNotFinite);
}

TEST(Compare, NamesNaNBeforeAnyMetric) {
  Image bad(6, 4, 3, 0.5f);
  const Image good = bad;
  bad.at(4, 2, 0) = kNaN;
  const auto student = compare(bad, good);
  EXPECT_EQ(student.status, ComparisonStatus::studentNotFinite);
  EXPECT_EQ(student.wrongShare, 1);
  EXPECT_EQ(student.message,
            "the image: 1 pixel holds NaN or Inf, the first NaN at (4,2), channel R");
  ASSERT_TRUE(student.nonFinite);
  EXPECT_EQ(student.nonFinite->x, 4);
  EXPECT_EQ(compare(good, bad).status, ComparisonStatus::referenceNotFinite);
  EXPECT_EQ(compare(bad, bad).status, ComparisonStatus::studentNotFinite);
}

TEST(Compare, SurvivesHugeValues) {
  const float huge = std::numeric_limits<float>::max();
  const auto result = compare(Image(4, 4, 1, huge), Image(4, 4, 1, -huge));
  EXPECT_EQ(result.wrongShare, 1);
  EXPECT_DOUBLE_EQ(result.meanDifference, 2 * double(huge));
}

TEST(CompareWithBest, TakesTheReferenceThatFits) {
  const Image dark(8, 8, 3, 0.2f), light(8, 8, 3, 0.8f), middle(8, 8, 3, 0.5f);
  const auto best = compareWithBest(light, std::array{&dark, &middle, &light, &light});
  EXPECT_EQ(best.reference, 2u) << "the first of equals";
  EXPECT_EQ(best.comparison.wrongShare, 0);
  EXPECT_EQ(best.comparison.message, "0% of 64 pixels differ");
}

TEST(CompareWithBest, TakesTheLeastWrongWhereNoneFits) {
  const Image student = withLine(true);
  Image oneOff = student, black(32, 32, 3);
  oneOff.at(4, 4, 0) = 1;
  const auto best = compareWithBest(student, std::array<const Image*, 2>{&black, &oneOff});
  EXPECT_EQ(best.reference, 1u);
  EXPECT_EQ(best.comparison.wrongPixels, compare(student, oneOff).wrongPixels);
  EXPECT_GT(best.comparison.wrongPixels, 0u);
  // The mask decides what counts.
  Mask corner(32, 32);
  corner.set(31, 31);
  EXPECT_EQ(compareWithBest(student, std::array{&oneOff, &black}, {.mask = &corner}).reference, 0u);
}

TEST(CompareWithBest, PassesOverWhatCannotBeCompared) {
  const Image student(8, 8, 3, 0.5f), wrong(8, 8, 3, 0.9f), small(4, 8, 3, 0.5f);
  const auto best = compareWithBest(student, std::array{&small, &wrong});
  EXPECT_EQ(best.reference, 1u);
  EXPECT_TRUE(best.comparison.compared());
  EXPECT_EQ(compareWithBest(student, std::array{&wrong, &small}).reference, 0u);
  const auto none = compareWithBest(small, std::array{&student, &wrong});
  EXPECT_EQ(none.reference, 0u);
  EXPECT_EQ(none.comparison.status, ComparisonStatus::sizesDiffer);
  EXPECT_EQ(none.comparison.wrongShare, 1);
  EXPECT_THROW(compareWithBest(student, {}), std::invalid_argument);
}

TEST(Compare, RefusesOptionsThatMakeNoSense) {
  const Image image(8, 8, 3);
  const Mask other(8, 9, true);
  EXPECT_THAT([&] { compare(image, image, {.mask = &other}); },
              ThrowsMessage<std::invalid_argument>("compare: the mask is 8x9, the reference 8x8"));
  EXPECT_THROW(compare(image, image, {.tolerance = -0.1f}), std::invalid_argument);
  EXPECT_THROW(compare(image, image, {.tolerance = kNaN}), std::invalid_argument);
  EXPECT_THAT([&] { compare(image, image, {.radius = 65}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("0 to 64")));
  EXPECT_THROW(compare(image, image, {.channels = 5}), std::invalid_argument);
  EXPECT_THROW(compare(image, image, {.windowSide = 0}), std::invalid_argument);
}

TEST(NeighbourhoodRows, MatchItsDefinition) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> uniform(-1, 1);
  for (int radius : {0, 1, 2, 5, 40}) {
    Image image(19, 13, 3);
    for (float& value : image.values()) value = uniform(random);
    NeighbourhoodRows rows(image, radius);
    // Every row, or with gaps.
    for (int y = 0; y < 13; y += radius == 2 ? 1 + y % 5 : 1) {
      rows.moveTo(y);
      for (int x = 0; x < 19; ++x)
        for (int c = 0; c < 3; ++c) {
          float low = 2, high = -2;
          for (int v = std::max(0, y - radius); v <= std::min(12, y + radius); ++v)
            for (int u = std::max(0, x - radius); u <= std::min(18, x + radius); ++u) {
              low = std::min(low, image.at(u, v, c));
              high = std::max(high, image.at(u, v, c));
            }
          ASSERT_EQ(rows.low()[std::size_t(x * 3 + c)], low) << radius << ' ' << x << ' ' << y;
          ASSERT_EQ(rows.high()[std::size_t(x * 3 + c)], high) << radius << ' ' << x << ' ' << y;
        }
    }
  }
}

} // namespace
