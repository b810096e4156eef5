// Shadows at their ends: lights at odd places, maps of one texel, floor that the map doesn't show.

#include "drawn.hpp"

#include <gmock/gmock.h>

#include <cmath>

using namespace extremes;

namespace {

/// Looks straight down from high above: a pixel is 0.015 units, x to the right, z downwards.
constexpr int kSide = 201;
constexpr double kUnit = 0.015;

json fromAbove(const json& patch) {
  json all = {{"size", {kSide, kSide}},
              {"mesh", "box"},
              {"camera",
               {{"position", {0, 30, 0}},
                {"target", {0, 0, 0}},
                {"up", {0, 0, -1}},
                {"fov", 2 * std::atan(kSide * kUnit / 2 / 30)},
                {"near", 1},
                {"far", 60}}},
              {"ring", {{"count", 1}, {"radius", 0}, {"base", 1}, {"hop", 0}, {"scale", 0.9}}},
              {"floor", {{"width", 14}, {"depth", 14}, {"tiles_per_unit", 0}}}};
  all.merge_patch(patch);
  return sceneOf("floor", {"shadow"}, all);
}

/// At the time at which the first box of a ring lies along the axes.
Image first(const json& scene) {
  return draw("floor", scene, {0}).frames.at(0);
}

json unshadowed(json scene) {
  scene["effects"]["shadow"] = false;
  return scene;
}

/// Is the floor at (x, z) of a picture from above in shadow? Nothing but ambient light then: 0.25
/// times the floor's 0.3 times the tile's 0.9, 17 of 255. The lit floor has at least 40.
bool dark(const Image& image, double x, double z) {
  const auto pixel = [](double at) { return int(std::lround(at / kUnit)) + kSide / 2; };
  return std::abs(image.at(pixel(x), pixel(z), 0) * 255 - 17) < 1.5;
}

// The box is 0.9 wide and stands from 1.0 to 1.9 above the floor. Seen from the eye at 30 it hides
// the floor up to 0.48 from the middle; light at height h over it shades up to 0.45 h / (h - 1.9).

class Depth : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Shadow, Depth, testing::Values(16, 24, 32));

