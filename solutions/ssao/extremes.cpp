// Ambient occlusion at its ends: windows of one pixel, radii of nothing and of everything, a ground
// seen at a low angle, no ground at all.

#include "drawn.hpp"

#include <gmock/gmock.h>

#include <cmath>

using namespace extremes;
using testing::Each;
using testing::HasSubstr;

namespace {

/// A small window, both methods.
class Ssao : public testing::TestWithParam<int> {
protected:
  json scene(const json& patch = json::object()) const {
    json all = {{"size", {120, 90}}, {"quality", {{"method", GetParam()}}}};
    all.merge_patch(patch);
    return sceneOf("ssao", {"ssao"}, all);
  }
  /// The occlusion alone.
  json openScene(json patch = json::object()) const {
    patch["debug"]["picture"] = 3;
    return scene(patch);
  }
  Image first(const json& scene) const { return draw("ssao", scene).frames.at(0); }
};

INSTANTIATE_TEST_SUITE_P(Methods, Ssao, testing::Values(0, 1), [](const auto& info) {
  return std::string(info.param == 0 ? "Points" : "Horizons");
});

float darkest(const Image& image) {
  float least = 1;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) least = std::min(least, image.at(x, y, 0));
  return least;
}

TEST_P(Ssao, ASecondFrameOfTheSameTimeIsTheSame) {
  const Drawn drawn = draw("ssao", scene(), {0.5, 0.5, 9, 24.5});
  EXPECT_EQ(differing(drawn.frames[0], drawn.frames[1], 0), 0);
  EXPECT_GT(differing(drawn.frames[0], drawn.frames[2]), 0.05);
  EXPECT_LE(differing(drawn.frames[0], drawn.frames[3]), 0.002) << "a whole turn later";
}

TEST_P(Ssao, AnySize) {
  for (const auto& [width, height] :
       {std::pair{1, 1}, std::pair{1, 300}, std::pair{300, 1}, std::pair{7, 13}})
    for (const int resolution : {1, 2}) {
      const Drawn drawn = draw(
          "ssao", scene({{"size", {width, height}}, {"quality", {{"resolution", resolution}}}}));
      EXPECT_EQ(drawn.frames[0].width(), width);
      EXPECT_EQ(drawn.frames[0].height(), height);
    }
}

TEST_P(Ssao, APixelAloneIsOpen) {
  EXPECT_EQ(darkest(first(openScene({{"size", {1, 1}}}))), 1);
}

TEST_P(Ssao, WhatLiesOutsideTheWindowIsTakenForOpen) {
  // The same pixels, with as many more around them.
  const double fov = sceneOf("ssao", {"ssao"}, json::object())["camera"]["fov"];
  const json sharp = {{"blur", 0}};
  const Image all = first(openScene({{"size", {240, 176}}, {"quality", sharp}}));
  const Image part =
      first(openScene({{"size", {120, 88}},
                       {"quality", sharp},
                       {"camera", {{"fov", 2 * std::atan(std::tan(fov / 2) / 2)}}}}));
  int lighter = 0, darker = 0, inside = 0;
  for (int y = 0; y < part.height(); ++y)
    for (int x = 0; x < part.width(); ++x) {
      const float change = part.at(x, y, 0) - all.at(x + 60, y + 44, 0);
      lighter += change > 1.01f / 255, darker += change < -1.01f / 255;
      const bool middle = std::abs(x - 60) < 20 && std::abs(y - 44) < 14;
      inside += middle && std::abs(change) > 1.01f / 255;
    }
  EXPECT_GT(lighter, 100) << "no sample ever lay outside";
  EXPECT_LT(darker, 20) << "but for what rounding moves to the next pixel";
  EXPECT_LT(inside, 20);
}

TEST_P(Ssao, WhereThereIsNothingItIsOpen) {
  // Up into the sky, and the ground's edge against it.
  EXPECT_EQ(darkest(first(openScene({{"camera", {{"target", {2.7, 5, 3}}}}}))), 1);
  const Image horizon =
      first(openScene({{"camera", {{"position", {5, 0.3, 4}}, {"target", {9, 0.3, 5}}}}}));
  EXPECT_GT(darkest(horizon), 0.98f);
}

TEST_P(Ssao, AFlatGroundIsOpenAtEveryAngle) {
  for (const double height : {0.02, 0.2, 1.0, 5.0})
    for (const double radius : {0.05, 0.5, 5.0}) {
      const json look = {
          {"camera", {{"position", {5, height, 5}}, {"target", {15, height - 1, 15}}}},
          {"ground", {{"size", 1000}}},
          {"ao", {{"radius", radius}}}};
      EXPECT_GT(darkest(first(openScene(look))), 0.98f) << height << " " << radius;
    }
}

TEST_P(Ssao, ARadiusOfNothingOrBelowAPixelHidesNothing) {
  for (const double radius : {0.0, 1e-30, 1e-6, 1e-3})
    EXPECT_GT(darkest(first(openScene({{"ao", {{"radius", radius}}}}))), 0.98f) << radius;
}

TEST_P(Ssao, AHugeRadius) {
  // What isn't a number would be stored as 0.
  for (const double radius : {100.0, 1e7})
    EXPECT_GT(darkest(first(openScene({{"ao", {{"radius", radius}}}}))), 0) << radius;
}

TEST_P(Ssao, NearAndFarPlanesTenMillionApart) {
  const Image usual = first(openScene()),
              apart = first(openScene({{"camera", {{"near", 1e-3}, {"far", 1e4}}}}));
  EXPECT_LE(differing(usual, apart, 6.01f / 255), 0.02);
}

TEST_P(Ssao, TheFewestAndTheMostSamples) {
  for (const int samples : {1, 2, 3, 1024})
    for (const int blur : {0, 1, 16}) {
      const Image image = first(
          openScene({{"size", {48, 36}}, {"quality", {{"samples", samples}, {"blur", blur}}}}));
      EXPECT_LT(darkest(image), samples == 1024 ? 0.8f : 0.95f) << samples << " " << blur;
      if (samples == 1024) {
        EXPECT_GT(darkest(image), 0.1f) << blur;
      }
    }
}

TEST_P(Ssao, WhatIsLeftOutWouldChangeNothing) {
  for (json patch : {json{{"light", {{"ambient", {0, 0, 0}}}}}, json{{"ao", {{"radius", 0}}}},
                     json{{"ao", {{"radius", 0.5}}}}}) {
    const Drawn less = draw("ssao", scene(patch));
    patch["debug"]["draw_all_passes"] = true;
    const Drawn all = draw("ssao", scene(patch));
    EXPECT_EQ(differing(less.frames[0], all.frames[0], 0), 0);
    const bool needed = patch["ao"].is_object() && patch["ao"]["radius"] == 0.5;
    EXPECT_EQ(less.trace.passesOf(0).size(), needed ? 5u : 2u);
    EXPECT_EQ(all.trace.passesOf(0).size(), 5u);
  }
}

TEST_P(Ssao, LightThatNoHalfFloatHolds) {
  const json white = {65504, 65504, 65504};
  const json all = {{"ambient", white}, {"diffuse", white}, {"specular", white}};
  draw("ssao", scene({{"background", white},
                      {"light", all},
                      {"materials", {{"object", all}, {"ground", all}}}}));
}

TEST(SsaoRefused, SamplesOutOfRange) {
  EXPECT_THAT(refusal("ssao", sceneOf("ssao", {"ssao"}, {{"quality", {{"samples", 0}}}})),
              HasSubstr("quality.samples: must be"));
}

} // namespace
