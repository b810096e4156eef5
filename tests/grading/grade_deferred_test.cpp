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
  EXPECT_LT(graded.earned("targets.once"), 0.4 * 15);
  EXPECT_EQ(graded.earned("targets.compose"), 25);
  EXPECT_EQ(graded.earned("targets.edges"), 20);
}

TEST(Deferred, HighlightsAreSmallButWorthMostOfTheSum) {
  const Graded graded =
      gradePart("targets", targets("compose.frag",
                                   "  if (uHasSpecular) light += texture(uSpecular, at).rgb;\n", "")
                               .path());
  EXPECT_LT(graded.earned("targets.compose"), 0.4 * 25);
}

} // namespace