TEST_P(Depth, LightExactlyAboveShadesASquare) {
  const Image image = first(fromAbove(
      {{"light", {{"position", {0, 5, 0}}}}, {"quality", {{"shadow_bits", GetParam()}}}}));
  for (const auto& [x, z] :
       {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
    EXPECT_TRUE(dark(image, 0.69 * x, 0.69 * z)) << x << ' ' << z;
    EXPECT_FALSE(dark(image, 0.76 * x, 0.76 * z)) << x << ' ' << z;
  }
  EXPECT_TRUE(dark(image, 0.69, 0.69));
  EXPECT_TRUE(dark(image, -0.69, 0.69));
}

TEST_P(Depth, FloorBeyondTheFarPlaneIsLitWhereNothingIsInTheWay) {
  // Four boxes high up, close under the light: their own box ends at 3.0, the floor is 6 below.
  const json scene =
      fromAbove({{"light", {{"position", {0, 6, 0}}}},
                 {"quality", {{"shadow_bits", GetParam()}}},
                 {"camera", {{"fov", 0.4}}},
                 {"ring", {{"count", 4}, {"radius", 1.2}, {"base", 3}, {"scale", 0.5}}}});
  const Image image = first(scene), lit = first(unshadowed(scene));
  EXPECT_LE(distance(image.pixel(kSide / 2, kSide / 2), lit.pixel(kSide / 2, kSide / 2)),
            1.01f / 255);
  const double shadow = differing(image, lit, 5.0f / 255);
  EXPECT_GT(shadow, 0.008);
  EXPECT_LT(shadow, 0.25);
}

TEST_P(Depth, FloorBehindALowLightIsLit) {
  // All of the picture lies on the other side of the light.
  json scene = fromAbove({{"camera", {{"position", {4.5, 30, 0}}, {"target", {4.5, 0, 0}}}},
                          {"light", {{"position", {2.5, 0.4, 0}}}},
                          {"quality", {{"shadow_bits", GetParam()}}},
                          {"ring", {{"base", 0}}}});
  EXPECT_EQ(differing(first(scene), first(unshadowed(scene))), 0);
  // And the shadow is on this one.
  scene["camera"]["position"] = {-1, 30, 0};
  scene["camera"]["target"] = {-1, 0, 0};
  EXPECT_GT(differing(first(scene), first(unshadowed(scene))), 0.05);
}

TEST_P(Depth, ALightBehindTheEye) {
  const Image image = first(fromAbove(
      {{"light", {{"position", {5, 40, 0}}}}, {"quality", {{"shadow_bits", GetParam()}}}}));
  // The box's upper left edge shades up to 5 - 5.45 * 40 / 38.1 = -0.72.
  EXPECT_TRUE(dark(image, -0.66, 0));
  EXPECT_FALSE(dark(image, -0.78, 0));
  EXPECT_FALSE(dark(image, 0.6, 0));
  EXPECT_FALSE(dark(image, 0, 0.6));
}

TEST_P(Depth, LightThatGrazesASurfaceLightsIt) {
  // A fiftieth above the plane of the box's top and 3 beside it, bright enough to show there.
  const json scene = fromAbove({{"light", {{"position", {3, 1.92, 0}}, {"diffuse", {60, 60, 60}}}},
                                {"quality", {{"shadow_bits", GetParam()}}}});
  for (int bias : {2, 3}) {
    json with = scene;
    with["quality"]["shadow_bias"] = bias;
    const Image image = first(with), lit = first(unshadowed(with));
    int shaded = 0, shown = 0;
    for (int y = kSide / 2 - 25; y <= kSide / 2 + 25; ++y)
      for (int x = kSide / 2 - 25; x <= kSide / 2 + 25; ++x) {
        shown += lit.at(x, y, 0) > 0.25;
        shaded += distance(image.pixel(x, y), lit.pixel(x, y)) > 5.0f / 255;
      }
    EXPECT_EQ(shown, 51 * 51) << bias;
    EXPECT_LE(shaded, 51) << bias << ": one row, at the edge";
  }
}

class Sun : public testing::TestWithParam<std::tuple<int, double>> {};

INSTANTIATE_TEST_SUITE_P(Shadow, Sun,
                         testing::Combine(testing::Values(16, 24, 32), testing::Values(7e3, 7e4)));

TEST_P(Sun, ThrowsParallelShadows) {
  const auto& [bits, away] = GetParam();
  const Image image = first(fromAbove({{"light", {{"position", {away, away, 0}}}},
                                       {"quality", {{"shadow_bits", bits}}},
                                       {"ring", {{"base", 0.1}}}}));
  // At 45 degrees: the upper edge, 1.0 high, shades up to -0.45 - 1.0.
  EXPECT_TRUE(dark(image, -1.3, 0));
  EXPECT_FALSE(dark(image, -1.48, 0));
  EXPECT_FALSE(dark(image, 0.6, 0));
  EXPECT_FALSE(dark(image, -1, 0.6));
}

TEST_P(Depth, ANearPlaneCloseToTheLight) {
  // A light just over one of the boxes' own box: near and far lie a thousand times apart.
  const json scene =
      fromAbove({{"light", {{"position", {0.6, 1.2, 0.6}}}},
                 {"camera", {{"fov", 0.3}}},
                 {"quality", {{"shadow_bits", GetParam()}}},
                 {"ring", {{"count", 4}, {"radius", 1.5}, {"scale", 0.5}, {"base", 0}}}});
  json floats = scene;
  floats["quality"]["shadow_bits"] = 32;
  const Image image = first(scene);
  EXPECT_LE(differing(image, first(floats), 5.0f / 255), GetParam() == 16 ? 0.02 : 0.005);
  EXPECT_GT(differing(image, first(unshadowed(scene)), 5.0f / 255), 0.01);
}

TEST(Shadow, ALightAtTheHorizonReachesNoFloor) {
  const json scene = fromAbove({{"light", {{"position", {5, 0, 0}}}}});
  const Image image = first(scene);
  EXPECT_TRUE(dark(image, 1.2, 0));
  EXPECT_TRUE(dark(image, -1.2, 0));
  EXPECT_TRUE(dark(image, 0, 1.2));
}

TEST(Shadow, ALightBelowTheFloorReachesNoFloor) {
  const Image image = first(fromAbove({{"light", {{"position", {0, -3, 0}}}}}));
  EXPECT_TRUE(dark(image, 1.2, 0));
  EXPECT_TRUE(dark(image, -0.6, 0));
  // Nor the top of the box: nothing but ambient light, 0.25 * 0.9 * (0.8, 0.4, 0.4).
  EXPECT_NEAR(image.at(kSide / 2, kSide / 2, 0) * 255, 0.25 * 0.9 * 0.8 * 255, 1.5);
  EXPECT_NEAR(image.at(kSide / 2, kSide / 2, 1) * 255, 0.25 * 0.9 * 0.4 * 255, 1.5);
}

TEST(Shadow, ALightInsideAnObjectLightsNoneOfItsOutside) {
  const json scene = fromAbove({{"light", {{"position", {0.1, 1.4, -0.1}}}}});
  for (int bits : {16, 24, 32}) {
    json with = scene;
    with["quality"]["shadow_bits"] = bits;
    const Image image = first(with);
    EXPECT_NEAR(image.at(kSide / 2, kSide / 2, 0) * 255, 0.25 * 0.9 * 0.8 * 255, 1.5) << bits;
    EXPECT_NEAR(image.at(kSide / 2, kSide / 2, 1) * 255, 0.25 * 0.9 * 0.4 * 255, 1.5) << bits;
  }
}

/// Six boxes round a light right in their middle.
json lightInTheMiddle(double offset) {
  return fromAbove({{"light", {{"position", {offset, 0.45, offset}}}},
                    {"camera", {{"fov", 0.3}}},
                    {"ring", {{"count", 6}, {"radius", 1.7}, {"base", 0}}}});
}

TEST(Shadow, ALightInTheMiddleOfTheObjectsLightsTheFloorBetweenThem) {
  const json scene = lightInTheMiddle(0);
  const Image image = first(scene), lit = first(unshadowed(scene));
  EXPECT_LE(distance(image.pixel(kSide / 2, kSide / 2), lit.pixel(kSide / 2, kSide / 2)),
            1.01f / 255);
  EXPECT_GT(image.at(kSide / 2, kSide / 2, 0), 0.3);
  EXPECT_GT(differing(image, lit, 5.0f / 255), 0.02) << "the objects throw shadows";
}

class NearTheMiddle : public testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(Shadow, NearTheMiddle, testing::Values(1e-6, 1e-18, 1e-22, 1e-25, 1e-37));

TEST_P(NearTheMiddle, ALightNextToTheMiddleOfTheObjectsMakesThePictureOfOneInIt) {
  // The direction from the light to the middle is one of numbers whose squares are no floats.
  EXPECT_LE(differing(first(lightInTheMiddle(GetParam())), first(lightInTheMiddle(0)), 5.0f / 255),
            0.01);
}

TEST(Shadow, NoObjectsNoShadow) {
  json scene = fromAbove({{"ring", {{"count", 0}}}});
  const Image lit = first(unshadowed(scene));
  EXPECT_EQ(differing(first(scene), lit, 0), 0);
  scene["debug"]["draw_all_passes"] = true;
  EXPECT_EQ(differing(first(scene), lit, 0), 0);
}

TEST(Shadow, ALightAtACornerOfAnObject) {
  // It stands in the planes of three faces: two axes of floor are lit, and what lies between them.
  const json scene = fromAbove({{"light", {{"position", {0.45, 1.9, 0.45}}}}});
  const Image image = first(scene), lit = first(unshadowed(scene));
  EXPECT_GT(image.at(160, 160, 0), 0.15);
  EXPECT_LE(distance(image.pixel(160, 160), lit.pixel(160, 160)), 1.01f / 255);
}

class Height : public testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(Shadow, Height, testing::Values(2.1, 2.3, 2.7, 3.0, 3.3, 4.1, 5.9, 7.7));

TEST_P(Height, WhatTouchesTheNearPlaneShadesTheFloor) {
  // The top of the box is the top of all objects' box, too, and so lies in the light's near plane.
  const double height = GetParam();
  for (double tilt : {0.0, 0.05}) {
    const Image image = first(fromAbove(
        {{"light", {{"position", {tilt, height, 0}}}}, {"floor", {{"width", 40}, {"depth", 40}}}}));
    const double reach = 0.45 * height / (height - 1.9);
    EXPECT_TRUE(dark(image, 0, std::min(reach - 0.04, 1.4))) << tilt;
    EXPECT_TRUE(dark(image, 0, -std::min(reach - 0.04, 1.4))) << tilt;
  }
}

class Bias : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Shadow, Bias, testing::Values(0, 1, 2, 3));

