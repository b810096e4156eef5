// What is special about grading the parts of "deferred".

#include "tool.hpp"

#include <gmock/gmock.h>

using namespace tool;

namespace {

Submission targets(const std::string& file, const std::string& from, const std::string& to) {
  Submission submission = Submission::firstSteps(4, "targets");
  submission.replace(file, from, to);
  return submission;
}

TEST(Deferred, WhatIsAttachedButNoDrawBufferCostsTheLaterItemsNothing) {
  const Graded graded = gradePart(
      "targets", targets("targets.hpp", "  glDrawBuffers(3, buffers.data());\n", "").path());
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_LT(graded.earned("targets.kinds"), 0.4 * 20);
  EXPECT_LT(graded.earned("targets.once"), 0.4 * 10);
  EXPECT_EQ(graded.earned("targets.compose"), 25);
  EXPECT_EQ(graded.earned("targets.edges"), 20);
}

TEST(Deferred, HighlightsAreSmallButWorthMostOfTheSum) {
  const Graded graded =
      gradePart("targets", targets("compose.frag",
                                   "  if (uHasSpecular) light += texture(uSpecular, at).rgb;\n", "")
                               .path());
  EXPECT_LT(graded.earned("targets.compose"), 0.7 * 25);
}

/// As handouts once asked for it: all irradiance is occluded, and what a surface mirrors it
/// scatters, too.
TEST(Deferred, AnUploadByTheEarlierFormulaLosesNothing) {
  Submission submission = Submission::firstSteps(6, "figure");
  submission.replace("occluded.frag", "mix(fromSun(irradiance), irradiance, meanOpen())",
                     "meanOpen() * irradiance");
  submission.replace("composition.frag", "light += scattered();",
                     "light += texelFetch(uDiffuse, here(), 0).rgb;");
  const Graded graded = gradePart("figure", submission.path());
  EXPECT_EQ(graded.score(), 100) << graded.text();
}

/// What the first steps earn of one item.
double earned(const std::string& part, int steps, const std::string& item) {
  return gradePart(part, Submission::firstSteps(steps, part).path()).earned(item);
}

TEST(Deferred, DrawingThroughATextureIsWorthSomethingByItself) {
  EXPECT_EQ(earned("targets", 1, "targets.through"), 0);
  EXPECT_EQ(earned("targets", 2, "targets.through"), 10);
}

TEST(Deferred, AGBufferIsWorthSomethingByItself) {
  EXPECT_EQ(earned("figure", 0, "figure.albedo"), 0);
  EXPECT_EQ(earned("figure", 1, "figure.albedo"), 10);
}

TEST(Deferred, ATextureThatNeverComesToTheWindowIsNotThrough) {
  Submission submission = Submission::firstSteps(4, "targets");
  submission.replace("targets.hpp", "  glDrawArrays(GL_TRIANGLES, 0, 3);\n", "");
  EXPECT_EQ(gradePart("targets", submission.path()).earned("targets.through"), 0);
}

} // namespace
