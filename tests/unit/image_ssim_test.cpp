#include "image/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

using namespace ggrade;

namespace {

constexpr double kC1 = 1e-4, kC2 = 9e-4;

Image uniformNoise(int width, int height, int channels, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0, 1);
  Image image(width, height, channels);
  for (float& value : image.values()) value = uniform(random);
  return image;
}

TEST(Ssim, IsExactlyOneForIdenticalImages) {
  for (int channels : {1, 2, 3, 4})
    for (int side : {1, 2, 5, 11, 64}) {
      const Image image = uniformNoise(side, side + 3, channels, unsigned(side));
      EXPECT_EQ(ssim(image, image), 1.0) << side << ' ' << channels;
    }
}

TEST(Ssim, OfConstantsIsTheLuminanceTerm) {
  const double a = double(0.5f), b = double(0.75f);
  const double expected = (2 * a * b + kC1) / (a * a + b * b + kC1);
  EXPECT_NEAR(ssim(Image(40, 30, 1, 0.5f), Image(40, 30, 1, 0.75f)), expected, 1e-9);
  EXPECT_NEAR(ssim(Image(1, 1, 1, 0.5f), Image(1, 1, 1, 0.75f)), expected, 1e-9);
  EXPECT_NEAR(ssim(Image(7, 20, 1, 0.5f), Image(7, 20, 1, 0.75f)), expected, 1e-9);
}

// One white pixel under the middle of the only window: mean w, variance w - w^2, covariance 0.
TEST(Ssim, FollowsTheFormulaForOneWhitePixel) {
  const Image black(11, 11, 1);
  Image dot = black;
  dot.at(5, 5) = 1;
  double sum = 0;
  for (int i = -5; i <= 5; ++i) sum += std::exp(-i * i / 4.5);
  const double w = 1 / (sum * sum);
  const double expected = kC1 * kC2 / ((w * w + kC1) * (w - w * w + kC2));
  EXPECT_NEAR(ssim(black, dot), expected, 1e-12);
  EXPECT_NEAR(w, 0.0707622, 1e-6);
}

TEST(Ssim, IsSymmetricAndLowForUnrelatedNoise) {
  const Image a = uniformNoise(64, 64, 3, 1), b = uniformNoise(64, 64, 3, 2);
  EXPECT_DOUBLE_EQ(ssim(a, b), ssim(b, a));
  EXPECT_LT(ssim(a, b), 0.2);
}

TEST(Ssim, WeighsColourAsLumaAndIgnoresAlpha) {
  Image red(16, 16, 4, 0.0f), grey(16, 16, 4, 0.2989f);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) red.at(x, y, 0) = 1;
  EXPECT_NEAR(ssim(red, grey), 1.0, 1e-3); // 0.2989 * (0.2989 + 0.5870 + 0.1140) is 0.29887
}

TEST(Ssim, RefusesOtherSizesAndShowsNaN) {
  EXPECT_THROW(ssim(Image(4, 4, 1), Image(4, 5, 1)), std::invalid_argument);
  EXPECT_THROW(ssim(Image(), Image()), std::invalid_argument);
  Image bad(16, 16, 1);
  bad.at(8, 8) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(std::isnan(ssim(bad, Image(16, 16, 1))));
}

} // namespace
