// Both parts at the ends of what a scene may ask for, and against what can be worked out by hand.

#include "sky.hpp"

#include "drawn.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <fstream>
#include <numbers>

using namespace extremes;
using ggrade::trace::Trace;
using testing::AllOf;
using testing::Each;
using testing::Ge;
using testing::Le;

namespace {

/// A small window and small maps, unless the patch says otherwise.
json small(const std::string& part, const json& patch = {}) {
  json all = {{"size", {96, 72}},
              {"quality", {{"environment_height", 64}, {"irradiance_height", 16}}}};
  if (!patch.is_null()) all.merge_patch(patch);
  return sceneOf("deferred", {part}, all);
}

Image first(const std::string& part, const json& patch = {}) {
  return draw("deferred", small(part, patch)).frames.at(0);
}

const json kBlack = {0, 0, 0};
const json kWhite = {65504, 65504, 65504};

/// The number of textures that passes of the first frame draw into.
std::size_t drawnTextures(const Trace& trace) {
  std::size_t count = 0;
  for (const auto& pass : trace.passesOf(0))
    for (const auto& image : pass.images)
      count += image.kind == std::uint32_t(ggrade::trace::ImageKind::texture);
  return count;
}

/// A scene, the number of textures that its passes draw into, and how many bytes those and their
/// renderbuffers take for each pixel of the window, a depth of 24 bits 3. The handout has the same
/// table.
struct Spared {
  const char* name;
  const char* part;
  json patch;
  std::size_t textures;
  double bytes;
};

void PrintTo(const Spared& spared, std::ostream* out) {
  *out << spared.name;
}

class SparedTextures : public testing::TestWithParam<Spared> {};

const json kNoMirror = {{"gloss", {{"specular", kBlack}}}, {"metal", {{"specular", kBlack}}}};
const json kNoAlbedo = {{"ground", {{"diffuse", kBlack}}},
                        {"matt", {{"diffuse", kBlack}}},
                        {"gloss", {{"diffuse", kBlack}}}};

INSTANTIATE_TEST_SUITE_P(
    Deferred, SparedTextures,
    testing::Values(
        Spared{"EverythingIsNeeded", "targets", {}, 3, 27},
        Spared{"NothingShines", "targets", {{"materials", kNoMirror}}, 2, 19},
        Spared{"NoSpecularLight", "targets", {{"light", {{"specular", kBlack}}}}, 2, 19},
        Spared{"NoAmbientLight", "targets", {{"light", {{"ambient", kBlack}}}}, 2, 19},
        Spared{"NeitherOfThem",
               "targets",
               {{"light", {{"specular", kBlack}, {"ambient", kBlack}}}},
               1,
               11},
        Spared{"AllPictures", "figure", {}, 12, 70},
        Spared{"NoOcclusion", "figure", {{"quality", {{"ao_samples", 0}}}}, 10, 61},
        Spared{"OcclusionOfNoReach", "figure", {{"quality", {{"ao_radius", 0}}}}, 10, 61},
        Spared{"NothingMirrors", "figure", {{"materials", kNoMirror}}, 9, 50},
        Spared{"OnlyMirrors", "figure", {{"materials", kNoAlbedo}}, 7, 37},
        Spared{"NoObjects", "figure", {{"ring", {{"count", 0}}}}, 9, 50}),
    [](const auto& one) { return one.param.name; });

TEST_P(SparedTextures, ChangesNotOneBit) {
  const Spared& spared = GetParam();
  json scene = small(spared.part, spared.patch);
  const Drawn lean = draw("deferred", scene);
  scene["debug"]["draw_all_passes"] = true;
  const Drawn all = draw("deferred", scene);
  EXPECT_EQ(differing(lean.frames[0], all.frames[0], 0), 0);
  EXPECT_EQ(drawnTextures(lean.trace), spared.textures);
  EXPECT_EQ(drawnTextures(all.trace), std::string(spared.part) == "targets" ? 3u : 12u);
  // A window of twice the height.
  json large = small(spared.part, spared.patch);
  large["size"] = {96, 144};
  const Drawn more = draw("deferred", large);
  EXPECT_EQ(double(more.trace.frames[0].imageBytes - lean.trace.frames[0].imageBytes) / (96 * 72),
            spared.bytes);
}

class BothParts : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Deferred, BothParts, testing::Values("targets", "figure"),
                         [](const auto& one) { return std::string(one.param); });

