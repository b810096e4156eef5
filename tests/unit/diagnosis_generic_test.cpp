#include "diagnosis/generic.hpp"
#include "diagnosis_samples.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

using namespace ggrade;
using namespace ggrade::diagnosis;
using Kind = Generic::Kind;
using testing::StrEq;

namespace {

const Image kScene = samples::scene(), kBefore = samples::scene(320, 240, -0.06f);

/// What is said of one wrong picture beside the sample.
std::optional<Generic> of(const Image& student, const Image* stub = nullptr) {
  const Pair pair{&student, &kScene, &kBefore, stub};
  return generic({&pair, 1});
}

template <class From> Image rearranged(const Image& image, const From& from) {
  Image out = image;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) from(x, y, out.pixel(x, y));
  return out;
}

Image curve(const Image& image, float exponent) {
  Image out = image;
  for (float& value : out.values()) value = std::pow(value, exponent);
  return out;
}

TEST(DiagnosisGeneric, RightPicturesHaveNoFault) {
  EXPECT_FALSE(of(kScene));
}

TEST(DiagnosisGeneric, UpsideDownMirroredAndTurned) {
  const int right = kScene.width() - 1, bottom = kScene.height() - 1;
  const auto copy = [](std::span<const float> from, std::span<float> to) {
    std::ranges::copy(from, to.begin());
  };
  const auto upsideDown =
      of(rearranged(kScene, [&](int x, int y, auto to) { copy(kScene.pixel(x, bottom - y), to); }));
  ASSERT_TRUE(upsideDown);
  EXPECT_EQ(upsideDown->kind, Kind::upsideDown);
  EXPECT_GT(upsideDown->likeness, 0.99);
  EXPECT_THAT(describe(*upsideDown, "The window's picture"),
              StrEq("The window's picture is right, but upside down."));
  const auto mirrored =
      of(rearranged(kScene, [&](int x, int y, auto to) { copy(kScene.pixel(right - x, y), to); }));
  ASSERT_TRUE(mirrored);
  EXPECT_EQ(mirrored->kind, Kind::mirrored);
  const auto turned = of(rearranged(
      kScene, [&](int x, int y, auto to) { copy(kScene.pixel(right - x, bottom - y), to); }));
  ASSERT_TRUE(turned);
  EXPECT_EQ(turned->kind, Kind::turned);
}

TEST(DiagnosisGeneric, ShiftedByTheVeryPixels) {
  for (const auto& [dx, dy] : {std::pair(7, 0), {0, -3}, {-11, 5}}) {
    const auto found = of(rearranged(kScene, [&](int x, int y, auto to) {
      std::ranges::copy(kScene.pixel(std::clamp(x - dx, 0, kScene.width() - 1),
                                     std::clamp(y - dy, 0, kScene.height() - 1)),
                        to.begin());
    }));
    ASSERT_TRUE(found) << dx << " " << dy;
    EXPECT_EQ(found->kind, Kind::shifted);
    EXPECT_EQ(found->dx, dx);
    EXPECT_EQ(found->dy, dy);
  }
  EXPECT_THAT(describe({Kind::shifted, -11, 1}, "It"),
              StrEq("It is right, but shifted by 11 pixels to the left and 1 pixel down."));
}

TEST(DiagnosisGeneric, ColoursThatAreSwappedScaledOrCurved) {
  const auto swapped = of(rearranged(kScene, [](int, int, auto to) { std::swap(to[0], to[2]); }));
  ASSERT_TRUE(swapped);
  EXPECT_EQ(swapped->kind, Kind::redBlueSwapped);
  const auto dark = of(curve(kScene, 2.2f));
  ASSERT_TRUE(dark);
  EXPECT_EQ(dark->kind, Kind::notEncoded);
  const auto bright = of(curve(kScene, 1 / 2.2f));
  ASSERT_TRUE(bright);
  EXPECT_EQ(bright->kind, Kind::encodedTwice);
  Image half = kScene;
  for (float& value : half.values()) value *= 0.5f;
  const auto scaled = of(half);
  ASSERT_TRUE(scaled);
  EXPECT_EQ(scaled->kind, Kind::scaled);
  EXPECT_NEAR(scaled->factor, 0.5, 0.01);
  EXPECT_THAT(describe(*scaled, "It"),
              StrEq("It is right, but 0.50 times as bright as it should be."));
}

