#include "image/mask.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

using namespace ggrade;
using testing::ThrowsMessage;

namespace {

Mask randomMask(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Mask mask(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) mask.set(x, y, random() % 8 == 0);
  return mask;
}

Mask dilatedByDefinition(const Mask& mask, int radius) {
  Mask result(mask.width(), mask.height());
  for (int y = 0; y < mask.height(); ++y)
    for (int x = 0; x < mask.width(); ++x)
      for (int v = 0; v < mask.height(); ++v)
        for (int u = 0; u < mask.width(); ++u)
          if (mask.at(u, v) && std::abs(u - x) <= radius && std::abs(v - y) <= radius)
            result.set(x, y);
  return result;
}

TEST(Mask, DilatesAPixelToASquare) {
  Mask mask(9, 9);
  mask.set(4, 4);
  EXPECT_EQ(dilate(mask, 0), mask);
  EXPECT_EQ(dilate(mask, 1).count(), 9u);
  EXPECT_EQ(dilate(mask, 3).count(), 49u);
  EXPECT_EQ(dilate(mask, 100).count(), 81u);
  Mask corner(9, 9);
  corner.set(0, 0);
  EXPECT_EQ(dilate(corner, 1).count(), 4u);
  EXPECT_TRUE(dilate(corner, 1).at(1, 1));
}

TEST(Mask, DilationMatchesItsDefinition) {
  for (int radius : {0, 1, 2, 5, 20}) {
    const Mask mask = randomMask(17, 11, 3 + unsigned(radius));
    EXPECT_EQ(dilate(mask, radius), dilatedByDefinition(mask, radius)) << "radius " << radius;
  }
}

TEST(Mask, ErodesFromInsideButNotFromTheBorder) {
  Mask square(9, 9);
  for (int y = 3; y < 6; ++y)
    for (int x = 3; x < 6; ++x) square.set(x, y);
  EXPECT_EQ(erode(square, 1).count(), 1u);
  EXPECT_TRUE(erode(square, 1).at(4, 4));
  EXPECT_EQ(erode(square, 2).count(), 0u);
  const Mask full(9, 9, true);
  EXPECT_EQ(erode(full, 4), full);
}

TEST(Mask, CombinesPixelByPixel) {
  Mask a(2, 2), b(2, 2);
  a.set(0, 0);
  a.set(1, 0);
  b.set(1, 0);
  b.set(1, 1);
  EXPECT_EQ((a & b).count(), 1u);
  EXPECT_TRUE((a & b).at(1, 0));
  EXPECT_EQ((a | b).count(), 3u);
  EXPECT_FALSE((a | b).at(0, 1));
  EXPECT_EQ((~a).count(), 2u);
  EXPECT_EQ(~~a, a);
  EXPECT_THAT([&] { a& Mask(3, 2); },
              ThrowsMessage<std::invalid_argument>("Mask: sizes differ: 2x2 and 3x2"));
}

TEST(DifferenceMask, MarksWhatIsOverTheThreshold) {
  Image a(3, 1, 4, 0.5f), b = a;
  b.at(0, 0, 2) = 0.75f; // exactly the threshold
  b.at(1, 0, 1) = 0.25f - 1e-3f;
  b.at(2, 0, 3) = 1.0f; // alpha
  EXPECT_EQ(differenceMask(a, b, 0.25f).count(), 2u);
  const Mask colour = differenceMask(a, b, 0.25f, 3);
  EXPECT_EQ(colour.count(), 1u);
  EXPECT_TRUE(colour.at(1, 0));
  EXPECT_THROW(differenceMask(a, Image(3, 2, 4), 0), std::invalid_argument);
}

TEST(DifferenceMask, MarksNaNAgainstANumber) {
  Image a(2, 1, 1), b(2, 1, 1);
  a.at(0, 0) = std::numeric_limits<float>::quiet_NaN();
  a.at(1, 0) = b.at(1, 0) = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(differenceMask(a, b, 1e9f).at(0, 0));
  EXPECT_FALSE(differenceMask(a, b, 1e9f).at(1, 0));
  EXPECT_EQ(differenceMask(a, a, 0).count(), 0u);
}

} // namespace