TEST_P(BothParts, ASecondFrameOfTheSameTimeIsTheSame) {
  const Drawn drawn = draw("deferred", small(GetParam()), {0.5, 0.5, 9, 0.5});
  EXPECT_EQ(differing(drawn.frames[0], drawn.frames[1], 0), 0);
  EXPECT_GT(differing(drawn.frames[0], drawn.frames[2], 0), 0.02);
  EXPECT_EQ(differing(drawn.frames[0], drawn.frames[3], 0), 0);
}

TEST_P(BothParts, AMillionTurnsLaterThePictureIsTheSame) {
  const Drawn drawn = draw("deferred", small(GetParam()), {9, 6e7 + 9});
  EXPECT_LE(differing(drawn.frames[0], drawn.frames[1]), 0.002);
}

TEST_P(BothParts, WindowsOfAnyShape) {
  for (const json& size : {json{1, 1}, json{1, 90}, json{90, 1}, json{53, 41}}) {
    const Image image = first(GetParam(), {{"size", size}});
    EXPECT_EQ(image.width(), size[0]);
    EXPECT_EQ(image.height(), size[1]);
  }
}

TEST_P(BothParts, FormatsAgree) {
  const Image usual = first(GetParam(), {{"quality", {{"format", 2}, {"normal", 0}}}});
  const auto with = [&](int format, int normal) {
    return first(GetParam(), {{"quality", {{"format", format}, {"normal", normal}}}});
  };
  EXPECT_LE(differing(usual, with(1, 1)), 0.01);
  EXPECT_LE(differing(usual, with(1, 2), 6.0f / 255), 0.03);
  EXPECT_LE(differing(usual, with(1, 3), 20.0f / 255), 0.05);
}

TEST_P(BothParts, NearAndFarPlanesTenMillionApart) {
  const json open = {{"quality", {{"ao_samples", 0}}}};
  json deep = open;
  deep["camera"] = {{"near", 1e-3}, {"far", 1e4}};
  EXPECT_LE(differing(first(GetParam(), open), first(GetParam(), deep)), 0.002);
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
  for (const char* key : {"radius", "scale"}) times(scene["ring"][key]);
  times(scene["ground"]["size"]);
  times(scene["quality"]["ao_radius"]);
  return scene;
}

TEST_P(BothParts, ATinyAndAHugeWorldLookTheSame) {
  const json scene = small(GetParam());
  const Image usual = draw("deferred", scene).frames[0];
  EXPECT_LE(differing(usual, draw("deferred", scaled(scene, 1e-4)).frames[0]), 0.01);
  EXPECT_LE(differing(usual, draw("deferred", scaled(scene, 1e6)).frames[0]), 0.01);
}

TEST_P(BothParts, TenThousandObjects) {
  json scene = {{"size", {48, 36}}, {"mesh", "box"}, {"ring", {{"count", 10000}, {"scale", 0.3}}}};
  const Image many = first(GetParam(), scene);
  scene["ring"]["count"] = 0;
  EXPECT_GT(differing(many, first(GetParam(), scene)), 0.1);
}

TEST_P(BothParts, AnEyeBelowTheGround) {
  first(GetParam(), {{"camera", {{"position", {0, -2, 7}}}}});
}

TEST_P(BothParts, AnEyeStraightAbove) {
  first(GetParam(), {{"camera", {{"position", {0, 9, 0}}, {"target", {0, 0, 0}}}}});
}

