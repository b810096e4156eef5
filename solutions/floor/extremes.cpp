// What a scene of any part may ask for at most: sizes, scales, times, numbers of objects, light.

#include "drawn.hpp"

#include <gmock/gmock.h>

#include <cmath>

using namespace extremes;
using testing::AllOf;
using testing::Each;
using testing::Ge;
using testing::HasSubstr;
using testing::Le;

namespace {

using Parts = std::vector<std::string>;

/// A mesh of twelve triangles in a small window, unless the patch says otherwise.
json small(const Parts& parts, const json& patch = {}) {
  json all = {{"size", {120, 90}}, {"mesh", "box"}};
  if (!patch.is_null()) all.merge_patch(patch);
  return sceneOf("floor", parts, all);
}

std::string nameOf(const Parts& parts) {
  return parts.empty() ? "all" : parts.front();
}

/// Each part alone, and all of them together.
const Parts kAll[] = {{"mirror"}, {"shadow"}, {"bloom"}, {}};

class EveryPart : public testing::TestWithParam<Parts> {
protected:
  Image first(const json& patch, double time = 0.21) const {
    return draw("floor", small(GetParam(), patch), {time}).frames.at(0);
  }
};

INSTANTIATE_TEST_SUITE_P(Floor, EveryPart, testing::ValuesIn(kAll),
                         [](const auto& info) { return nameOf(info.param); });

TEST_P(EveryPart, ASecondFrameOfTheSameTimeIsTheSame) {
  const Drawn drawn = draw("floor", small(GetParam()), {0.21, 0.21, 2.9, 0.21});
  EXPECT_EQ(differing(drawn.frames[0], drawn.frames[1], 0), 0);
  EXPECT_GT(differing(drawn.frames[0], drawn.frames[2], 0), 0.02);
  EXPECT_EQ(differing(drawn.frames[0], drawn.frames[3], 0), 0);
}

TEST_P(EveryPart, AMillionCyclesLaterThePictureIsTheSame) {
  const Drawn drawn = draw("floor", small(GetParam()), {0.21, 1e7 + 0.21, 4.5, 1e7 + 4.5});
  EXPECT_EQ(differing(drawn.frames[0], drawn.frames[1]), 0);
  EXPECT_EQ(differing(drawn.frames[2], drawn.frames[3]), 0);
  EXPECT_GT(differing(drawn.frames[0], drawn.frames[2]), 0.02);
}

TEST_P(EveryPart, TheShortestAndTheLongestCycle) {
  // The same phase, 0.21 of a cycle.
  const Image usual = first({}, 2.1);
  EXPECT_LE(differing(usual, first({{"ring", {{"cycle", 1e-3}}}}, 0.21e-3)), 0.001);
  EXPECT_LE(differing(usual, first({{"ring", {{"cycle", 1e7}}}}, 2.1e6)), 0.001);
}

/// All lengths of the scene times `scale`.
json scaled(json scene, double scale) {
  const auto times = [&](json& value) {
    if (value.is_array())
      for (json& component : value) component = component.get<double>() * scale;
    else
      value = value.get<double>() * scale;
  };
  for (const char* key : {"position", "target", "near", "far"}) times(scene["camera"][key]);
  times(scene["light"]["position"]);
  for (const char* key : {"radius", "hop", "base", "scale"}) times(scene["ring"][key]);
  for (const char* key : {"width", "depth"}) times(scene["floor"][key]);
  scene["floor"]["tiles_per_unit"] = scene["floor"]["tiles_per_unit"].get<double>() / scale;
  return scene;
}

TEST_P(EveryPart, ATinyWorldLooksTheSame) {
  const json scene = small(GetParam());
  const Image usual = draw("floor", scene).frames[0];
  EXPECT_LE(differing(usual, draw("floor", scaled(scene, 1e-4)).frames[0]), 0.002);
}

TEST_P(EveryPart, AHugeWorldLooksTheSame) {
  const json scene = small(GetParam());
  const Image usual = draw("floor", scene).frames[0];
  EXPECT_LE(differing(usual, draw("floor", scaled(scene, 1e6)).frames[0]), 0.005);
}

TEST_P(EveryPart, NearAndFarPlanesTenMillionApart) {
  EXPECT_LE(differing(first({}), first({{"camera", {{"near", 1e-3}, {"far", 1e4}}}})), 0.002);
}

TEST_P(EveryPart, NoObjects) {
  const Image none = first({{"ring", {{"count", 0}}}});
  // The passes that are left out would show nothing.
  EXPECT_EQ(
      differing(none, first({{"ring", {{"count", 0}}}, {"debug", {{"draw_all_passes", true}}}}), 0),
      0);
  EXPECT_EQ(differing(none, first({{"ring", {{"count", 0}}}}, 3.3), 0), 0) << "nothing moves";
}

TEST_P(EveryPart, TenThousandObjects) {
  // Colours and glow repeat after eight objects: turned so far the ring is itself again.
  const json scene =
      small(GetParam(), {{"size", {48, 36}},
                         {"quality", {{"mirror_size", 64}, {"shadow_size", 64}}},
                         {"ring", {{"count", 10000}, {"hop", 0}, {"scale", 0.4}, {"glow", 0.01}}}});
  const Drawn drawn = draw("floor", scene, {0, 0.004});
  EXPECT_LE(differing(drawn.frames[0], drawn.frames[1], 3.01f / 255), 0.05);
  json without = scene;
  without["ring"]["count"] = 0;
  EXPECT_GT(differing(drawn.frames[0], draw("floor", without).frames[0]), 0.1);
}

TEST_P(EveryPart, TheBrightestLight) {
  const json white = {65504, 65504, 65504};
  const json all = {{"ambient", white}, {"diffuse", white}, {"specular", white}};
  const Image image = first(
      {{"background", white}, {"light", all}, {"materials", {{"object", all}, {"floor", all}}}});
  EXPECT_THAT(image.values(), Each(1.0f));
}

TEST_P(EveryPart, BlackLight) {
  const json black = {0, 0, 0};
  json patch = {{"background", black},
                {"light", {{"ambient", black}, {"diffuse", black}, {"specular", black}}},
                {"ring", {{"glow", 0}}}};
  for (bool all : {false, true}) {
    patch["debug"]["draw_all_passes"] = all;
    const Image image = first(patch);
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        for (int c = 0; c < 3; ++c) ASSERT_EQ(image.at(x, y, c), 0) << x << ' ' << y;
  }
}

TEST_P(EveryPart, AFloorThatReachesTheHorizon) {
  // Where the usual floor is, nothing changes; beyond it there is floor now.
  const json plain = {{"materials", {{"floor", {{"specular", {0, 0, 0}}}}}}};
  json wide = plain;
  wide["floor"] = {{"width", 1e4}, {"depth", 1e4}};
  const Image usual = first(plain), image = first(wide);
  EXPECT_LE(distance(usual.pixel(60, 70), image.pixel(60, 70)), 1.01f / 255);
  EXPECT_GT(distance(usual.pixel(2, 40), image.pixel(2, 40)), 10.0f / 255);
}

/// The middle of a window with an odd number of pixels looks at the camera's target, whatever the
/// window's size. Here that is floor, next to nothing, with a smooth reflection.
struct Size {
  int width, height;
};
void PrintTo(const Size& size, std::ostream* out) {
  *out << size.width << 'x' << size.height;
}

class EverySize : public testing::TestWithParam<std::tuple<Size, Parts>> {};

INSTANTIATE_TEST_SUITE_P(
    Floor, EverySize,
    testing::Combine(testing::Values(Size{1, 1}, Size{1, 1080}, Size{1080, 1}, Size{7, 13},
                                     Size{641, 479}, Size{1920, 2}, Size{2, 1920}),
                     testing::Values(Parts{"mirror"}, Parts{"shadow"}, Parts{})),
    [](const auto& info) {
      const Size size = std::get<0>(info.param);
      return nameOf(std::get<1>(info.param)) + std::to_string(size.width) + 'x' +
             std::to_string(size.height);
    });

TEST_P(EverySize, TheMiddleShowsWhatTheCameraLooksAt) {
  const auto& [size, parts] = GetParam();
  // One tile in the shadow of a box as wide as the view, lit by nothing but the ambient light.
  json patch = {{"size", {size.width, size.height}},
                {"camera", {{"position", {0, 4, 6}}, {"target", {0, 0, 0}}, {"fov", 0.02}}},
                {"light", {{"position", {0, 9, 0}}}},
                {"ring", {{"count", 1}, {"radius", 0}, {"base", 5}, {"hop", 0}, {"glow", 0}}},
                {"floor", {{"tiles_per_unit", 0}}}};
  const Drawn drawn = draw("floor", small(parts, patch));
  ASSERT_EQ(drawn.frames[0].width(), size.width);
  ASSERT_EQ(drawn.frames[0].height(), size.height);
  patch["size"] = {9, 9};
  const Image usual = draw("floor", small(parts, patch)).frames[0];
  EXPECT_LE(distance(drawn.frames[0].pixel(size.width / 2, size.height / 2), usual.pixel(4, 4)),
            2.01f / 255);
  patch["effects"] = {{"mirror", false}, {"shadow", false}, {"bloom", false}};
  const Image plain = draw("floor", small(parts, patch)).frames[0];
  EXPECT_GT(distance(usual.pixel(4, 4), plain.pixel(4, 4)), 5.0f / 255) << "the part shows";
}

TEST(Refused, LightThatNoFloatHolds) {
  for (const json& glow : {json(1e39), json(std::nan("")), json(-1)})
    EXPECT_THAT(refusal("floor", small({"bloom"}, {{"ring", {{"glow", glow}}}})),
                HasSubstr("ring.glow: must be a number between 0 and"));
}

TEST(Refused, NegativeLight) {
  EXPECT_THAT(refusal("floor", small({}, {{"light", {{"diffuse", {1, -1, 1}}}}})),
              HasSubstr("light.diffuse: must be"));
}

TEST(Refused, MoreThanTenThousandObjects) {
  EXPECT_THAT(refusal("floor", small({}, {{"ring", {{"count", 10001}}}})),
              HasSubstr("ring.count: must be"));
}

} // namespace