TEST_P(Bias, AMapOfOneTexelLeavesFloorBehindTheLightLit) {
  const json scene =
      fromAbove({{"camera", {{"position", {4.5, 30, 0}}, {"target", {4.5, 0, 0}}}},
                 {"light", {{"position", {2.5, 0.4, 0}}}},
                 {"quality", {{"shadow_size", 1}, {"shadow_bias", GetParam()}, {"pcf_radius", 2}}},
                 {"ring", {{"base", 0}}}});
  EXPECT_EQ(differing(first(scene), first(unshadowed(scene))), 0);
}

TEST_P(Bias, AMapOfOneTexelLeavesFloorBesideTheMapLit) {
  json scene = fromAbove({{"camera", {{"fov", 0.4}}},
                          {"light", {{"position", {0, 3, 0}}}},
                          {"quality", {{"shadow_size", 1}, {"shadow_bias", GetParam()}}}});
  const Image image = first(scene), lit = first(unshadowed(scene));
  // The map shows 0.64 / 1.1 to each side of a light that is 3 above the floor: 1.75 units.
  for (int x : {2, kSide / 2, kSide - 3})
    EXPECT_LE(distance(image.pixel(x, 2), lit.pixel(x, 2)), 1.01f / 255) << x;
}

TEST_P(Bias, ManySamplesOfAMapOfOneTexel) {
  const json scene = fromAbove(
      {{"light", {{"position", {0, 5, 0}}}},
       {"quality", {{"shadow_size", 1}, {"shadow_bias", GetParam()}, {"pcf_radius", 8}}}});
  json one = scene;
  one["quality"]["pcf_radius"] = 0;
  // All of them are the same texel. (The bias along the normal grows with the samples.)
  const double other = differing(first(scene), first(one));
  EXPECT_LE(other, GetParam() == 3 ? 1 : 0);
}

TEST_P(Bias, ATinyAndAHugeShadow) {
  json scene =
      fromAbove({{"light", {{"position", {0, 5, 0}}}}, {"quality", {{"shadow_bias", GetParam()}}}});
  const Image usual = first(scene);
  // Without a bias, chance decides which point of a surface shades itself.
  const double most = GetParam() == 0 ? 0.2 : 0.005;
  for (double scale : {1e-4, 1e6}) {
    json other = scene;
    for (json* value : {&other["camera"]["position"], &other["light"]["position"]})
      for (json& component : *value) component = component.get<double>() * scale;
    for (json* value :
         {&other["camera"]["near"], &other["camera"]["far"], &other["ring"]["base"],
          &other["ring"]["scale"], &other["floor"]["width"], &other["floor"]["depth"]})
      *value = value->get<double>() * scale;
    EXPECT_LE(differing(usual, first(other)), most) << scale;
  }
}

} // namespace