TEST(DeferredTargets, BlackLightIsBlack) {
  const Image image = first(
      "targets", {{"background", kBlack},
                  {"light", {{"ambient", kBlack}, {"diffuse", kBlack}, {"specular", kBlack}}}});
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; c < 3; ++c) ASSERT_EQ(image.at(x, y, c), 0) << x << ' ' << y;
}

TEST(DeferredTargets, TheBrightestLightIsWhite) {
  const json all = {{"ambient", kWhite}, {"diffuse", kWhite}, {"specular", kWhite}};
  const json patch = {
      {"background", kWhite},
      {"effects", {{"edges", false}}},
      {"light", all},
      {"materials", {{"ground", all}, {"matt", all}, {"gloss", all}, {"metal", all}}}};
  EXPECT_THAT(first("targets", patch).values(), Each(1.0f));
}

/// The window from what the three textures hold, in double precision.
TEST(DeferredTargets, ThePictureIsTheSumAndItsEdges) {
  for (const bool edges : {false, true}) {
    const Drawn drawn =
        draw("deferred",
             small("targets", {{"effects", {{"edges", edges}}}, {"quality", {{"format", 2}}}}));
    const std::uint32_t pass = drawn.writerOf("uDiffuse");
    std::array<Image, 3> kinds;
    for (std::uint32_t i = 0; i < 3; ++i)
      kinds[i] = drawn.trace.image(*drawn.trace.copyOf(pass, i));
    const Image& window = drawn.frames[0];
    const int width = window.width(), height = window.height();
    int emphasised = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (int c = 0; c < 3; ++c) {
          const auto diffuse = [&](int u, int v) {
            return double(
                kinds[0].at(std::clamp(u, 0, width - 1), std::clamp(v, 0, height - 1), c));
          };
          double light = diffuse(x, y);
          if (edges) {
            light = std::max(5 * light - diffuse(x - 1, y) - diffuse(x + 1, y) - diffuse(x, y - 1) -
                                 diffuse(x, y + 1),
                             0.0);
            emphasised += std::abs(light - diffuse(x, y)) > 0.1;
          }
          light += double(kinds[1].at(x, y, c)) + double(kinds[2].at(x, y, c));
          ASSERT_NEAR(window.at(x, y, c), std::clamp(light, 0.0, 1.0), 0.51 / 255)
              << x << ' ' << y << ' ' << c;
        }
    EXPECT_EQ(emphasised > 100, edges);
  }
}

TEST(DeferredTargets, OnePixelHasNoEdges) {
  const json one = {{"size", {1, 1}}};
  json without = one;
  without["effects"]["edges"] = false;
  EXPECT_EQ(differing(first("targets", one), first("targets", without), 0), 0);
}

/// IEC 61966-2-1.
double display(double light) {
  light = std::min(light, 1.0);
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

/// What falls on level ground, summed over the sky in small steps.
glm::dvec3 onLevelGround(const Sky& sky) {
  constexpr int kSteps = 400;
  glm::dvec3 sum(0);
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < 4 * kSteps; ++j) {
      const double height = (i + 0.5) / kSteps; // equal steps of height are equal solid angles
      const double turn = (j + 0.5) / (4 * kSteps) * 2 * std::numbers::pi;
      const double r = std::sqrt(1 - height * height);
      sum +=
          height * glm::dvec3(skyRadiance(sky, {r * std::sin(turn), height, -r * std::cos(turn)}));
    }
  sum *= 2 * std::numbers::pi / (kSteps * 4 * kSteps);
  const double disc = std::numbers::pi * std::pow(std::sin(double(sky.sunRadius)), 2);
  return sum + disc * double(sky.sunDirection.y) * glm::dvec3(sky.sunRadiance);
}

