// Part "bloom": what the ends are worth, what faults cost and where they are named, and other ways
// that lose nothing.

#include "tool.hpp"

#include <gmock/gmock.h>

using namespace tool;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

namespace {

Graded gradeBloom(const Submission& submission) {
  return gradePart("bloom", submission);
}

void expectEverything(const Submission& submission) {
  const Graded graded = gradeBloom(submission);
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.score(), 100);
  EXPECT_THAT(graded.lost(), IsEmpty());
}

TEST(Bloom, TheReferenceHasEverythingAndTheStubNothing) {
  const Graded reference = gradePart("bloom", kSource / "solutions/floor", {"--solution"});
  EXPECT_EQ(reference.outcome(), "graded");
  EXPECT_EQ(reference.score(), 100);
  const Graded stub = gradePart("bloom", kSource / "assignments/floor");
  EXPECT_EQ(stub.outcome(), "graded");
  EXPECT_EQ(stub.results.at("score"), 0);
  EXPECT_EQ(stub.earned("bloom.keep_picture"), 0);
}

TEST(Bloom, AWrongBrightPassIsNamedAndTheLevelsKeepTheirPoints) {
  const Graded graded = gradeBloom(Submission::example("threshold_subtracted"));
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.earned("bloom.scene"), 10);
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
  EXPECT_EQ(graded.earned("bloom.bright"), 25);
  EXPECT_THAT(graded.message("bloom.levels"),
              HasSubstr("bloom level 3: 2.0x too bright everywhere; earlier levels match"));
  // Later levels are right for what they were given: one of three to five levels is lost.
  EXPECT_GE(graded.earned("bloom.levels"), 12);
  EXPECT_LT(graded.earned("bloom.levels"), 20);
}

TEST(Bloom, EightBitsMakeTheSceneTheFirstWrongPass) {
  const Graded graded = gradeBloom(Submission::example("eight_bits"));
  EXPECT_EQ(graded.earned("bloom.scene"), 0);
  EXPECT_THAT(graded.message("bloom.scene"), HasSubstr("kept in RGBA8, which ends at 1"));
  EXPECT_THAT(graded.message("bloom.bright"), HasSubstr("the first wrong pass is the scene"));
  EXPECT_EQ(graded.earned("bloom.picture"), 0);
  // The levels' and the sum's, judged with the reference's bright pass.
  EXPECT_EQ(graded.score(), 35);
}

TEST(Bloom, BlendingOffKeepsTheWayDown) {
  const Graded graded = gradeBloom(Submission::example("blending_off"));
  EXPECT_EQ(graded.earned("bloom.bright"), 25);
  EXPECT_EQ(graded.earned("bloom.levels"), 20);
  EXPECT_LT(graded.earned("bloom.sum"), 6);
  EXPECT_LT(graded.earned("bloom.picture"), 10);
}

TEST(Bloom, NegativeLightIsNotLight) {
  const Graded graded = gradeBloom(std::move(Submission::solution().replace(
      "bright.frag", "max(brightness - uThreshold, 0.0)", "(brightness - uThreshold)")));
  EXPECT_EQ(graded.earned("bloom.bright"), 0);
  EXPECT_EQ(graded.earned("bloom.picture"), 0);
}

TEST(Bloom, AddedAfterTheEncodingCostsThePictureOnly) {
  Submission late = Submission::solution();
  late.replace("composite.frag", "  if (uGlows) light += upsample(uBloom, uSize, uFilter);\n", "");
  late.replace("composite.frag", "vec4(display(light), 1)",
               "vec4(display(light) + (uGlows ? upsample(uBloom, uSize, uFilter) : vec3(0)), 1)");
  const Graded graded = gradeBloom(late);
  EXPECT_EQ(graded.earned("bloom.sum"), 15);
  EXPECT_LT(graded.earned("bloom.picture"), 10);
}

TEST(Bloom, ALevelOfSizeZeroFailsInATinyWindowOnly) {
  const Graded graded = gradeBloom(std::move(Submission::solution().replace(
      "bloom.hpp", "size = glm::max(size / 2, glm::ivec2(1));", "size = size / 2;")));
  EXPECT_THAT(graded.lost(), testing::UnorderedElementsAre("bloom.tiny"));
  EXPECT_EQ(graded.score(), 90);
}

