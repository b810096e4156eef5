// Part "bloom": what faults cost beyond what the catalogue says, and where
// they are named.

#include "tool.hpp"

#include <gmock/gmock.h>

using namespace tool;
using testing::HasSubstr;

namespace {

Graded gradeBloom(const Submission& submission) {
  return gradePart("bloom", submission);
}

TEST(Bloom, AWrongBrightPassIsNamedAndTheLevelsKeepTheirPoints) {
  const Graded graded = gradeMistake("bloom_threshold_subtracted");
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.earned("bloom.target"), 4);
  EXPECT_EQ(graded.earned("bloom.scene"), 6);
  EXPECT_EQ(graded.earned("bloom.bright"), 0);
  EXPECT_THAT(graded.message("bloom.bright"), HasSubstr("the first wrong pass is the bright pass"));
  EXPECT_EQ(graded.earned("bloom.levels"), 20);
  EXPECT_EQ(graded.earned("bloom.sum"), 15);
  EXPECT_LT(graded.earned("bloom.picture"), 8);
}

TEST(Bloom, ALevelThatIsTooBrightIsNamedWithItsFactor) {
  const Graded graded = gradeBloom(std::move(Submission::solution().replace(
      "bloom.hpp",
      "    glBindTexture(GL_TEXTURE_2D, bloom.levels[i - 1].color);\n    drawScreen(bloom);\n",
      "    glBindTexture(GL_TEXTURE_2D, bloom.levels[i - 1].color);\n    drawScreen(bloom);\n"
      "    if (i == 3) {\n      glEnable(GL_BLEND);\n      glBlendFunc(GL_ONE, GL_ONE);\n"
      "      drawScreen(bloom);\n      glDisable(GL_BLEND);\n    }\n")));
  EXPECT_EQ(graded.earned("bloom.bright"), 18);
  EXPECT_THAT(graded.message("bloom.levels"),
              HasSubstr("bloom level 3: 2.0x too bright everywhere; earlier levels match"));
  // Later levels are right for what they were given: one of three to five levels is lost.
  EXPECT_GE(graded.earned("bloom.levels"), 12);
  EXPECT_LT(graded.earned("bloom.levels"), 20);
}

TEST(Bloom, EightBitsMakeTheSceneTheFirstWrongPass) {
  const Graded graded = gradeMistake("bloom_scene_rgba8");
  EXPECT_EQ(graded.earned("bloom.scene"), 0);
  EXPECT_THAT(graded.message("bloom.scene"), HasSubstr("kept in RGBA8, which ends at 1"));
  EXPECT_EQ(graded.earned("bloom.target"), 0);
  EXPECT_THAT(graded.message("bloom.target"), HasSubstr("kept in RGBA8, which ends at 1"));
  EXPECT_THAT(graded.message("bloom.bright"), HasSubstr("the first wrong pass is the scene"));
  EXPECT_EQ(graded.earned("bloom.picture"), 0);
  // The levels' and the sum's, judged with the reference's bright pass.
  EXPECT_NEAR(graded.score(), 42.2, 0.01);
}

TEST(Bloom, BlendingOffKeepsTheWayDown) {
  const Graded graded = gradeMistake("bloom_blending_off");
  EXPECT_EQ(graded.earned("bloom.bright"), 18);
  EXPECT_EQ(graded.earned("bloom.levels"), 20);
  EXPECT_LT(graded.earned("bloom.sum"), 6);
  EXPECT_LT(graded.earned("bloom.picture"), 10);
}

TEST(Bloom, NegativeLightIsNotLight) {
  const Graded graded = gradeMistake("bloom_threshold_no_max");
  // In one of two scenes nearly all is brighter than the threshold.
  EXPECT_EQ(graded.earned("bloom.bright"), 9);
  EXPECT_EQ(graded.earned("bloom.picture"), 10);
}

/// A sixth too little light is seen in no pixel; all levels have it, and so has the picture.
TEST(Bloom, AWeightThatIsTypedInIsSeenWithAnotherNumberOfLevels) {
  const Graded graded = gradeBloom(std::move(Submission::solution().replace(
      "bright.frag", "color * ratio * uWeight", "color * ratio / 6")));
  EXPECT_EQ(graded.earned("bloom.bright"), 9);
  EXPECT_THAT(graded.message("bloom.bright"), HasSubstr("too dark everywhere"));
}

TEST(Bloom, AChannelThatTheBrightnessLeavesOutIsMissed) {
  for (const char* two : {"max(color.r, color.b)", "max(color.r, color.g)"}) {
    const Graded graded = gradeBloom(std::move(
        Submission::solution().replace("bright.frag", "max(color.r, max(color.g, color.b))", two)));
    EXPECT_EQ(graded.earned("bloom.bright"), 9) << two;
  }
}

TEST(Bloom, AddedAfterTheEncodingCostsThePictureOnly) {
  const Graded graded = gradeMistake("bloom_added_encoded");
  EXPECT_EQ(graded.earned("bloom.sum"), 15);
  EXPECT_LT(graded.earned("bloom.picture"), 10);
}

TEST(Bloom, ALevelOfSizeZeroFailsInATinyWindowOnly) {
  const Graded graded = gradeMistake("bloom_level_of_size_zero");
  EXPECT_THAT(graded.lost(), testing::UnorderedElementsAre("bloom.tiny"));
  EXPECT_EQ(graded.score(), 90);
}

TEST(Bloom, ADepthTestLeftOffHarmsTheNextFrame) {
  const Graded graded = gradeMistake("bloom_depth_test_not_restored");
  EXPECT_LT(graded.earned("bloom.keep_state"), 0);
}

} // namespace