TEST(DeferredFigure, LevelGroundHasTheLightOfTheWholeSky) {
  Sky sky;
  sky.sunDirection = glm::vec3(glm::normalize(glm::dvec3(3, 5, 4)));
  sky.sunRadiance *= 0.5f;
  const double albedo[] = {0.5, 0.25, 0.125};
  const json patch = {{"ring", {{"count", 0}}},
                      {"light", {{"position", {3, 5, 4}}}},
                      {"sun", {{"brightness", 0.5}}},
                      {"materials", {{"ground", {{"diffuse", albedo}}}}}};
  const glm::dvec3 irradiance = onLevelGround(sky);
  for (const int method : {0, 1, 2}) {
    json with = patch;
    with["quality"]["irradiance"] = method;
    const Image image = first("figure", with);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(image.at(48, 70, c), display(albedo[c] * irradiance[c] / std::numbers::pi),
                  2.0 / 255)
          << method << ' ' << c;
  }
}

/// A mirror as the ground, seen from straight above: what is above the eye, times F0.
TEST(DeferredFigure, AMirrorSeenStraightOnHasItsOwnReflectance) {
  Sky sky;
  sky.sunDirection = {0, 0, 1};
  sky.sunRadiance = glm::vec3(0);
  const double reflectance[] = {0.25, 0.5, 0.125};
  const json patch = {
      {"size", {65, 65}},
      {"camera", {{"position", {0, 5, 0}}, {"target", {0, 0, 0}}}},
      {"ring", {{"count", 0}}},
      {"light", {{"position", {0, 0, 1}}}},
      {"sun", {{"brightness", 0}}},
      {"materials", {{"ground", {{"diffuse", kBlack}, {"specular", reflectance}}}}}};
  const Image image = first("figure", patch);
  const glm::vec3 above = skyRadiance(sky, {0, 1, 0});
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(image.at(32, 32, c), display(reflectance[c] * double(above[c])), 1.5 / 255) << c;
}

TEST(DeferredFigure, TheBackgroundIsTheEnvironment) {
  Sky sky;
  sky.sunRadiance = glm::vec3(0);
  sky.sunDirection = {0, 1, 0};
  const json patch = {{"size", {65, 65}},
                      {"camera", {{"position", {0, 5, 0}}, {"target", {4, 8, 0}}}},
                      {"light", {{"position", {0, 1, 0}}}},
                      {"sun", {{"brightness", 0}}}};
  const Image image = first("figure", patch);
  const glm::vec3 there = skyRadiance(sky, {0.8f, 0.6f, 0});
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(image.at(32, 32, c), display(double(there[c])), 1.5 / 255) << c;
}

TEST(DeferredFigure, AWorldWithoutLightIsBlack) {
  const Image image = first("figure", {{"sky", {{"brightness", 0}}}, {"sun", {{"brightness", 0}}}});
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; c < 3; ++c) ASSERT_EQ(image.at(x, y, c), 0) << x << ' ' << y;
}

TEST(DeferredFigure, TheBrightestSkyIsFinite) {
  for (const int format : {0, 1, 2}) // draw() looks at all that passes leave
    first("figure", {{"sky", {{"brightness", 1000}}},
                     {"sun", {{"brightness", 1000}, {"radius", 0.5}}},
                     {"quality", {{"format", format}}}});
}

TEST(DeferredFigure, AnyHeightOfTheSun) {
  for (const json& towards : {json{0, 0, 0}, json{0, -1, 0}, json{1, 0, 0}, json{0, 1e9, 0}})
    first("figure", {{"light", {{"position", towards}}}});
}

TEST(DeferredFigure, MapsOfOneTexel) {
  first("figure", {{"quality", {{"environment_height", 1}, {"irradiance_height", 1}}}});
}

/// Three mantissas and one exponent, rounded down as a reader expects it (Ward 1991).
std::string realPixels(const EnvironmentMap& map) {
  std::string text = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(map.height) +
                     " +X " + std::to_string(map.width) + "\n";
  for (const glm::vec3& light : map.texels) {
    int exponent = 0;
    std::frexp(std::max({light.x, light.y, light.z}), &exponent);
    for (const float value : {light.x, light.y, light.z})
      text += static_cast<char>(std::uint8_t(std::ldexp(value, 8 - exponent)));
    text += static_cast<char>(std::uint8_t(exponent + 128));
  }
  return text;
}