TEST(DiagnosisGeneric, OneColourAndAnotherSize) {
  const auto black = of(Image(320, 240, 3));
  ASSERT_TRUE(black);
  EXPECT_EQ(black->kind, Kind::black);
  const auto grey = of(Image(320, 240, 3, 0.4f));
  ASSERT_TRUE(grey);
  EXPECT_EQ(grey->kind, Kind::constant);
  const auto small = of(samples::scene(200, 150));
  ASSERT_TRUE(small);
  EXPECT_EQ(small->kind, Kind::otherSize);
}

TEST(DiagnosisGeneric, TheFrameBeforeAndTheStub) {
  const auto late = of(kBefore);
  ASSERT_TRUE(late);
  EXPECT_EQ(late->kind, Kind::lastFrame);
  const Image stub = samples::painted(kScene, 0.1f, 0.5f, 0.9f, 0.9f, 0.2f);
  const auto undone = of(stub, &stub);
  ASSERT_TRUE(undone);
  EXPECT_EQ(undone->kind, Kind::stub);
}

TEST(DiagnosisGeneric, AnotherFaultIsUnknown) {
  EXPECT_FALSE(of(samples::painted(kScene, 0.2f, 0.5f, 0.7f, 0.8f, 0.9f)));
  // Upside down, but only in a half.
  EXPECT_FALSE(of(rearranged(kScene, [&](int x, int y, auto to) {
    if (x < kScene.width() / 2)
      std::ranges::copy(kScene.pixel(x, kScene.height() - 1 - y), to.begin());
  })));
  Image infinite = kScene;
  infinite.at(3, 3, 1) = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(of(infinite));
}

TEST(DiagnosisGeneric, OneScenesFaultMustBeAllScenes) {
  Image swapped = kScene;
  for (int y = 0; y < swapped.height(); ++y)
    for (int x = 0; x < swapped.width(); ++x) std::swap(swapped.at(x, y, 0), swapped.at(x, y, 2));
  const Image other = samples::painted(kScene, 0.2f, 0.5f, 0.7f, 0.8f, 0.9f);
  const Pair both[] = {{&swapped, &kScene, nullptr, nullptr}, {&other, &kScene, nullptr, nullptr}};
  EXPECT_FALSE(generic(both));
}

/// A bright disc's light, added to the sample: times a factor, or as `how` joins the two.
Image lit(
    float factor, float (*how)(float, float) = [](float a, float b) { return a + b; }) {
  return rearranged(kScene, [&](int x, int y, std::span<float> pixel) {
    const float u = float(x) / 320 - 0.5f, v = float(y) / 240 - 0.5f;
    for (float& value : pixel)
      value = how(value / 3, factor * 0.5f * std::exp(-20 * (u * u + v * v)));
  });
}

TEST(DiagnosisGeneric, LightIsScaledOrIsOther) {
  const Image before = lit(0), right = lit(1);
  EXPECT_TRUE(addsScaledLight(right, right, before));
  EXPECT_TRUE(addsScaledLight(lit(0.2f), right, before));
  EXPECT_TRUE(addsScaledLight(lit(1.4f), right, before));
  const auto larger = [](float a, float b) { return std::max(a, b); };
  EXPECT_FALSE(addsScaledLight(lit(1, larger), right, before));
  // As a display shows them.
  const auto shown = [](const Image& image) { return curve(image, 1 / 2.2f); };
  EXPECT_TRUE(addsScaledLight(shown(lit(0.2f)), shown(right), shown(before)));
  EXPECT_FALSE(addsScaledLight(shown(lit(1, larger)), shown(right), shown(before)));
}

} // namespace
