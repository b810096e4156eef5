#include "diagnosis/correspondence.hpp"
#include "diagnosis/match.hpp"
#include "diagnosis_samples.hpp"

#include <gmock/gmock.h>

#include <random>

using namespace ggrade;
using namespace ggrade::diagnosis;
using samples::painted;
using samples::scene;
using testing::ElementsAre;

namespace {

template <class Change> Image mapped(Image image, Change change) {
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) change(image.pixel(x, y));
  return image;
}

/// Unit vectors all around, as a G-buffer has them.
Image directions() {
  Image image(160, 120, 3);
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 160; ++x) {
      const float polar = 3.1f * (float(y) + 0.5f) / 120, around = 6.2f * (float(x) + 0.5f) / 160;
      image.at(x, y, 0) = std::sin(polar) * std::cos(around);
      image.at(x, y, 1) = std::sin(polar) * std::sin(around);
      image.at(x, y, 2) = std::cos(polar);
    }
  return image;
}

Image withOffset(const Image& image) {
  return mapped(image, [](auto pixel) {
    for (float& value : pixel) value = 0.5f + 0.5f * value;
  });
}

/// Lambert's equal-area projection: two numbers for a direction.
Image sphereMap(const Image& image) {
  return mapped(image, [](auto pixel) {
    const float scale = std::sqrt(8 * pixel[2] + 8);
    pixel[0] = pixel[0] / scale + 0.5f;
    pixel[1] = pixel[1] / scale + 0.5f;
    pixel[2] = 0;
  });
}

Image noise(unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<float> values(0, 1);
  return mapped(Image(160, 120, 3), [&](auto pixel) {
    for (float& value : pixel) value = values(generator);
  });
}

TEST(DiagnosisCorrespondence, ARatioOfOneMeansAFunctionAndZeroNone) {
  // b's variance within eight even parts of a is 1/64 of it all.
  Image ramp(256, 8, 1), square(256, 8, 1);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 256; ++x) {
      ramp.at(x, y) = float(x) / 255;
      square.at(x, y) = std::pow(2 * ramp.at(x, y) - 1, 2.0f);
    }
  EXPECT_NEAR(correlationRatio(ramp, ramp), 63.0 / 64, 1e-3);
  EXPECT_GT(correlationRatio(ramp, square), 0.9);
  EXPECT_NEAR(correlationRatio(square, ramp), 0, 0.01) << "either root may be it";
  EXPECT_NEAR(correlationRatio(noise(1), noise(2)), 0, 0.05);
  EXPECT_EQ(correlationRatio(ramp, Image(256, 8, 1, 0.5f)), 0);
}

TEST(DiagnosisCorrespondence, AnotherEncodingHoldsTheSame) {
  const Image normals = directions();
  EXPECT_TRUE(holdTheSame(normals, withOffset(normals)));
  EXPECT_TRUE(holdTheSame(normals, sphereMap(normals)));
  EXPECT_TRUE(holdTheSame(scene(), resized(scene(), 200, 150)));
  const Image folded = mapped(normals, [](auto pixel) { pixel[2] = std::abs(pixel[2]); });
  EXPECT_FALSE(holdTheSame(normals, folded)) << "what is behind can't be told any more";
  EXPECT_FALSE(holdTheSame(folded, normals));
  EXPECT_FALSE(holdTheSame(normals, noise(1)));
  EXPECT_FALSE(holdTheSame(normals, Image(160, 120, 3, 0.5f)));
}

/// A frame of four textures of one kind and a window.
SceneViews frame(const std::vector<Image>& textures, const Image& window) {
  SceneViews views;
  for (const Image& texture : textures)
    views.passes.push_back(
        {{false, false, 0, std::int32_t(views.passes.size())}, 320, 240, reduced(texture, 3)});
  views.windows = {reduced(window, 3)};
  views.width = 320;
  views.height = 240;
  return views;
}

