// Bloom at its ends: light that no half float holds, NaN, fireflies, windows smaller than a level.

#include "drawn.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

using namespace extremes;
using ggrade::channel::ReplacementAnswer;
using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::Ge;
using testing::Le;

namespace {

constexpr std::uint32_t kRgba16f = 0x881A, kRgba32f = 0x8814;
constexpr float kHalfMost = 65504; // the largest half float
constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Passes of a frame with bloom alone: the scene, the bright pass, the levels down and up again, and
// the composite.
constexpr std::uint32_t kScene = 0, kBright = 1;
std::uint32_t lastUp(int levels) {
  return std::uint32_t(2 * levels - 1);
}

json bloomScene(int width, int height, const json& patch = {}) {
  json all = {{"size", {width, height}}, {"mesh", "box"}, {"debug", {{"draw_all_passes", true}}}};
  if (!patch.is_null()) all.merge_patch(patch);
  return sceneOf("floor", {"bloom"}, all);
}

/// Draws with `light` in place of the scene's own picture.
Drawn drawLight(const Image& light, const json& patch, std::uint32_t format = kRgba16f) {
  json scene = bloomScene(light.width(), light.height(), patch);
  if (format == kRgba32f) scene["quality"]["bloom_format"] = 3;
  Drawn drawn = draw("floor", scene, {0.21}, {colors(kScene, format, light)});
  EXPECT_THAT(drawn.replacements, ElementsAre(ReplacementAnswer::done));
  return drawn;
}

json threshold(float of) {
  return {{"bloom", {{"threshold", of}}}};
}

/// Sum over all pixels of the red channel.
double total(const Image& image) {
  double sum = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) sum += image.at(x, y, 0);
  return sum;
}

/// The least and the greatest value of RGB.
std::pair<float, float> extent(const Image& image) {
  const Image colors = ggrade::firstChannels(image, 3);
  const auto [least, most] = std::minmax_element(colors.values().begin(), colors.values().end());
  return {*least, *most};
}

/// The light of a whole level, in pixels of the scene.
double energy(const Image& level, const Image& scene) {
  return total(level) * double(scene.pixelCount()) / double(level.pixelCount());
}

/// One pixel of a value in a black picture, and what it must count for.
struct Pixel {
  const char* name;
  float value;
  std::uint32_t format;
  float counts;
};
void PrintTo(const Pixel& pixel, std::ostream* out) {
  *out << pixel.name;
}

class OnePixel : public testing::TestWithParam<Pixel> {};

