// Part "shadow": what faults cost beyond what the catalogue says.

#include "tool.hpp"

#include <gmock/gmock.h>

using namespace tool;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

namespace {

Graded gradeShadow(const Submission& submission) {
  return gradePart("shadow", submission);
}

TEST(Shadow, TheLecturesFiveStepsHaveEverything) {
  const Graded graded = gradeShadow(Submission::firstSteps(4, "shadow"));
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.score(), 100);
  EXPECT_EQ(graded.earned("shadow.pcf"), 0);
  EXPECT_LT(graded.earned("shadow.bias"), 8); // a constant bias
}

TEST(Shadow, ARightMapKeepsItsPointsUnderAnInvertedComparison) {
  const Graded graded = gradeMistake("shadow_comparison_inverted");
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.earned("shadow.map"), 20);
  EXPECT_THAT(graded.message("shadow.map"), HasSubstr("agrees with the objects at 100%"));
  EXPECT_EQ(graded.earned("shadow.floor"), 0);
  EXPECT_EQ(graded.earned("shadow.objects"), 0);
  // A structure earns nothing unless the picture is right.
  EXPECT_EQ(graded.earned("shadow.depth_only"), 0);
  EXPECT_EQ(graded.earned("shadow.keep_picture"), 0);
}

TEST(Shadow, AmbientLightDarkenedCostsItsItemOnly) {
  const Graded graded = gradeMistake("shadow_ambient_darkened");
  EXPECT_THAT(graded.lost(), UnorderedElementsAre("shadow.ambient"));
  EXPECT_EQ(graded.score(), 85);
}

TEST(Shadow, AHighlightInTheShadowCostsTheLightThatMustGo) {
  const Graded graded = gradeMistake("shadow_specular_kept");
  EXPECT_THAT(graded.lost(), UnorderedElementsAre("shadow.ambient"));
  EXPECT_THAT(graded.message("shadow.ambient"), HasSubstr("where a highlight must be in shadow"));
  EXPECT_LE(graded.score(), 92.5); // half of the item at least: not all scenes have one
}

TEST(Shadow, ObjectsUnderTheFloorSpoilThePictureThoughTheyAreSmall) {
  const Graded graded = gradeMistake("shadow_depth_test_left_off");
  EXPECT_LE(graded.earned("shadow.keep_picture"), -24);
  EXPECT_THAT(graded.message("shadow.keep_picture"), HasSubstr("of the objects' pixels"));
}

TEST(Shadow, WhatTheEyeSeesAgreesWithItselfAndIsNoMap) {
  const Graded graded = gradeMistake("shadow_eye_camera");
  EXPECT_EQ(graded.earned("shadow.camera"), 5); // the floor reads the map through the light's
  EXPECT_EQ(graded.earned("shadow.map"), 0);
  EXPECT_THAT(graded.message("shadow.map"), HasSubstr("public: no matrix of the submission fits"));
  EXPECT_EQ(graded.earned("shadow.floor"), 25); // with the reference's map in its place
}

TEST(Shadow, AMapThatIsNeverClearedIsNoMap) {
  const Graded graded = gradeMistake("shadow_not_cleared");
  EXPECT_EQ(graded.earned("shadow.map"), 0);
  EXPECT_EQ(graded.earned("shadow.depth_only"), 0);
  EXPECT_EQ(graded.earned("shadow.camera"), 5);
  // That and the lookup's 70, judged with the reference's map; the shadow doesn't follow the time.
  EXPECT_EQ(graded.earned("shadow.keep_following"), -15);
  EXPECT_EQ(graded.score(), 60);
}

TEST(Shadow, AMapOfTheFirstFrameGoesStale) {
  const Graded graded = gradeMistake("shadow_drawn_once");
  EXPECT_EQ(graded.earned("shadow.map"), 20); // right when it was drawn
  EXPECT_LT(graded.earned("shadow.floor"), 15);
}

TEST(Shadow, NoBiasMakesStripesOnTheObjects) {
  const Graded graded = gradeMistake("shadow_no_bias");
  EXPECT_EQ(graded.earned("shadow.map"), 20);
  EXPECT_EQ(graded.earned("shadow.floor"), 25);
  EXPECT_EQ(graded.earned("shadow.objects"), 0);
}

TEST(Shadow, PointsBehindTheLightMustBeLit) {
  const Graded graded = gradeMistake("shadow_behind_the_light");
  EXPECT_THAT(graded.lost(), UnorderedElementsAre("shadow.outside"));
  EXPECT_EQ(graded.score(), 90);
}

TEST(Shadow, AnotherViewMatrixIsAnotherMap) {
  const Graded graded = gradeMistake("shadow_eye_view");
  EXPECT_LT(graded.earned("shadow.map"), 10);
  EXPECT_EQ(graded.earned("shadow.floor"), 25); // with the reference's map
}

TEST(Shadow, AColourAttachmentCostsTheStructureOnly) {
  Submission coloured = Submission::solution();
  coloured.replace("shadow.hpp", "  gg::Texture depth;\n", "  gg::Texture depth, color;\n");
  coloured.replace("shadow.hpp", "  glDrawBuffer(GL_NONE);\n  glReadBuffer(GL_NONE);\n",
                   "  glBindTexture(GL_TEXTURE_2D, map.color);\n"
                   "  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size, size, 0, GL_RGBA, GL_FLOAT, "
                   "nullptr);\n"
                   "  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, "
                   "map.color, 0);\n");
  const Graded graded = gradeShadow(coloured);
  EXPECT_THAT(graded.lost(), UnorderedElementsAre("shadow.depth_only"));
  EXPECT_THAT(graded.message("shadow.depth_only"), HasSubstr("colour attachment"));
  EXPECT_EQ(graded.score(), 95);
}

TEST(ShadowAlternative, OneMatrixAnObjectUnderAnotherName) {
  // The whole of the light's projection, view and model in one uniform.
  Submission other = Submission::solution();
  other.write("shadow.vert", "#version 410 core\n"
                             "uniform mat4 uProjection, uView, uModel, together;\n"
                             "uniform mat3 uNormal;\nuniform vec3 uGlow;\n"
                             "layout(location = 0) in vec4 aPosition;\n"
                             "void main() { gl_Position = together * uModel * aPosition; }\n");
  other.replace("shadow.hpp", "{\"object.vert\", \"shadow.frag\"}",
                "{\"shadow.vert\", \"shadow.frag\"}");
  other.replace("shadow.hpp", "  map.program.use();\n",
                "  map.program.use();\n"
                "  map.program.set(\"together\", camera.projection * camera.view);\n");
  const Graded graded = gradeShadow(other);
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.score(), 100);
  EXPECT_THAT(graded.lost(), IsEmpty());
}

} // namespace