const Image kNormals = directions(), kLight = scene(), kTiles = scene(320, 240, 0.1f),
            kSum = painted(kLight, 0.3f, 0.3f, 0.9f, 0.5f, 0.7f);

SceneViews right() {
  return frame({kNormals, kLight, kTiles, kSum}, kSum);
}

std::vector<int> slots(const SceneViews& views) {
  std::vector<int> all;
  for (const PassView& pass : views.passes) all.push_back(pass.slot.nth);
  return all;
}

TEST(DiagnosisCorrespondence, PassesAreFoundWhereTheyAreMissingOrInAnotherOrder) {
  const auto without = corresponding({frame({kNormals, kTiles, kSum}, kSum)}, {right()});
  EXPECT_THAT(slots(without[0]), ElementsAre(0, 2, 3));
  EXPECT_FALSE(firstWrong(without, withPassesOf(without, {right()})));
  EXPECT_TRUE(firstWrong(without, {right()})->missing);
  const auto swapped = corresponding({frame({kSum, kTiles, kLight, kNormals}, kSum)}, {right()});
  EXPECT_FALSE(firstWrong(swapped, {right()}));
  // One more than the reference has is no one's.
  const auto more =
      corresponding({frame({noise(1), kNormals, kLight, kTiles, kSum}, kSum)}, {right()});
  EXPECT_FALSE(firstWrong(more, {right()}));
  EXPECT_THAT(slots(more[0]), ElementsAre(0, 1, 2, 3));
}

TEST(DiagnosisCorrespondence, WhatIsWrongStaysWrong) {
  const Image wrong = painted(kTiles, 0.1f, 0.1f, 0.4f, 0.6f, 0.9f);
  const auto run = corresponding({frame({sphereMap(kNormals), wrong, kSum}, kSum)}, {right()});
  EXPECT_THAT(slots(run[0]), ElementsAre(0, 2, 3));
  const auto first = firstWrong(run, withPassesOf(run, {right()}));
  ASSERT_TRUE(first);
  EXPECT_EQ(first->slot->nth, 2);
}

/// A mistake in the third texture, from which the fourth and the window are made, all up to here.
Run mistake(const std::vector<Image>& before, float right, float rightInWindow) {
  const auto paint = [](const Image& image, float to) {
    return painted(image, 0.1f, 0.5f, to, 0.8f, 0.95f);
  };
  std::vector<Image> textures = before;
  textures.push_back(paint(kTiles, right));
  textures.push_back(paint(kSum, rightInWindow));
  return {frame(textures, paint(kSum, rightInWindow))};
}

TEST(DiagnosisCorrespondence, AMistakeIsNamedInAProgramThatIsMadeInAnotherWay) {
  const KnownFaults known{{right()},
                          {{"wide", "", mistake({kNormals, kLight}, 0.8f, 0.8f)},
                           {"narrow", "", mistake({kNormals, kLight}, 0.4f, 0.4f)}}};
  for (const auto& before :
       {std::vector{sphereMap(kNormals), kLight}, std::vector{kNormals}, std::vector<Image>{}}) {
    // Not quite the same in the window, either.
    const auto student = mistake(before, 0.8f, 0.77f);
    const auto found = known.identify(student);
    ASSERT_TRUE(found) << before.size();
    EXPECT_EQ(known.signatures[found->signature].name, "wide");
    EXPECT_FALSE(known.identify(student, {}, {true, false})) << before.size();
  }
}

/// The window is black in many ways: missing passes aside, all of them are alike.
TEST(DiagnosisCorrespondence, AnEmptyWindowBehindRightPassesNamesNothing) {
  const Image black(320, 240, 3);
  const KnownFaults known{
      {right()}, {{"into another", "", {frame({kNormals, kLight, kTiles, noise(1)}, black)}}}};
  EXPECT_TRUE(known.identify({frame({kNormals, kLight, kTiles, noise(1)}, black)}));
  EXPECT_FALSE(known.identify({frame({kNormals, kLight, kTiles}, black)}));
}

} // namespace