INSTANTIATE_TEST_SUITE_P(Bloom, OnePixel,
                         testing::Values(Pixel{"Nan", kNan, kRgba16f, 0},
                                         Pixel{"PositiveInf", kInf, kRgba16f, kHalfMost},
                                         Pixel{"NegativeInf", -kInf, kRgba16f, 0},
                                         Pixel{"Negative", -3, kRgba16f, 0},
                                         Pixel{"Largest", kHalfMost, kRgba16f, kHalfMost},
                                         Pixel{"Denormal", 6e-8f, kRgba16f, 0},
                                         Pixel{"One", 1, kRgba16f, 1},
                                         Pixel{"NanInFloats", kNan, kRgba32f, 0},
                                         Pixel{"InfInFloats", kInf, kRgba32f, kHalfMost},
                                         Pixel{"BeyondHalfFloats", 1e30f, kRgba32f, kHalfMost},
                                         Pixel{"LargestFloat", 3.4e38f, kRgba32f, kHalfMost},
                                         Pixel{"NegativeLargestFloat", -3.4e38f, kRgba32f, 0},
                                         Pixel{"DenormalInFloats", 1e-42f, kRgba32f, 0}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_P(OnePixel, IsMadeFiniteBeforeAnyFilter) {
  Image light(16, 12, 4, 0);
  for (int c = 0; c < 3; ++c) light.at(5, 6, c) = GetParam().value;
  const Drawn drawn = drawLight(light, threshold(0), GetParam().format);
  const Image bright = drawn.leftBy(kBright);
  EXPECT_NEAR(energy(bright, light) * 6, GetParam().counts, 2e-3 * GetParam().counts + 1e-6);
  // [1 3 3 1] / 8 each way: the pixel reaches two by two pixels of the level, no more.
  EXPECT_NEAR(bright.at(2, 3, 0) * 6, GetParam().counts * 9 / 64, 2e-3 * GetParam().counts + 1e-6);
  EXPECT_EQ(bright.at(4, 3, 0), 0);
  EXPECT_NEAR(energy(drawn.leftBy(lastUp(6)), light), GetParam().counts,
              5e-3 * GetParam().counts + 1e-6);
  // The window shows the pixel itself, as finite as that.
  EXPECT_EQ(drawn.frames[0].at(5, 6, 0), GetParam().counts > 0 ? 1 : 0);
}

struct Size {
  int width, height;
};
void PrintTo(const Size& size, std::ostream* out) {
  *out << size.width << 'x' << size.height;
}
std::string nameOf(const testing::TestParamInfo<Size>& info) {
  return std::to_string(info.param.width) + 'x' + std::to_string(info.param.height);
}

class LightOfSize : public testing::TestWithParam<Size> {
protected:
  Image constant(float value) const { return Image(GetParam().width, GetParam().height, 4, value); }
};

INSTANTIATE_TEST_SUITE_P(Bloom, LightOfSize,
                         testing::Values(Size{1, 1}, Size{2, 2}, Size{1, 1080}, Size{1080, 1},
                                         Size{7, 13}, Size{45, 37}, Size{97, 3}, Size{641, 479},
                                         Size{1920, 2}),
                         nameOf);

/// Nothing at all in any level.
void expectNoBloom(const Drawn& drawn) {
  for (std::uint32_t pass = kBright; pass <= lastUp(6); ++pass)
    EXPECT_EQ(extent(drawn.leftBy(pass)), std::pair(0.0f, 0.0f)) << pass;
}

TEST_P(LightOfSize, BlackStaysExactlyBlack) {
  const Drawn drawn = drawLight(constant(0), threshold(0));
  expectNoBloom(drawn);
  EXPECT_EQ(total(drawn.frames[0]), 0);
}

TEST_P(LightOfSize, WhatStaysBelowTheThresholdAddsNothing) {
  const Drawn drawn = drawLight(constant(0.5f), threshold(1));
  expectNoBloom(drawn);
  EXPECT_THAT(drawn.frames[0].pixel(0, 0),
              ElementsAre(188.0f / 255, 188.0f / 255, 188.0f / 255, 1));
}

TEST_P(LightOfSize, AFireflyKeepsItsEnergy) {
  Image light = constant(0);
  for (int c = 0; c < 3; ++c) light.at(light.width() / 3, light.height() / 2, c) = 6e4f;
  const Drawn drawn = drawLight(light, threshold(0));
  for (std::uint32_t pass = kBright; pass < kBright + 6; ++pass)
    EXPECT_NEAR(energy(drawn.leftBy(pass), light), 6e4 / 6, 60) << "level " << pass - kBright;
  EXPECT_NEAR(energy(drawn.leftBy(lastUp(6)), light), 6e4, 300);
}

TEST_P(LightOfSize, EvenLightStaysEven) {
  // 0.5 exceeds 0.25 by 0.25, which each of the levels gets its share of: 0.75 in all, and 225 of
  // 255 once that is encoded.
  for (int filter = 0; filter < 4; ++filter) {
    json patch = threshold(0.25f);
    patch["quality"] = {{"bloom_filter", filter}, {"bloom_edge", filter % 2}};
    const Drawn drawn = drawLight(constant(0.5f), patch);
    const auto sum = extent(drawn.leftBy(lastUp(6)));
    EXPECT_NEAR(sum.first, 0.25, 0.0015) << filter;
    EXPECT_NEAR(sum.second, 0.25, 0.0015) << filter;
    const auto shown = extent(drawn.frames[0]);
    EXPECT_NEAR(shown.first * 255, 225, 1.1) << filter;
    EXPECT_NEAR(shown.second * 255, 225, 1.1) << filter;
  }
}

/// The bright pass in double precision, as the lecture's formula and the area weights have it.
Image brightPass(const Image& scene, int width, int height, double threshold, double weight) {
  const auto area = [](double x) {
    x = std::clamp(x, -1.0, 1.0);
    return x < 0 ? 0.5 * (1 + x) * (1 + x) : 1 - 0.5 * (1 - x) * (1 - x);
  };
  const auto share = [&](int j, int i, int from, int to) {
    const double ratio = double(from) / to, centre = (i + 0.5) * ratio;
    return area((j + 1 - centre) / ratio) - area((j - centre) / ratio);
  };
  const auto mirrored = [](int j, int size) {
    j = std::max(j, -1 - j);
    return std::clamp(std::min(j, 2 * size - 1 - j), 0, size - 1);
  };
  const auto finite = [](double v) { return v > 0 ? std::min(v, double(kHalfMost)) : 0; };
  Image bright(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      double sum[3] = {};
      for (int v = -scene.height(); v < 2 * scene.height(); ++v)
        for (int u = -scene.width(); u < 2 * scene.width(); ++u) {
          const double part =
              share(u, x, scene.width(), width) * share(v, y, scene.height(), height);
          if (part == 0) continue;
          for (int c = 0; c < 3; ++c)
            sum[c] +=
                part * finite(scene.at(mirrored(u, scene.width()), mirrored(v, scene.height()), c));
        }
      const double most = std::max({sum[0], sum[1], sum[2]});
      const double ratio = std::max(most - threshold, 0.0) / std::max(most, 1e-5);
      for (int c = 0; c < 3; ++c) bright.at(x, y, c) = float(sum[c] * ratio * weight);
    }
  return bright;
}

class Field : public testing::TestWithParam<Size> {};

INSTANTIATE_TEST_SUITE_P(Bloom, Field,
                         testing::Values(Size{1, 1}, Size{3, 5}, Size{7, 13}, Size{16, 12},
                                         Size{45, 37}, Size{61, 2}),
                         nameOf);

TEST_P(Field, OfAllKindsOfValuesIsAsTheFormulaSays) {
  const float kinds[] = {0.5f, kNan, 1e3f, -2, kInf, 0, 6e-8f, -kInf, kHalfMost, 1.25f, 30, -0.0f};
  Image light(GetParam().width, GetParam().height, 4, 1);
  std::uint32_t state = 1;
  for (int y = 0; y < light.height(); ++y)
    for (int x = 0; x < light.width(); ++x)
      for (int c = 0; c < 3; ++c) {
        state = state * 1664525 + 1013904223; // Numerical Recipes
        light.at(x, y, c) = kinds[(state >> 16) % std::size(kinds)];
      }
  const Image bright = drawLight(light, threshold(1)).leftBy(kBright);
  const Image truth = brightPass(light, bright.width(), bright.height(), 1, 1.0 / 6);
  for (int y = 0; y < bright.height(); ++y)
    for (int x = 0; x < bright.width(); ++x)
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(bright.at(x, y, c), truth.at(x, y, c), 1e-3 * truth.at(x, y, c) + 1e-3)
            << x << ' ' << y << ' ' << c;
}

class Levels : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Bloom, Levels, testing::Values(1, 5, 7, 9, 11, 12));

TEST_P(Levels, TheirSumOfTheBrightestLightIsFinite) {
  const json patch = {{"bloom", {{"threshold", 0}}}, {"quality", {{"bloom_levels", GetParam()}}}};
  for (int edge : {0, 1}) {
    json with = patch;
    with["quality"]["bloom_edge"] = edge;
    const Drawn drawn = drawLight(Image(8, 6, 4, kInf), with);
    const Image sum = drawn.leftBy(lastUp(GetParam()));
    EXPECT_THAT(sum.values(), Each(Le(kHalfMost)));
    EXPECT_NEAR(sum.at(1, 1, 0), kHalfMost, 0.01 * kHalfMost);
    EXPECT_THAT(drawn.frames[0].values(), Each(1.0f));
  }
}

TEST_P(Levels, FitIntoAWindowOfFifteenPixels) {
  const json patch = {{"bloom", {{"threshold", 0.25}}},
                      {"quality", {{"bloom_levels", GetParam()}}}};
  const Drawn drawn = drawLight(Image(5, 3, 4, 0.5f), patch);
  const Image sum = drawn.leftBy(lastUp(GetParam()));
  EXPECT_EQ(sum.sizeText(), "2x1");
  EXPECT_NEAR(sum.at(0, 0, 0), 0.25, 0.002);
  const Image smallest = drawn.leftBy(std::uint32_t(GetParam()));
  EXPECT_EQ(smallest.sizeText(), GetParam() == 1 ? "2x1" : "1x1");
}

TEST(Bloom, APictureOfNanIsBlackAndOneOfInfinityWhite) {
  EXPECT_EQ(total(drawLight(Image(9, 7, 4, kNan), {}).frames[0]), 0);
  EXPECT_EQ(total(drawLight(Image(9, 7, 4, -kInf), {}).frames[0]), 0);
  EXPECT_EQ(total(drawLight(Image(9, 7, 4, kInf), {}).frames[0]), 63);
}

TEST(Bloom, AThresholdBeyondAllLight) {
  const json patch = {{"bloom", {{"threshold", 1e30}}}};
  const Drawn drawn = drawLight(Image(9, 7, 4, kInf), patch);
  EXPECT_EQ(total(drawn.leftBy(kBright)), 0);
  // Then nothing but the scene and the composite is drawn.
  json scene = bloomScene(60, 45, patch);
  const Image all = draw("floor", scene).frames[0];
  scene["debug"]["draw_all_passes"] = false;
  const Drawn few = draw("floor", scene);
  EXPECT_EQ(few.trace.passesOf(0).size(), 2u);
  EXPECT_EQ(differing(all, few.frames[0], 0), 0);
}

class Format : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Bloom, Format, testing::Values(0, 1, 2, 3));

