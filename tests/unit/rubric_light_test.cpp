// Light and shadow between two renderings of the reference, on pictures of a few pixels.

#include "rubric/light.hpp"

#include <gmock/gmock.h>

#include <array>

using namespace ggrade;
using namespace ggrade::rubric;

namespace {

using Color = std::array<float, 3>;

/// A picture of one row.
Image row(const std::vector<Color>& colors) {
  Image image(int(colors.size()), 1, 3);
  for (int x = 0; x < image.width(); ++x)
    for (int c = 0; c < 3; ++c) image.at(x, 0, c) = colors[std::size_t(x)][std::size_t(c)];
  return image;
}

constexpr Color kUnlit = {0.2f, 0.1f, 0.1f}, kLit = {0.8f, 0.5f, 0.1f};

Color between(float share) {
  Color color;
  for (std::size_t c = 0; c < 3; ++c) color[c] = kUnlit[c] + share * (kLit[c] - kUnlit[c]);
  return color;
}

TEST(RubricLight, VisibilityIsTheShareOfTheLightThatArrives) {
  const Image unlit = row({kUnlit, kUnlit, kUnlit, kUnlit});
  const Image unshadowed = row({kLit, kLit, kLit, kLit});
  const Image seen =
      visibility(row({kUnlit, kLit, between(0.25f), between(-0.3f)}), {unlit, unshadowed});
  EXPECT_NEAR(seen.at(0, 0), 0, 1e-5);
  EXPECT_NEAR(seen.at(1, 0), 1, 1e-5);
  EXPECT_NEAR(seen.at(2, 0), 0.25, 1e-5);
  EXPECT_NEAR(seen.at(3, 0), -0.3, 1e-5); // darker than without the lamp
  EXPECT_EQ(below(seen, 0.5f).count(), 3u);
  EXPECT_FALSE(below(seen, 0.5f).at(1, 0));
}

TEST(RubricLight, AColorThatNoAmountOfLightMakesIsUnexplained) {
  const Color green = {0.2f, 0.7f, 0.1f};
  // Far enough from each other that neighbours' tolerance says nothing.
  const std::vector<Color> dark(9, kUnlit);
  const Image unlit = row(dark), unshadowed = row(std::vector<Color>(9, kLit));
  std::vector<Color> colors = dark;
  colors[1] = between(0.4f);
  colors[4] = green;
  colors[7] = green;
  Mask region(9, 1, true);
  region.set(7, 0, false);
  const Mask odd = unexplained(row(colors), unlit, {unlit, unshadowed}, region);
  EXPECT_EQ(odd.count(), 1u);
  EXPECT_TRUE(odd.at(4, 0));
}

TEST(RubricLight, WhatTheReferenceShowsIsExplained) {
  const Color green = {0.2f, 0.7f, 0.1f};
  const Image unlit = row({kUnlit, kUnlit}), unshadowed = row({kLit, kLit});
  const Image picture = row({green, green});
  EXPECT_EQ(unexplained(picture, picture, {unlit, unshadowed}, Mask(2, 1, true)).count(), 0u);
  EXPECT_EQ(unexplained(picture, unlit, {unlit, unshadowed}, Mask(2, 1, true)).count(), 2u);
}

} // namespace
