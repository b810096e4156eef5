// Faulty submissions lose what they should, and the right item says so: more than the catalogue
// says of its mistakes.

#include "tool.hpp"

#include <gmock/gmock.h>

using namespace tool;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

namespace {

TEST(Fault, LightNotMirrored) {
  const Graded graded = gradeMistake("mirror_light_not_mirrored");
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.earned("mirror.shading"), 0);
  // Where the reflection is and whose it is stays right.
  EXPECT_EQ(graded.earned("mirror.where"), 20);
  EXPECT_EQ(graded.earned("mirror.position"), 15);
  EXPECT_EQ(graded.earned("mirror.keep_picture"), 0);
  EXPECT_THAT(graded.message("mirror.shading"), HasSubstr("pixels differ, densest at ("));
  EXPECT_GE(graded.score(), 50);
  EXPECT_LE(graded.score(), 75);
}

TEST(Fault, NoDepthAttachment) {
  const Graded graded = gradeMistake("mirror_no_depth");
  EXPECT_EQ(graded.outcome(), "graded"); // complete without depth: no GL error
  EXPECT_EQ(graded.earned("mirror.hidden"), 0);
  EXPECT_EQ(graded.earned("mirror.where"), 20);
  EXPECT_THAT(graded.message("mirror.hidden"), HasSubstr("another object than the nearest"));
  EXPECT_GE(graded.score(), 50);
  EXPECT_LT(graded.score(), 90);
}

TEST(Fault, ScaleOnTheWrongSideOfTheView) {
  const Graded graded = gradeMistake("mirror_scale_on_the_left");
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_THAT(graded.lost(), Contains("mirror.texture"));
  EXPECT_EQ(graded.earned("mirror.target"), 5);
  EXPECT_EQ(graded.earned("mirror.shading"), 0);
  // What samples the texture is right: it is judged with the reference's in its place.
  EXPECT_EQ(graded.earned("mirror.position"), 15);
  EXPECT_LE(graded.score(), 40);
}

TEST(Fault, CullingLeftTurned) {
  const Graded graded = gradeMistake("mirror_culling_not_restored");
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_LT(graded.earned("mirror.keep_picture"), 0);
  EXPECT_LT(graded.score(), 50);
}

TEST(Fault, FramebufferLeftBoundIsNamed) {
  const Graded graded = gradeMistake("mirror_framebuffer_left_bound");
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.results.at("score"), 0);
  EXPECT_LT(graded.earned("mirror.keep_picture"), 0);
  EXPECT_THAT(graded.detail(), HasSubstr("framebuffer object"));
}

TEST(Fault, AFloorThatReflectsLessHasItsReflectionsWhereTheyMustBe) {
  Submission less = Submission::solution();
  less.replace("tile.frag", "uMaterial.specular.rgb * reflected",
               "0.7 * uMaterial.specular.rgb * reflected");
  const Graded graded = grade(std::move(less));
  EXPECT_GE(graded.earned("mirror.where"), 18);
  EXPECT_LT(graded.earned("mirror.shading"), 10) << "the colours are others";
}

TEST(Fault, NothingClips) {
  // All but the step that is beyond the lecture.
  const Graded graded = gradeMistake("mirror_no_clip");
  EXPECT_THAT(graded.lost(), UnorderedElementsAre("mirror.clip"));
  EXPECT_EQ(graded.score(), 85);
}

TEST(Fault, ClippedOnTheWrongSide) {
  const Graded graded = gradeMistake("mirror_clip_sign");
  EXPECT_EQ(graded.earned("mirror.texture"), 0);
  EXPECT_EQ(graded.earned("mirror.clip"), 0);
  // The pass's 5 and the sampling's, judged with the reference's reflection.
  EXPECT_EQ(graded.score(), 40);
}

TEST(Fault, ClipDistanceLeftEnabled) {
  // Shaders that write no clip distance are undefined then; what the next frame shows counts.
  const Graded graded = grade(std::move(
      Submission::solution().replace("mirror.hpp", "glDisable(GL_CLIP_DISTANCE0);", ";")));
  EXPECT_EQ(graded.outcome(), "graded");
}

TEST(Fault, ViewportKeptFromTheMirrorPass) {
  const Graded graded = gradeMistake("mirror_viewport_not_restored");
  EXPECT_LT(graded.earned("mirror.keep_picture"), 0);
  EXPECT_LT(graded.score(), 30);
}

TEST(Fault, ViewportOfTheWindowInTheMirrorPass) {
  const Graded graded = gradeMistake("mirror_window_viewport_in_fbo");
  EXPECT_EQ(graded.earned("mirror.target"), 0);
  EXPECT_THAT(graded.message("mirror.target"), HasSubstr("drawn with a viewport of 640x480"));
  EXPECT_LT(graded.earned("mirror.texture"), 5);
  EXPECT_EQ(graded.earned("mirror.shading"), 0);
  EXPECT_LT(graded.score(), 40); // the sampling's, judged with the reference's reflection
}

TEST(Fault, DepthNotCleared) {
  // Right in the first frame only.
  const Graded graded = gradeMistake("mirror_depth_not_cleared");
  EXPECT_THAT(graded.lost(), Contains("mirror.hidden"));
  EXPECT_THAT(graded.message("mirror.target"), HasSubstr("depths are not cleared"));
  EXPECT_LT(graded.score(), 70);
}

TEST(Fault, NormalsNotNegated) {
  const Graded graded = gradeMistake("mirror_normal_not_negated");
  EXPECT_EQ(graded.earned("mirror.shading"), 0);
  EXPECT_EQ(graded.earned("mirror.where"), 20);
  EXPECT_EQ(graded.earned("mirror.position"), 15);
  EXPECT_LT(graded.score(), 76);
}

TEST(Fault, UpsideDown) {
  const Graded graded = gradeMistake("mirror_upside_down");
  EXPECT_EQ(graded.earned("mirror.where"), 0);
  EXPECT_EQ(graded.earned("mirror.position"), 0);
  // The texture is right; it is sampled the wrong way round.
  EXPECT_EQ(graded.earned("mirror.texture"), 15);
  EXPECT_LE(graded.score(), 20);
}

TEST(Fault, ConstantsOfThePublicSceneTypedIn) {
  // A viewport of 640x480 in place of the window's: right in public, wrong in hidden scenes.
  const Graded graded = grade(std::move(Submission::solution().replace(
                                  "tile.frag", "    vec2 at = gl_FragCoord.xy / uViewport;\n",
                                  "    vec2 at = gl_FragCoord.xy / vec2(640, 480);\n")),
                              {.pictures = true});
  EXPECT_THAT(graded.lost(), Contains("mirror.where"));
  EXPECT_LT(graded.score(), 60);
  for (const auto& frame : graded.results.at("extra_data").at("scenes").at(0).at("frames"))
    EXPECT_EQ(frame.at("wrong_share"), 0);
}

TEST(Fault, NoBlurCostsTheBonusOnly) {
  const Graded graded = gradeMistake("mirror_no_blur");
  EXPECT_EQ(graded.score(), 100);
  EXPECT_EQ(graded.bonus(), 0);
}

TEST(Fault, AFilterJudgesTheNamedItemsOnly) {
  const Graded graded =
      gradeByTool(Submission::example("no_depth"), {"--", "--gtest_filter=mirror.where"});
  EXPECT_EQ(graded.ended.exitCode, 0);
  EXPECT_EQ(graded.score(), 20);
  for (const auto& item : graded.results.at("extra_data").at("items"))
    EXPECT_EQ(item.at("judged"), item.at("id") == "mirror.where");
}

} // namespace