TEST_P(Format, GlowThatNoHalfFloatHoldsIsWhite) {
  json patch = {{"size", {120, 90}},
                {"mesh", "box"},
                {"quality", {{"bloom_format", GetParam()}}},
                {"ring", {{"glow", 1e3}}}};
  const Drawn usual = draw("floor", sceneOf("floor", {"mirror", "bloom"}, patch));
  patch["ring"]["glow"] = 1e30;
  const Drawn drawn = draw("floor", sceneOf("floor", {"mirror", "bloom"}, patch));
  std::size_t white = 0;
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 120; ++x) {
      const auto before = usual.frames[0].pixel(x, y);
      if (std::min({before[0], before[1], before[2]}) < 1) continue;
      ++white;
      EXPECT_EQ(drawn.frames[0].at(x, y, 0), 1) << x << ' ' << y;
      EXPECT_EQ(drawn.frames[0].at(x, y, 2), 1) << x << ' ' << y;
    }
  EXPECT_GT(white, 800u) << "objects and their reflections";
  // No reflection, whatever it is stored in, holds more light than a half float.
  const Image light = drawn.leftBy(drawn.writerOf("uReflection"));
  EXPECT_LE(*std::max_element(light.values().begin(), light.values().end()), kHalfMost);
}

TEST_P(Format, TheBrightestLightOfAll) {
  const json white = {kHalfMost, kHalfMost, kHalfMost};
  const json all = {{"ambient", white}, {"diffuse", white}, {"specular", white}};
  const json patch = {{"size", {60, 45}},
                      {"mesh", "box"},
                      {"quality", {{"bloom_format", GetParam()}}},
                      {"background", white},
                      {"ring", {{"glow", 1e30}}},
                      {"bloom", {{"threshold", 0}}},
                      {"light", all},
                      {"materials", {{"object", all}, {"floor", all}}}};
  const Drawn drawn = draw("floor", sceneOf("floor", {}, patch));
  EXPECT_THAT(drawn.frames[0].values(), Each(1.0f));
  EXPECT_THAT(drawn.leftBy(drawn.writerOf("uScene")).values(), Each(Ge(1.0f)));
  EXPECT_THAT(drawn.leftBy(drawn.writerOf("uBloom")).values(),
              Each(AllOf(Ge(0.97f), Le(1.001f * kHalfMost))));
}

} // namespace
