// What changes in a scene must change in the picture, and nothing else: on pictures of a square.

#include "rubric/follows.hpp"

#include <gmock/gmock.h>

using namespace ggrade;
using namespace ggrade::rubric;
using testing::HasSubstr;

namespace {

constexpr int kWidth = 80, kHeight = 60, kSide = 20;

/// A white square on black, its corner at (x,y).
Image square(int x, int y, int width = kWidth, int height = kHeight, int side = kSide) {
  Image image(width, height, 3);
  for (int v = std::max(0, y); v < std::min(height, y + side); ++v)
    for (int u = std::max(0, x); u < std::min(width, x + side); ++u)
      for (int c = 0; c < 3; ++c) image.at(u, v, c) = 1;
  return image;
}

Mask white(const View& view, std::size_t frame) {
  return shown(view.frames.at(frame));
}

SceneEvidence scene(Frames reference, Frames student, const std::string& like = "") {
  SceneEvidence one;
  one.name = "the light was moved";
  one.like = like;
  one.frameCount = reference.size();
  one.reference = std::move(reference);
  one.student = std::move(student);
  return one;
}

Verdict judged(const SceneEvidence& scene, const SceneEvidence* base = nullptr) {
  return follows({scene, scene.student, scene.studentTrace, base}, white, "shadow");
}

TEST(Follows, WhatMovesWithTheTimeIsRight) {
  const Frames moves = {square(5, 5), square(40, 5)};
  EXPECT_EQ(judged(scene(moves, moves)).quality, 1);
  // Somewhere else, but it moves: not this item's affair.
  EXPECT_EQ(judged(scene(moves, {square(5, 35), square(50, 35)})).quality, 1);
}

TEST(Follows, WhatStaysIsNamed) {
  const Verdict still = judged(scene({square(5, 5), square(40, 5)}, {square(5, 5), square(5, 5)}));
  EXPECT_EQ(still.quality, 0);
  EXPECT_EQ(still.message, "time passed: 0% of the shadow changed place, 100% in the reference");
}

TEST(Follows, AChangeOfHalfTheSizeIsWorthHalf) {
  // 15 of 20 columns leave the 10 columns beyond the two that may move: (8 + 8) of 40 columns.
  const Verdict half = judged(scene({square(5, 5), square(40, 5)}, {square(5, 5), square(15, 5)}));
  EXPECT_NEAR(half.quality, (16.0 / 40 - 0.2) / 0.3, 1e-9);
}

TEST(Follows, WhereNothingChangesOrNothingIsThereNothingIsLost) {
  const Frames still = {square(5, 5), square(6, 5)};
  EXPECT_EQ(judged(scene(still, {square(5, 5), square(5, 5)})).message,
            "the change is too small to see");
  const Image black(kWidth, kHeight, 3);
  const Verdict none = judged(scene({square(5, 5), square(40, 5)}, {black, black}));
  EXPECT_EQ(none.quality, 1);
  EXPECT_EQ(none.message, "there is no shadow that could follow");
}

TEST(Follows, AChangedSceneIsComparedWithTheOneItIsLike) {
  const SceneEvidence base = scene({square(5, 5)}, {square(5, 5)});
  const SceneEvidence right = scene({square(40, 30)}, {square(41, 30)}, "base");
  EXPECT_EQ(judged(right, &base).quality, 1);
  const SceneEvidence still = scene({square(40, 30)}, {square(5, 5)}, "base");
  EXPECT_EQ(judged(still, &base).quality, 0);
  EXPECT_EQ(judged(still, &base).message, "0% of the shadow changed place, 100% in the reference");
  EXPECT_EQ(judged(still).quality, 1); // the base never came
}

TEST(Follows, AnotherWindowShowsTheSame) {
  const SceneEvidence base = scene({square(30, 20)}, {square(30, 20)});
  // Twice the height: all is twice as large about the middle of the width.
  const SceneEvidence twice =
      scene({square(60, 40, 160, 120, 40)}, {square(60, 40, 160, 120, 40)}, "base");
  EXPECT_EQ(judged(twice, &base).quality, 1);
  const SceneEvidence pixels =
      scene({square(60, 40, 160, 120, 40)}, {square(30, 20, 160, 120, 20)}, "base");
  EXPECT_EQ(judged(pixels, &base).quality, 0);
  EXPECT_THAT(judged(pixels, &base).message,
              HasSubstr("the window became 160x120 instead of 80x60: 100% of the shadow changed"));
  // Wider: more to see on both sides.
  const SceneEvidence wider = scene({square(40, 20, 100)}, {square(40, 20, 100)}, "base");
  EXPECT_EQ(judged(wider, &base).quality, 1);
  const SceneEvidence stretched = scene({square(40, 20, 100)}, {square(55, 20, 100)}, "base");
  EXPECT_LT(judged(stretched, &base).quality, 0.1);
}

TEST(Follows, ThroughAWindowOfAnotherShape) {
  Mask mask(4, 2);
  mask.set(1, 0);
  Mask seen;
  const Mask wide = throughWindow(mask, 6, 2, seen);
  EXPECT_EQ(seen.count(), 8u); // a column on each side is new
  EXPECT_FALSE(seen.at(0, 0) || seen.at(5, 1));
  EXPECT_TRUE(wide.at(2, 0));
  EXPECT_EQ(wide.count(), 1u);
  const Mask twice = throughWindow(mask, 8, 4, seen);
  EXPECT_EQ(seen.count(), 32u);
  EXPECT_EQ(twice.count(), 4u);
  EXPECT_TRUE(twice.at(2, 0) && twice.at(3, 1));
  const Mask narrow = throughWindow(mask, 2, 2, seen);
  EXPECT_EQ(seen.count(), 4u);
  EXPECT_TRUE(narrow.at(0, 0));
}

} // namespace