TEST(Bloom, ADepthTestLeftOffHarmsTheNextFrame) {
  const Graded graded = gradeBloom(std::move(Submission::solution().replace(
      "floor.cpp", "      glEnable(GL_DEPTH_TEST);\n    }\n", "    }\n")));
  EXPECT_LT(graded.earned("bloom.keep_state"), 0);
}

TEST(BloomAlternative, DividedByTheNumberOfLevelsAtTheEnd) {
  // As the lecture does.
  Submission other = Submission::solution();
  other.replace("bright.frag", "bright = color * ratio * uWeight;", "bright = color * ratio;");
  other.replace("composite.frag", "uniform bool uGlows; ",
                "uniform float uLevels;\nuniform bool uGlows; ");
  other.replace("composite.frag", "light += upsample(uBloom, uSize, uFilter);",
                "light += upsample(uBloom, uSize, uFilter) / uLevels;");
  other.replace("bloom.hpp", "  bloom.composite.set(\"uGlows\", glows);\n",
                "  bloom.composite.set(\"uGlows\", glows);\n  bloom.composite.set(\"uLevels\", "
                "float(bloom.levels.size()));\n");
  expectEverything(other);
}

class Filter : public testing::TestWithParam<const char*> {};

TEST_P(Filter, LosesNothing) {
  Submission other = Submission::solution();
  other.replace("floor.cpp", "scene.integer(\"quality.bloom_filter\")", GetParam());
  other.replace("floor.cpp", "scene.integer(\"quality.bloom_edge\") == 0", "true");
  expectEverything(other);
}

INSTANTIATE_TEST_SUITE_P(BloomAlternative, Filter, testing::Values("0", "1", "2", "3"));

TEST(BloomAlternative, FourVerticesInPlaceOfOneTriangle) {
  Submission other = Submission::solution();
  other.replace("screen.vert", "  gl_Position = vec4(4.0 * corner - 1.0, 0, 1);",
                "  gl_Position = vec4(2.0 * corner - 1.0, 0, 1);");
  other.replace("bloom.hpp", "glDrawArrays(GL_TRIANGLES, 0, 3);",
                "glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);");
  // A strip's second triangle is drawn as (1,0) (0,1) (1,1).
  expectEverything(other);
}

TEST(BloomAlternative, OneFramebufferForAllLevels) {
  Submission other = Submission::solution();
  std::string text = read(other.path() / "bloom.hpp");
  const std::string bind = "glBindFramebuffer(GL_FRAMEBUFFER, level.framebuffer);\n";
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(bind, at)) != text.npos; ++count) {
    const std::string change = "glBindFramebuffer(GL_FRAMEBUFFER, bloom.levels[0].framebuffer);\n"
                               "glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, "
                               "GL_TEXTURE_2D, level.color, 0);\n";
    text.replace(at, bind.size(), change);
    at += change.size();
  }
  ASSERT_EQ(count, 4u);
  other.write("bloom.hpp", text);
  expectEverything(other);
}

TEST(BloomAlternative, MoreBitsThanNeeded) {
  expectEverything(std::move(Submission::solution().replace(
      "bloom.hpp", "return formats[scene.integer(\"quality.bloom_format\")];",
      "return formats[3];")));
}

TEST(BloomAlternative, ADepthTextureForTheScene) {
  Submission other = Submission::solution();
  other.replace("bloom.hpp", "  gg::Renderbuffer depth;\n", "  gg::Texture depth;\n");
  other.replace("bloom.hpp",
                "  glBindRenderbuffer(GL_RENDERBUFFER, bloom.depth);\n"
                "  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size.x, size.y);\n",
                "  glBindTexture(GL_TEXTURE_2D, bloom.depth);\n"
                "  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, size.x, size.y, 0, "
                "GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);\n");
  other.replace("bloom.hpp",
                "  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, "
                "bloom.depth);\n",
                "  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, "
                "bloom.depth, 0);\n");
  expectEverything(other);
}

} // namespace
