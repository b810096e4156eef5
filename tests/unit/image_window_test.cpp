#include "image/mask.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

using namespace ggrade;

namespace {

std::size_t countInside(const Mask& mask, int x0, int y0, int width, int height) {
  std::size_t count = 0;
  for (int y = y0; y < y0 + height; ++y)
    for (int x = x0; x < x0 + width; ++x) count += mask.at(x, y);
  return count;
}

TEST(DensestWindow, IsCentredOnASmallObject) {
  Mask mask(200, 100);
  for (int y = 50; y < 54; ++y)
    for (int x = 80; x < 88; ++x) mask.set(x, y);
  const Window window = densestWindow(mask, 32);
  EXPECT_EQ(window.x, 68); // 12 columns left of 80, 12 right of 87
  EXPECT_EQ(window.y, 36);
  EXPECT_EQ(window.middleX, 83);
  EXPECT_EQ(window.middleY, 51);
  EXPECT_EQ(window.pixels, 32u);
  EXPECT_DOUBLE_EQ(window.share, 32.0 / 1024);
}

TEST(DensestWindow, PrefersTheDenserOfTwoPlaces) {
  Mask mask(100, 100);
  for (int i = 0; i < 20; ++i) mask.set(5 + i, 5);
  for (int i = 0; i < 21; ++i) mask.set(70, 70 + i);
  EXPECT_EQ(densestWindow(mask, 32).pixels, 21u);
  EXPECT_EQ(densestWindow(mask, 32).middleY, 80);
}

TEST(DensestWindow, AmongEqualsIsTheFirstInRowOrder) {
  Mask mask(100, 100);
  mask.set(80, 20);
  mask.set(10, 70);
  EXPECT_EQ(densestWindow(mask, 8).middleX, 80);
  EXPECT_EQ(densestWindow(mask, 8).middleY, 20);
}

TEST(DensestWindow, FindsTheMaximumOfRandomMasks) {
  std::mt19937 random(5);
  for (int round = 0; round < 20; ++round) {
    Mask mask(23, 31);
    for (int i = 0; i < 60; ++i) mask.set(int(random() % 23), int(random() % 31));
    std::size_t most = 0;
    for (int y = 0; y + 8 <= 31; ++y)
      for (int x = 0; x + 8 <= 23; ++x) most = std::max(most, countInside(mask, x, y, 8, 8));
    const Window window = densestWindow(mask, 8);
    EXPECT_EQ(window.pixels, most);
    EXPECT_EQ(countInside(mask, window.x, window.y, 8, 8), most);
  }
}

TEST(DensestWindow, IsClippedToASmallPicture) {
  const Window window = densestWindow(Mask(5, 40, true), 32);
  EXPECT_EQ(window.width, 5);
  EXPECT_EQ(window.height, 32);
  EXPECT_EQ(window.share, 1);
  const Window pixel = densestWindow(Mask(1, 1, true));
  EXPECT_EQ(pixel.share, 1);
  EXPECT_EQ(pixel.width, 1);
}

TEST(DensestWindow, StaysInsideThePicture) {
  Mask mask(64, 64);
  mask.set(63, 0);
  const Window window = densestWindow(mask, 32);
  EXPECT_EQ(window.x, 32);
  EXPECT_EQ(window.y, 0);
  EXPECT_EQ(window.middleX, 63);
}

TEST(DensestWindow, OfAnEmptyMaskHasNoArea) {
  EXPECT_EQ(densestWindow(Mask(64, 64)).width, 0);
  EXPECT_EQ(densestWindow(Mask()).share, 0);
  EXPECT_THROW(densestWindow(Mask(2, 2, true), 0), std::invalid_argument);
}

} // namespace
