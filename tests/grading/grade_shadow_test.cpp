// Part "shadow": what the ends are worth, what faults cost, and other ways that lose nothing.

#include "tool.hpp"

#include <gmock/gmock.h>

using namespace tool;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

namespace {

Graded gradeShadow(const Submission& submission) {
  return gradePart("shadow", submission);
}

void expectEverything(const Submission& submission) {
  const Graded graded = gradeShadow(submission);
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.score(), 100);
  EXPECT_THAT(graded.lost(), IsEmpty());
}

TEST(Shadow, TheReferenceHasEverythingAndTheStubNothing) {
  const Graded reference = gradePart("shadow", kSource / "solutions/floor", {"--solution"});
  EXPECT_EQ(reference.outcome(), "graded");
  EXPECT_EQ(reference.score(), 100);
  EXPECT_EQ(reference.bonus(), 20);
  const Graded stub = gradePart("shadow", kSource / "assignments/floor");
  EXPECT_EQ(stub.outcome(), "graded");
  EXPECT_EQ(stub.results.at("score"), 0);
  EXPECT_EQ(stub.earned("shadow.keep_picture"), 0);
}

TEST(Shadow, TheLecturesFiveStepsHaveEverything) {
  const Graded graded = gradeShadow(Submission::firstSteps(4, "shadow"));
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.score(), 100);
  EXPECT_EQ(graded.earned("shadow.pcf"), 0);
  EXPECT_LT(graded.earned("shadow.bias"), 8); // a constant bias
}

TEST(Shadow, ARightMapKeepsItsPointsUnderAnInvertedComparison) {
  const Graded graded = gradeShadow(Submission::example("comparison_inverted"));
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.earned("shadow.map"), 25);
  EXPECT_THAT(graded.message("shadow.map"), HasSubstr("agrees with the objects at 100%"));
  EXPECT_EQ(graded.earned("shadow.floor"), 0);
  EXPECT_EQ(graded.earned("shadow.objects"), 0);
  // A structure earns nothing unless the picture is right.
  EXPECT_EQ(graded.earned("shadow.depth_only"), 0);
  EXPECT_EQ(graded.earned("shadow.keep_picture"), 0);
}

TEST(Shadow, AmbientLightDarkenedCostsItsItemOnly) {
  const Graded graded = gradeShadow(Submission::example("ambient_darkened"));
  EXPECT_THAT(graded.lost(), UnorderedElementsAre("shadow.ambient"));
  EXPECT_EQ(graded.score(), 85);
}

TEST(Shadow, AHighlightInTheShadowCostsTheLightThatMustGo) {
  const Graded graded = gradeShadow(std::move(
      Submission::solution().replace("tile.frag", "+ visible * lit.specular;", "+ lit.specular;")));
  EXPECT_THAT(graded.lost(), UnorderedElementsAre("shadow.ambient"));
  EXPECT_THAT(graded.message("shadow.ambient"), HasSubstr("where a highlight must be in shadow"));
  EXPECT_EQ(graded.score(), 85);
}

TEST(Shadow, ObjectsUnderTheFloorSpoilThePictureThoughTheyAreSmall) {
  Submission flat = Submission::solution();
  flat.replace("floor.cpp", "      glDisable(GL_POLYGON_OFFSET_FILL);\n",
               "      glDisable(GL_POLYGON_OFFSET_FILL);\n      glDisable(GL_DEPTH_TEST);\n");
  const Graded graded = gradeShadow(flat);
  EXPECT_LE(graded.earned("shadow.keep_picture"), -24);
  EXPECT_THAT(graded.message("shadow.keep_picture"), HasSubstr("of the objects' pixels"));
}

TEST(Shadow, WhatTheEyeSeesAgreesWithItselfAndIsNoMap) {
  const Graded graded = gradeShadow(std::move(Submission::solution().replace(
      "floor.cpp", "drawObjects(shadowMap->program, camera.projection, camera.view,",
      "drawObjects(shadowMap->program, projection, view,")));
  EXPECT_EQ(graded.earned("shadow.map"), 0);
  EXPECT_THAT(graded.message("shadow.map"), HasSubstr("public: no matrix of the submission fits"));
  EXPECT_EQ(graded.earned("shadow.floor"), 25); // with the reference's map in its place
}

TEST(Shadow, AMapThatIsNeverClearedIsNoMap) {
  const Graded graded = gradeShadow(Submission::example("shadow_not_cleared"));
  EXPECT_EQ(graded.earned("shadow.map"), 0);
  EXPECT_EQ(graded.earned("shadow.depth_only"), 0);
  // The lookup's 70, judged with the reference's map; the shadow doesn't follow the time.
  EXPECT_EQ(graded.earned("shadow.keep_following"), -15);
  EXPECT_EQ(graded.score(), 55);
}

