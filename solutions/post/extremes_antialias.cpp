// Antialiasing at its ends: nothing to smooth, everything to smooth, lines and squares of a pixel,
// windows that are one pixel high. Every method.

#include "drawn.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

using namespace extremes;

namespace {

class PostAntialias : public testing::TestWithParam<int> {
protected:
  json scene(const json& patch = json::object()) const {
    json all = {{"size", {120, 90}}, {"quality", {{"antialias", GetParam()}}}};
    all.merge_patch(patch);
    return sceneOf("post", {"antialias"}, all);
  }
};

INSTANTIATE_TEST_SUITE_P(Methods, PostAntialias, testing::Values(0, 1, 2), [](const auto& info) {
  return std::string(info.param == 0 ? "Fxaa" : info.param == 1 ? "Smaa" : "Mlaa");
});

/// High above it all, eyes up: nothing but the background.
const json kSky = {{"camera", {{"position", {0, 50, 0}}, {"target", {0, 60, 1}}}}};

/// Straight from above onto a ground whose squares are as large as a pixel. The coarsest mipmap but
/// one has a texel for each square.
json squaresOfAPixel(json patch = json::object()) {
  const double fov = 0.75, high = 22.5 / std::tan(fov / 2); // 90 pixels show 45 units
  patch["size"] = {120, 90};
  patch["wires"]["thickness"] = 0;
  patch["ground"]["size"] = 200;
  patch["camera"] = {{"position", {0, high, 0}},
                     {"target", {0, 0, 0}},
                     {"up", {0, 0, -1}},
                     {"fov", fov},
                     {"near", 10},
                     {"far", 100}};
  return patch;
}

/// The displayed picture.
Image before(const Drawn& drawn) {
  return drawn.leftBy(drawn.writerOf("uPicture"));
}

/// The pixels with a channel that isn't between the darkest and the brightest of the pixel and its
/// eight neighbours before antialiasing.
int outOfRange(const Drawn& drawn) {
  const Image sharp = before(drawn), &after = drawn.frames.at(0);
  int found = 0;
  for (int y = 0; y < after.height(); ++y)
    for (int x = 0; x < after.width(); ++x)
      for (int c = 0; c < 3; ++c) {
        float least = 1, most = 0;
        for (int j = std::max(y - 1, 0); j <= std::min(y + 1, after.height() - 1); ++j)
          for (int i = std::max(x - 1, 0); i <= std::min(x + 1, after.width() - 1); ++i) {
            least = std::min(least, sharp.at(i, j, c));
            most = std::max(most, sharp.at(i, j, c));
          }
        const float value = after.at(x, y, c), rounding = 1.01f / 255;
        if (value < least - rounding || value > most + rounding) {
          ++found;
          break;
        }
      }
  return found;
}

TEST_P(PostAntialias, AConstantPictureStaysBitForBit) {
  const Drawn drawn = draw("post", scene(kSky));
  EXPECT_EQ(differing(drawn.frames[0], before(drawn), 0), 0);
}

TEST_P(PostAntialias, ASecondFrameOfTheSameTimeIsTheSame) {
  const Drawn drawn = draw("post", scene(), {0.5, 0.9, 0.5});
  EXPECT_EQ(differing(drawn.frames[0], drawn.frames[2], 0), 0);
  EXPECT_GT(differing(drawn.frames[0], drawn.frames[1]), 0.01);
  EXPECT_GT(differing(drawn.frames[0], before(drawn)), 0.05);
}

TEST_P(PostAntialias, AnySize) {
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{1, 300}, std::pair{300, 1}}) {
    const Drawn drawn = draw("post", scene({{"size", {width, height}}}));
    EXPECT_EQ(drawn.frames[0].width(), width);
    EXPECT_EQ(drawn.frames[0].height(), height);
    EXPECT_EQ(outOfRange(drawn), 0) << width << " x " << height;
    if (width == height) {
      EXPECT_EQ(differing(drawn.frames[0], before(drawn), 0), 0) << "a pixel alone";
    }
  }
}

TEST_P(PostAntialias, NothingIsBrighterOrDarkerThanWhatIsAround) {
  const json thin = {{"wires", {{"thickness", 0.002}}}}; // far less than a pixel
  EXPECT_EQ(outOfRange(draw("post", scene(thin))), 0);
}

TEST_P(PostAntialias, LinesOfAPixelAreSmoothedAndStay) {
  // The wires alone, dark before a bright sky.
  const json look = {
      {"background", {2, 2, 2}},
      {"wires", {{"thickness", 0.03}}},
      {"camera", {{"position", {-1.7, 1.15, 1.2}}, {"target", {-1.7, 1.15, -1.2}}, {"fov", 0.9}}}};
  const Drawn drawn = draw("post", scene(look));
  const Image sharp = before(drawn), &after = drawn.frames.at(0);
  EXPECT_EQ(outOfRange(drawn), 0);
  double darkBefore = 0, darkAfter = 0; // what the wires take of the sky's light
  for (int y = 0; y < 60; ++y)          // above the ground
    for (int x = 0; x < 120; ++x) {
      darkBefore += double(1 - sharp.at(x, y, 1));
      darkAfter += double(1 - after.at(x, y, 1));
    }
  EXPECT_GT(differing(sharp, after), 0.01);
  EXPECT_NEAR(darkAfter / darkBefore, 1, 0.15);
}

TEST_P(PostAntialias, AChequerboardOfPixels) {
  const Drawn drawn = draw("post", scene(squaresOfAPixel()));
  const Image sharp = before(drawn), &after = drawn.frames.at(0);
  EXPECT_EQ(outOfRange(drawn), 0);
  int apart = 0;
  double meanBefore = 0, meanAfter = 0;
  for (int y = 0; y < 30; ++y) // where nothing stands on the ground
    for (int x = 0; x + 1 < 120; ++x) {
      apart += std::abs(sharp.at(x, y, 0) - sharp.at(x + 1, y, 0)) > 0.2f;
      meanBefore += double(sharp.at(x, y, 0)), meanAfter += double(after.at(x, y, 0));
    }
  EXPECT_EQ(apart, 30 * 119) << "not a square a pixel";
  EXPECT_NEAR(meanAfter / meanBefore, 1, 0.05);
}

TEST_P(PostAntialias, WhatIsLeftOutWouldChangeNothing) {
  // Of a constant picture, the weights.
  json patch = kSky;
  const Drawn less = draw("post", scene(patch), {0.5, 0.6});
  EXPECT_EQ(less.trace.passesOf(1).size(), GetParam() == 0 ? 3u : 5u);
  patch["debug"]["draw_all_passes"] = true;
  EXPECT_EQ(differing(less.frames[1], draw("post", scene(patch), {0.5, 0.6}).frames[1], 0), 0);
}

TEST(PostWithoutAntialias, TonesGoIntoTheWindow) {
  const json none = {{"size", {120, 90}}, {"effects", {{"antialias", false}}}};
  const Drawn drawn = draw("post", sceneOf("post", {"antialias"}, none), {0.5, 0.6});
  EXPECT_EQ(drawn.trace.passesOf(1).size(), 2u);
}

} // namespace
