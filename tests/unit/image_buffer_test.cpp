#include "not_finite.hpp"

#include "image/image.hpp"
#include "image/statistics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace ggrade;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace {

TEST(Image, TurnsBytesOfABottomFirstFrame) {
  const std::uint8_t bytes[] = {0, 51, 102, 255, /* upper row */ 255, 204, 153, 0};
  const Image image = Image::fromBytes(bytes, 1, 2, 4, RowOrder::bottomFirst);
  EXPECT_THAT(image.pixel(0, 0), ElementsAre(1.0f, 0.8f, 0.6f, 0.0f));
  EXPECT_THAT(image.pixel(0, 1), ElementsAre(0.0f, 0.2f, 0.4f, 1.0f));
  EXPECT_EQ(Image::fromBytes(bytes, 1, 2, 4).at(0, 0, 3), 1.0f);
  EXPECT_EQ(image.sizeText(), "1x2");
}

TEST(Image, KeepsFloatsBeyondTheDisplayRange) {
  const float values[] = {-2, 1e30f, 3, 0.5f};
  const Image image = Image::fromFloats(values, 2, 2, 1, RowOrder::bottomFirst);
  EXPECT_EQ(image.at(0, 0), 3);
  EXPECT_EQ(image.at(1, 1), 1e30f);
  EXPECT_EQ(image.at(0, 1), -2);
}

TEST(Image, RefusesWhatDoesNotFit) {
  const std::uint8_t bytes[7] = {};
  EXPECT_THAT([&] { Image::fromBytes(bytes, 1, 2, 4); },
              ThrowsMessage<std::invalid_argument>("Image: 7 values given, 1x2x4 needs 8"));
  EXPECT_THAT([] { Image(0, 5, 3); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("0x5 with 3 channels")));
  EXPECT_THROW(Image(1, 1, 5), std::invalid_argument);
  EXPECT_THROW(Image(Image::kMaxSide + 1, 1, 1), std::invalid_argument);
}

TEST(Image, StartsEmpty) {
  EXPECT_TRUE(Image().empty());
  EXPECT_EQ(Image().pixelCount(), 0u);
  EXPECT_FALSE(Image(1, 1, 1).empty());
}

TEST(Image, DropsTrailingChannels) {
  const float values[] = {1, 2, 3, 4, 5, 6, 7, 8};
  const Image image = firstChannels(Image::fromFloats(values, 2, 1, 4), 3);
  EXPECT_THAT(image.values(), ElementsAre(1, 2, 3, 5, 6, 7));
  EXPECT_THROW(firstChannels(image, 4), std::invalid_argument);
}

TEST(FindNonFinite, CountsPixelsAndNamesTheFirst) {
  Image image(5, 4, 4, 0.5f);
  EXPECT_FALSE(findNonFinite(image));
  image.at(3, 1, 1) = kNaN;
  image.at(3, 1, 2) = kInf; // the same pixel
  image.at(0, 3, 0) = -kInf;
  const auto found = findNonFinite(image);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->text(4), "2 pixels hold NaN or Inf, the first NaN at (3,1), channel G");
  EXPECT_EQ(found->pixels, 2u);
}

TEST(FindNonFinite, LooksAtTheChannelsAskedFor) {
  Image image(2, 2, 4, std::numeric_limits<float>::max());
  image.at(1, 1, 3) = -kInf;
  EXPECT_FALSE(findNonFinite(image, 3));
  ASSERT_TRUE(findNonFinite(image));
  EXPECT_EQ(findNonFinite(image)->text(4),
            "1 pixel holds NaN or Inf, the first -Inf at (1,1), channel A");
}

TEST(ErrorStatistics, FollowsTheFormulas) {
  const float a[] = {0, 1}, b[] = {0.5f, 1};
  const auto s =
      errorStatistics(Image::fromFloats(a, 2, 1, 1), Image::fromFloats(b, 2, 1, 1), 0.5f, 0.4f);
  EXPECT_DOUBLE_EQ(s.meanError, 0.25);
  EXPECT_DOUBLE_EQ(s.rmsError, std::sqrt(0.125));
  EXPECT_NEAR(s.psnr, 9.0309, 1e-4); // 10 log10(1 / 0.125)
  EXPECT_EQ(s.maxError, 0.5);
  EXPECT_EQ(s.maxX, 0);
  EXPECT_EQ(s.failPixels, 0u); // 0.5 is not over 0.5
  EXPECT_EQ(s.warnPixels, 1u);
}

TEST(ErrorStatistics, CountsAPixelOnceAndNamesTheWorstPlace) {
  Image a(4, 3, 3, 0.25f), b = a;
  b.at(2, 1, 0) = 0.5f;
  b.at(2, 1, 2) = 1.0f;
  b.at(3, 2, 1) = 0.0f;
  const auto s = errorStatistics(a, b);
  EXPECT_EQ(s.failPixels, 2u);
  EXPECT_EQ(s.maxError, 0.75);
  EXPECT_EQ(s.maxX, 2);
  EXPECT_EQ(s.maxY, 1);
  EXPECT_EQ(s.maxChannel, 2);
  EXPECT_DOUBLE_EQ(s.meanError, (0.25 + 0.75 + 0.25) / 36);
}

TEST(ErrorStatistics, PeakIsTheLargestValueAboveOne) {
  const auto s = errorStatistics(Image(2, 2, 1, 100.0f), Image(2, 2, 1, 100.5f));
  EXPECT_NEAR(s.psnr, 46.0639, 1e-4); // 20 log10(100.5 / 0.5)
}

TEST(ErrorStatistics, IdenticalImagesHaveInfinitePsnr) {
  const Image a(3, 3, 3, 0.7f);
  EXPECT_EQ(errorStatistics(a, a).maxError, 0);
  EXPECT_EQ(errorStatistics(a, a).psnr, std::numeric_limits<double>::infinity());
  EXPECT_THROW(errorStatistics(a, Image(3, 2, 3)), std::invalid_argument);
  EXPECT_THROW(errorStatistics(Image(), Image()), std::invalid_argument);
}

} // namespace