TEST(Shadow, AMapOfTheFirstFrameGoesStale) {
  Submission stale = Submission::solution();
  stale.replace(
      "floor.cpp", "    if (shadowMap) {\n      if (shadowMap->size == 0)\n",
      "    camera = lightCamera(glm::vec3(scene.light.position), objectsBox(scene, object));\n"
      "    if (shadowMap && shadowMap->size == 0) {\n      if (shadowMap->size == 0)\n");
  const Graded graded = gradeShadow(stale);
  EXPECT_EQ(graded.earned("shadow.map"), 25); // right when it was drawn
  EXPECT_LT(graded.earned("shadow.floor"), 15);
}

TEST(Shadow, NoBiasMakesStripesOnTheObjects) {
  Submission bare = Submission::firstSteps(4, "shadow");
  bare.replace("shadow.glsl", "float bias = 0.004;", "float bias = 0.0;");
  const Graded graded = gradeShadow(bare);
  EXPECT_EQ(graded.earned("shadow.map"), 25);
  EXPECT_EQ(graded.earned("shadow.floor"), 25);
  EXPECT_EQ(graded.earned("shadow.objects"), 0);
}

TEST(Shadow, PointsBehindTheLightMustBeLit) {
  const Graded graded = gradeShadow(std::move(
      Submission::solution().replace("shadow.glsl", "  if (clip.w <= 0.0) return 1.0;\n", "")));
  EXPECT_THAT(graded.lost(), UnorderedElementsAre("shadow.outside"));
  EXPECT_EQ(graded.score(), 90);
}

TEST(Shadow, AnotherViewMatrixIsAnotherMap) {
  const Graded graded = gradeShadow(std::move(Submission::solution().replace(
      "floor.cpp", "drawObjects(shadowMap->program, camera.projection, camera.view,",
      "drawObjects(shadowMap->program, camera.projection, view,")));
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

class MapSize : public testing::TestWithParam<const char*> {};

TEST_P(MapSize, LosesNothing) {
  expectEverything(std::move(Submission::solution().replace(
      "floor.cpp", "scene.integer(\"quality.shadow_size\"), depthFormat",
      std::string(GetParam()) + ", depthFormat")));
}

INSTANTIATE_TEST_SUITE_P(ShadowAlternative, MapSize, testing::Values("512", "2048"));

TEST(ShadowAlternative, AnotherLightFrustum) {
  Submission other = Submission::solution();
  other.replace("shadow.hpp", "  right = std::min(right, 5.0f) * near;",
                "  right = 1.6f * right * near;");
  other.replace("shadow.hpp", "  top = std::min(top, 5.0f) * near;", "  top = 1.4f * top * near;");
  other.replace("shadow.hpp", "near, 1.01f * far);", "near, 3.0f * far);");
  expectEverything(other);
}

TEST(ShadowAlternative, FloatingPointDepths) {
  expectEverything(std::move(Submission::solution().replace("floor.cpp", "depthFormat(scene));",
                                                            "GL_DEPTH_COMPONENT32F);")));
}

TEST(ShadowAlternative, TheFloorInTheMap) {
  expectEverything(std::move(Submission::solution().replace(
      "floor.cpp", "      // BEGIN SOLUTION(shadow.6)\n      glDisable(GL_POLYGON_OFFSET_FILL);\n",
      "      shadowMap->program.set(\"uModel\", glm::mat4(1));\n      rectangle.draw();\n"
      "      // BEGIN SOLUTION(shadow.6)\n      glDisable(GL_POLYGON_OFFSET_FILL);\n")));
}

TEST(ShadowAlternative, AManualComparison) {
  Submission other = Submission::solution();
  other.replace("shadow.hpp",
                "  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, "
                "GL_COMPARE_REF_TO_TEXTURE);\n  glTexParameteri(GL_TEXTURE_2D, "
                "GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);\n",
                "");
  other.replace("shadow.glsl", "uniform sampler2DShadow uShadowMap;",
                "uniform sampler2D uShadowMap;");
  other.replace(
      "shadow.glsl",
      "        sum += texture(uShadowMap, vec3(at.xy + vec2(x, y) * texel, at.z));\n",
      "        sum += at.z <= texture(uShadowMap, at.xy + vec2(x, y) * texel).r ? 1.0 : 0.0;\n");
  other.replace("shadow.glsl", "  return texture(uShadowMap, at);\n",
                "  return at.z <= texture(uShadowMap, at.xy).r ? 1.0 : 0.0;\n");
  expectEverything(other);
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
  other.replace("floor.cpp", "      shadowMap->program.use();\n",
                "      shadowMap->program.use();\n      shadowMap->program.set(\"together\", "
                "camera.projection * camera.view);\n");
  expectEverything(other);
}

} // namespace
