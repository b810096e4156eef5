// What a scene of the Cornell box may ask for at most: sizes, scales, times, planes, light; and
// ways to draw it that must make no difference.

#include "extremes_room.hpp"

#include <cmath>

using namespace shadow_volume_extremes;
using testing::Each;
using testing::HasSubstr;

namespace {

/// The lamp circles.
json circling(const json& patch = json::object()) {
  json scene = room({{"orbit", {{"radius", 1}, {"period", 20}}}});
  scene.merge_patch(patch);
  return scene;
}

Image first(const json& scene, double time = 0) {
  return draw("shadow_volume", scene, {time}).frames.at(0);
}

json with(json scene, const json& patch) {
  scene.merge_patch(patch);
  return scene;
}

TEST(ShadowVolume, TheUsualSceneIsRight) {
  json scene = circling();
  scene["light"] = sceneOf("shadow_volume", {}, json::object())["light"];
  const Counts counts = expectRight(scene, {0, 4.5, 11});
  EXPECT_GT(counts.lit, 15000u);
  EXPECT_GT(counts.dark, 1000u);
}

TEST(ShadowVolume, AFrameLeavesNothingBehind) {
  const Drawn drawn = draw("shadow_volume", circling(), {0.21, 0.21, 6, 0.21});
  EXPECT_EQ(differing(drawn.frames[0], drawn.frames[1], 0), 0);
  EXPECT_GT(differing(drawn.frames[0], drawn.frames[2], 0), 0.02);
  EXPECT_EQ(differing(drawn.frames[0], drawn.frames[3], 0), 0);
}

TEST(ShadowVolume, AMillionTurnsOfTheLampLaterThePictureIsTheSame) {
  const Drawn drawn = draw("shadow_volume", circling(), {3.5, 2e7 + 3.5, 12, 2e7 + 12});
  EXPECT_LE(differing(drawn.frames[0], drawn.frames[1]), 0.001);
  EXPECT_LE(differing(drawn.frames[2], drawn.frames[3]), 0.001);
  EXPECT_GT(differing(drawn.frames[0], drawn.frames[2]), 0.02);
}

TEST(ShadowVolume, TheShortestAndTheLongestTurn) {
  const Image usual = first(circling(), 4.2);
  for (const double period : {1e-3, 1e7})
    EXPECT_LE(differing(usual, first(circling({{"orbit", {{"period", period}}}}), 0.21 * period)),
              0.002)
        << period;
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
  times(scene["orbit"]["radius"]);
  times(scene["room"]["scale"]);
  return scene;
}

class Scale : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(ShadowVolume, Scale, testing::Values(1e-4, 1e6));

TEST_P(Scale, LooksTheSame) {
  for (const char* mesh : {"blocks", "torus_knot"}) {
    const json scene = circling({{"mesh", mesh}}), other = scaled(scene, GetParam());
    // A pixel at a shadow's edge may fall on its other side by rounding.
    EXPECT_LE(differing(first(scene, 3), first(other, 3)), 0.001) << mesh;
    EXPECT_GT(expectRight(other, {3}).dark, 300u) << mesh;
  }
}

TEST(ShadowVolume, NearAndFarPlanesAHundredMillionApart) {
  const json scene = circling();
  const json far = with(scene, {{"camera", {{"near", 1e-3}, {"far", 1e5}}}});
  EXPECT_LE(differing(first(scene), first(far)), 0.002);
  EXPECT_GT(expectRight(far, {0, 7}).dark, 500u);
}

TEST(ShadowVolume, AFarPlaneRightBehindTheRoomCutsNoVolumeOff) {
  // The back wall is 13.6 from the eye, and the volumes go on behind it.
  const json scene = circling({{"camera", {{"far", 13.6}}}});
  EXPECT_GT(expectRight(scene, {0, 7}).dark, 500u);
}

class Size : public testing::TestWithParam<std::pair<int, int>> {};
INSTANTIATE_TEST_SUITE_P(ShadowVolume, Size,
                         testing::Values(std::pair(1, 1), std::pair(1, 300), std::pair(300, 1),
                                         std::pair(7, 13), std::pair(127, 131),
                                         std::pair(641, 479)));

TEST_P(Size, IsRight) {
  const auto [width, height] = GetParam();
  // Narrow windows look from close by at the shadow beside the short block, then at the floor on
  // its other side.
  const bool isNarrow = width < 100 || height < 100;
  const auto towards = [&](double x) {
    json scene = room({{"size", {width, height}}});
    scene["light"]["position"] = {-2.4, 5.2, 1.5};
    if (isNarrow)
      scene["camera"].update(
          {{"position", {x, 0.15, 2}}, {"target", {x, 0, 2.0005}}, {"near", 0.01}, {"fov", 0.01}});
    return scene;
  };
  const std::size_t pixels = std::size_t(width) * std::size_t(height);
  if (isNarrow) {
    EXPECT_EQ(expectRight(towards(0.3)).dark, pixels);
    EXPECT_EQ(expectRight(towards(-2.3)).lit, pixels);
  } else {
    const Counts counts = expectRight(towards(0));
    EXPECT_GT(counts.dark, pixels / 30);
    EXPECT_GT(counts.lit, pixels / 4);
  }
}

TEST(ShadowVolume, NoCasterNoShadow) {
  const json scene = circling({{"mesh", "none"}});
  const Image lit = first(with(scene, {{"effects", {{"shadow", false}}}}));
  EXPECT_EQ(differing(first(scene), lit, 0), 0);
  EXPECT_EQ(differing(first(with(scene, {{"debug", {{"draw_all_passes", true}}}})), lit, 0), 0);
  const Counts counts = expectRight(scene);
  EXPECT_GT(counts.lit, 10000u);
  EXPECT_EQ(counts.dark, 0u);
}

TEST(ShadowVolume, BlackLight) {
  const json black = {0, 0, 0};
  json scene = circling({{"background", black},
                         {"light", {{"ambient", black}, {"diffuse", black}, {"specular", black}}}});
  for (const bool all : {false, true}) {
    scene["debug"]["draw_all_passes"] = all;
    const Image image = first(scene);
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        for (int c = 0; c < 3; ++c) ASSERT_EQ(image.at(x, y, c), 0) << x << ' ' << y;
  }
}

TEST(ShadowVolume, TheBrightestLight) {
  const json white = {65504, 65504, 65504};
  json scene = circling({{"background", white},
                         {"light", {{"ambient", white}, {"diffuse", white}, {"specular", white}}}});
  for (const char* material : {"wall", "caster"})
    scene["materials"][material].update(
        {{"ambient", white}, {"diffuse", white}, {"specular", white}});
  EXPECT_THAT(first(scene).values(), Each(1.0f));
  // Without ambient light its shadows are black.
  scene["light"]["ambient"] = {0, 0, 0};
  const Counts counts = expectRight(scene);
  EXPECT_GT(counts.lit, 5000u);
  EXPECT_GT(counts.dark, 200u);
}

// Ways that must make no difference, not in a single bit.

class Ways : public testing::TestWithParam<json> {};
INSTANTIATE_TEST_SUITE_P(ShadowVolume, Ways,
                         testing::Values(json{{"edges", 1}}, json{{"passes", 2}},
                                         json{{"edges", 1}, {"passes", 2}}, json{{"method", 0}},
                                         json{{"method", 0}, {"edges", 1}},
                                         json{{"method", 0}, {"passes", 2}}),
                         nameOfQuality);

TEST_P(Ways, DrawTheSamePicture) {
  for (const char* mesh : {"blocks", "torus_knot", "plane"}) {
    json scene = circling({{"mesh", mesh}, {"size", {160, 120}}});
    if (scene["mesh"] != "blocks") scene["caster"]["lift"] = 0.6;
    const std::vector<double> times = {0, 5, 5.1, 13};
    const auto says = testing::AnyOf("", HasSubstr("get a back")); // the plane
    const Drawn usual = draw("shadow_volume", scene, times, {}, says);
    const Drawn other =
        draw("shadow_volume", with(scene, {{"quality", GetParam()}}), times, {}, says);
    for (std::size_t i = 0; i < times.size(); ++i)
      EXPECT_EQ(differing(usual.frames[i], other.frames[i], 0), 0) << mesh << " at " << times[i];
  }
}

TEST(Refused, ARoomWithoutSize) {
  for (const json& scale : {json(0), json(-1), json(1e8), json(std::nan(""))})
    EXPECT_THAT(refusal("shadow_volume", room({{"room", {{"scale", scale}}}})),
                HasSubstr("room.scale: must be"));
}

TEST(Refused, AMeshThatIsNotThere) {
  EXPECT_THAT(refusal("shadow_volume", room({{"mesh", "teapot.obj"}})),
              HasSubstr("mesh \"teapot.obj\": not torus_knot, box or plane, and no OBJ file"));
}

} // namespace
