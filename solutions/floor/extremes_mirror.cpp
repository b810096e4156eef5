// The mirror at its ends: an eye on the floor or far off, a reflection of one texel.

#include "drawn.hpp"

#include <gmock/gmock.h>

#include <cmath>

using namespace extremes;
using testing::Each;

namespace {

json mirrorScene(const json& patch = {}) {
  json all = {{"size", {121, 91}}, {"mesh", "box"}, {"floor", {{"tiles_per_unit", 0}}}};
  if (!patch.is_null()) all.merge_patch(patch);
  return sceneOf("floor", {"mirror"}, all);
}

Image first(const json& scene) {
  return draw("floor", scene).frames.at(0);
}

json without(json scene) {
  scene["effects"]["mirror"] = false;
  return scene;
}

// What the floor adds of what it reflects: its specular colour.
constexpr float kShare = 0.5f;
// The background, all channels.
constexpr float kBackground[] = {0.1f, 0.2f, 0.3f};

/// Does the pixel show the floor with `reflected` in it?
void expectReflects(const Image& mirror, const Image& plain, int x, int y, const float* reflected) {
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(mirror.at(x, y, c), std::min(plain.at(x, y, c) + kShare * reflected[c], 1.0f),
                1.6f / 255)
        << x << ' ' << y << ' ' << c;
}

TEST(Mirror, AReflectionOfOneTexelIsOneColour) {
  const json scene = mirrorScene({{"quality", {{"mirror_size", 1}}}});
  const Drawn drawn = draw("floor", scene);
  const Image texel = drawn.leftBy(drawn.writerOf("uReflection"));
  ASSERT_EQ(texel.sizeText(), "1x1");
  const Image plain = first(without(scene));
  for (const auto& [x, y] : {std::pair(60, 80), std::pair(20, 80), std::pair(100, 75)})
    expectReflects(drawn.frames[0], plain, x, y, &texel.values()[0]);
}

TEST(Mirror, ABlurOfOneTexelIsThatTexel) {
  json scene = mirrorScene({{"quality", {{"mirror_size", 1}}}});
  const Image sharp = first(scene);
  for (int samples : {0, 1, 256}) {
    scene["mirror"]["blur"] = 1;
    scene["quality"]["blur_samples"] = samples;
    EXPECT_EQ(differing(sharp, first(scene)), 0) << samples;
  }
}

TEST(Mirror, TheWidestBlurOfOneColourIsThatColour) {
  const json scene = mirrorScene({{"mirror", {{"blur", 1}}}, {"ring", {{"count", 0}}}});
  const Image image = first(scene), plain = first(without(scene));
  for (const auto& [x, y] : {std::pair(60, 80), std::pair(20, 80), std::pair(60, 40)})
    expectReflects(image, plain, x, y, kBackground);
}

class EyeHeight : public testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(Mirror, EyeHeight, testing::Values(0.0, -0.0, -1e-30, -1e-6, -3.4, -1e8));

TEST_P(EyeHeight, FromTheFloorOrBelowNothingIsReflected) {
  json scene = mirrorScene({{"camera", {{"position", {0, GetParam(), 7}}, {"far", 1e9}}}});
  const Drawn drawn = draw("floor", scene);
  EXPECT_EQ(differing(drawn.frames[0], first(without(scene)), 0), 0);
  EXPECT_EQ(drawn.trace.passesOf(0).size(), 1u) << "nor drawn";
  scene["debug"]["draw_all_passes"] = true;
  EXPECT_EQ(differing(drawn.frames[0], first(scene), 0), 0) << "nor seen, if it is";
}

class LowEye : public testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(Mirror, LowEye, testing::Values(1e-30, 1e-9, 1e-4));

TEST_P(LowEye, JustAboveTheFloorItIsALine) {
  const json scene =
      mirrorScene({{"camera", {{"position", {0, GetParam(), 7}}, {"target", {0, 0, 0}}}}});
  const Image image = first(scene), plain = first(without(scene));
  EXPECT_LE(differing(image, plain), 0.012) << "one row at most";
}

TEST(Mirror, FromStraightAbove) {
  const json scene = mirrorScene({{"camera", {{"position", {0, 9, 0}}, {"target", {0, 0, 0}}}},
                                  {"ring", {{"count", 4}, {"radius", 1.5}}}});
  const Image image = first(scene), plain = first(without(scene));
  expectReflects(image, plain, 60, 45, kBackground);
  expectReflects(image, plain, 60, 43, kBackground);
}

class FarEye : public testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(Mirror, FarEye, testing::Values(1e2, 1e4));

TEST_P(FarEye, ReflectsTheBackgroundWhereNothingStands) {
  const double away = GetParam();
  const json scene = mirrorScene({{"camera",
                                   {{"position", {0, away, away}},
                                    {"target", {0, 0, 0}},
                                    {"fov", 0.01},
                                    {"near", away / 2},
                                    {"far", away * 2}}},
                                  {"ring", {{"count", 1}, {"radius", 0}, {"scale", 0.1}}},
                                  {"floor", {{"width", away / 10}, {"depth", away / 10}}}});
  const Image image = first(scene), plain = first(without(scene));
  for (const auto& [x, y] : {std::pair(60, 80), std::pair(20, 80), std::pair(100, 20)})
    expectReflects(image, plain, x, y, kBackground);
}

TEST(Mirror, FromAMillionUnitsAwayThereIsNothingToSee) {
  const json scene = mirrorScene(
      {{"camera",
        {{"position", {1e8, 1e8, 1e8}}, {"target", {0, 0, 0}}, {"near", 1e6}, {"far", 1e9}}}});
  const Image image = first(scene);
  std::size_t other = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (distance(image.pixel(x, y), kBackground) > 1.01f / 255) ++other;
  EXPECT_LE(other, 1u);
}

TEST(Mirror, WhatLiesBelowTheFloorIsNotReflected) {
  const json scene = mirrorScene({{"ring", {{"base", -2}, {"hop", 0}}}});
  json none = scene;
  none["ring"]["count"] = 0;
  // The floor hides the objects, and the reflection has nothing but the background.
  const Image image = first(scene), empty = first(none), plain = first(without(none));
  expectReflects(image, plain, 60, 70, kBackground);
  EXPECT_EQ(distance(image.pixel(60, 70), empty.pixel(60, 70)), 0);
  EXPECT_EQ(distance(image.pixel(45, 60), empty.pixel(45, 60)), 0);
  // Without clipping they rise above the surface.
  json open = scene;
  open["quality"]["mirror_clip"] = 0;
  EXPECT_GT(differing(first(open), image), 0.02);
}

TEST(Mirror, OfAnObjectHalfSunkNothingRisesAboveTheFloor) {
  // Looking straight ahead at a height of 1: floor at distance d lies 1 / d below the middle.
  json scene = mirrorScene(
      {{"camera", {{"position", {0, 1, 7}}, {"target", {0, 1, 0}}}},
       {"ring", {{"count", 1}, {"radius", 0}, {"base", -0.45}, {"hop", 0}, {"scale", 0.9}}}});
  const double fov = scene["camera"]["fov"];
  const auto highest = [&](const json& of) { // row of the mirrored box's uppermost pixel, 0 to 1
    const Drawn drawn = draw("floor", of, {0});
    const Image image = drawn.leftBy(drawn.writerOf("uReflection"));
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        if (distance(image.pixel(x, y), kBackground) > 3.0f / 255)
          return double(y) / image.height();
    return 1.0;
  };
  // The front edge at the floor is the highest that is left: the cut behind it is open.
  const double floorLine = 0.5 + 0.5 / (6.55 * std::tan(fov / 2));
  EXPECT_NEAR(highest(scene), floorLine, 0.004);
  scene["quality"]["mirror_clip"] = 0;
  EXPECT_LT(highest(scene), floorLine - 0.1);
}

TEST(Mirror, GlowThatNoByteHoldsIsReflectedInFull) {
  const json scene =
      mirrorScene({{"ring", {{"glow", 1e30}, {"count", 1}, {"radius", 0}, {"hop", 0}}},
                   {"camera", {{"position", {0, 3, 7}}, {"target", {0, 0, 0}}}}});
  const Drawn drawn = draw("floor", scene);
  const Image plain = first(without(scene));
  const Image reflection = drawn.leftBy(drawn.writerOf("uReflection"));
  const auto of = std::max_element(reflection.values().begin(), reflection.values().end());
  EXPECT_EQ(*of, 1);
  // Right in front of the box's foot.
  int y = 45;
  while (y < 91 && distance(plain.pixel(60, y), std::array<float, 3>{1, 1, 1}) == 0) ++y;
  const float white[] = {1, 1, 1};
  expectReflects(drawn.frames[0], plain, 60, y + 2, white);
}

TEST(Mirror, AFloorThatReflectsNothingAndOneOfAllLight) {
  json scene = mirrorScene({{"materials", {{"floor", {{"specular", {0, 0, 0}}}}}}});
  EXPECT_EQ(differing(first(scene), first(without(scene)), 0), 0);
  scene["materials"]["floor"]["specular"] = {65504, 65504, 65504};
  EXPECT_THAT(first(scene).pixel(60, 85), Each(1.0f));
}

TEST(Mirror, AFloorOfNoWidthIsNotThere) {
  const json scene =
      mirrorScene({{"floor", {{"width", 1e-5}, {"depth", 1e-5}}}, {"ring", {{"count", 0}}}});
  EXPECT_LE(differing(first(scene), first(without(scene))), 1.01 / (121 * 91));
}

} // namespace