/// The sky that the program would make, taken from a file: one larger than is summed up. Without
/// occlusion, which takes the sun in a file for a part of the sky.
TEST(DeferredFigure, AnEnvironmentFromAFileLightsTheSame) {
  Sky sky;
  sky.sunDirection = glm::vec3(glm::normalize(glm::dvec3(3, 5, 4)));
  const std::string file = testing::TempDir() + "ggrade_sky.hdr";
  std::ofstream(file, std::ios::binary) << realPixels(environmentMap(sky, 512));
  const json patch = {
      {"light", {{"position", {3, 5, 4}}}},
      {"quality", {{"environment_height", 256}, {"irradiance", 2}, {"ao_samples", 0}}}};
  json fromFile = patch;
  fromFile["sky"] = {{"file", file}, {"brightness", 0}};
  const Image wanted = first("figure", patch), found = first("figure", fromFile);
  EXPECT_LE(differing(wanted, found, 3.01f / 255), 0.001);
  fromFile["sky"]["file"] = "";
  EXPECT_GT(differing(wanted, first("figure", fromFile), 3.01f / 255), 0.5);
}

TEST(DeferredFigure, AFileThatIsNoEnvironmentIsRefused) {
  EXPECT_THAT(refusal("deferred", small("figure", {{"sky", {{"file", "no_such.hdr"}}}})),
              testing::HasSubstr("no_such.hdr"));
}

/// Where the far plane cuts a level ground off, the background behind it hides nothing.
TEST(DeferredFigure, BeyondTheFarPlaneNothingIsHidden) {
  const json patch = {{"size", {160, 120}},
                      {"ring", {{"count", 0}}},
                      {"camera", {{"position", {0, 1, 7}}, {"target", {0, 0, 0}}, {"far", 8}}},
                      {"debug", {{"picture", 5}}}};
  const Image open = first("figure", patch);
  for (int y = 0; y < open.height(); ++y)
    for (int x = 0; x < open.width(); ++x) ASSERT_GE(open.at(x, y), 0.9f) << x << ' ' << y;
}

/// Below a pixel's size there is nothing to be seen.
TEST(DeferredFigure, OcclusionOfATinyReachIsNone) {
  const Image none = first("figure", {{"quality", {{"ao_samples", 0}}}});
  EXPECT_EQ(differing(none, first("figure", {{"quality", {{"ao_radius", 1e-4}}}}), 0), 0);
}

TEST(DeferredFigure, OcclusionOfAnyReachIsFinite) {
  for (const double reach : {1e-30, 3.0, 50.0, 1e7})
    first("figure", {{"quality", {{"ao_radius", reach}}}});
}

/// Level ground alone occludes nothing, at whatever angle it is seen.
TEST(DeferredFigure, LevelGroundOccludesNothing) {
  for (const double height : {0.2, 1.0, 5.0}) {
    const json patch = {{"size", {160, 120}},
                        {"ring", {{"count", 0}}},
                        {"camera", {{"position", {0, height, 7}}, {"target", {0, 0, 0}}}},
                        {"debug", {{"picture", 5}}}};
    const Image open = first("figure", patch);
    double darkest = 1;
    std::size_t grey = 0;
    for (int y = 0; y < open.height(); ++y)
      for (int x = 0; x < open.width(); ++x) {
        darkest = std::min(darkest, double(open.at(x, y)));
        grey += open.at(x, y) < 1;
      }
    EXPECT_GE(darkest, 0.9) << height;
    EXPECT_LE(double(grey) / double(open.pixelCount()), 0.02) << height;
  }
}

TEST(DeferredFigure, EveryPictureCanBeShown) {
  for (int picture = 1; picture <= 14; ++picture) {
    const Image image = first("figure", {{"debug", {{"picture", picture}}}});
    EXPECT_GT(differing(image, Image(image.width(), image.height(), image.channels())), 0.05)
        << picture;
  }
}

} // namespace
