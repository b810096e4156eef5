#include "diagnosis/outcome.hpp"

#include <gmock/gmock.h>

using namespace ggrade;
using namespace ggrade::diagnosis;
using results::Outcome;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

namespace {

results::Result ended(Outcome outcome, const std::string& compiler = "") {
  results::Result result;
  result.outcome = outcome;
  result.compilerOutput = compiler;
  return result;
}

const char* const kComment = "floor.cpp:280:5: warning: multi-line comment [-Wcomment]\n"
                             "  280 |     // show it now \\\n"
                             "      |     ^\n";

TEST(DiagnosisOutcome, NeverSwappedWithTheCompilersWarningBesideIt) {
  const auto found = outcomeDiagnosis(ended(Outcome::noFrame, kComment), {});
  ASSERT_TRUE(found);
  EXPECT_THAT(found->text, HasSubstr("window.swapBuffers() is not reached"));
  EXPECT_THAT(found->text, HasSubstr("a comment swallows the line after it"));
  ASSERT_EQ(found->beside.size(), 1u);
  EXPECT_THAT(found->beside[0],
              HasSubstr("floor.cpp:280:5: warning: multi-line comment [-Wcomment]: a comment that "
                        "ends in a backslash goes on in the next line"));
  EXPECT_EQ(found->id, "no_frame");
  EXPECT_EQ(found->confidence, 1);
  const auto other = outcomeDiagnosis(ended(Outcome::noFrame), {});
  ASSERT_TRUE(other);
  EXPECT_THAT(other->text, HasSubstr("ends or skips the loop"));
  EXPECT_THAT(other->beside, IsEmpty());
}

TEST(DiagnosisOutcome, NothingReachesTheWindow) {
  const auto bound = outcomeDiagnosis(ended(Outcome::graded), {{{0, 3}, {0, 3}}, {}});
  ASSERT_TRUE(bound);
  EXPECT_EQ(bound->id, "framebuffer_left_bound");
  EXPECT_THAT(bound->text, HasSubstr("framebuffer object 3 is still bound"));
  const auto nothing = outcomeDiagnosis(ended(Outcome::graded), {{{0, 0}, {0, 3}}, {}});
  ASSERT_TRUE(nothing);
  EXPECT_EQ(nothing->id, "nothing_drawn_to_the_window");
  // In a single frame it can be what the scene wants; a framebuffer may be bound after all drawing.
  EXPECT_FALSE(outcomeDiagnosis(ended(Outcome::graded), {{{5, 0}, {0, 3}}, {}}));
  EXPECT_FALSE(outcomeDiagnosis(ended(Outcome::graded), {{{5, 3}, {5, 3}}, {}}));
  EXPECT_FALSE(outcomeDiagnosis(ended(Outcome::graded), {}));
}

TEST(DiagnosisOutcome, WhatAProgramThrowsIsNoWildPointer) {
  const auto crashed = outcomeDiagnosis(ended(Outcome::crash), {{}, {}, false});
  ASSERT_TRUE(crashed);
  EXPECT_THAT(crashed->text, HasSubstr("a pointer"));
  const auto thrown = outcomeDiagnosis(ended(Outcome::crash), {{}, {}, true});
  ASSERT_TRUE(thrown);
  EXPECT_THAT(thrown->text, StartsWith("The program ends itself"));
  EXPECT_THAT(thrown->text, Not(HasSubstr("pointer")));
}

TEST(DiagnosisOutcome, AnIncompleteFramebufferIsNamed) {
  const auto found =
      outcomeDiagnosis(ended(Outcome::glError), {{{5, 0}}, {"FRAMEBUFFER_INCOMPLETE_ATTACHMENT"}});
  ASSERT_TRUE(found);
  EXPECT_THAT(found->text, HasSubstr("FRAMEBUFFER_INCOMPLETE_ATTACHMENT"));
}

TEST(DiagnosisOutcome, GlErrorsBringThePublicScenesFirstMessage) {
  results::Result result = ended(Outcome::glError);
  results::Scene hidden, shown;
  hidden.messages = {"frame 1: secret"};
  shown.isPublic = true;
  shown.messages = {"frame 1: GL_INVALID_ENUM in glBindTexture"};
  result.scenes = {hidden, shown};
  const auto found = outcomeDiagnosis(result, {{{5, 0}}, {}});
  ASSERT_TRUE(found);
  EXPECT_THAT(found->beside, ElementsAre("frame 1: GL_INVALID_ENUM in glBindTexture"));
}

TEST(DiagnosisOutcome, OursIsNotTheStudents) {
  EXPECT_FALSE(outcomeDiagnosis(ended(Outcome::notGradable, kComment), {}));
}

TEST(DiagnosisOutcome, WarningsThatTellMostComeFirst) {
  const std::string output = "a.cpp:1:1: warning: unused variable 'x' [-Wunused-variable]\n"
                             "a.cpp:2:1: note: something\n"
                             "a.cpp:3:1: warning: ISO C++ forbids [-Wpedantic]\n" +
                             std::string(kComment);
  const auto found = tellingWarnings(output);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_THAT(found[0], HasSubstr("-Wcomment"));
  EXPECT_THAT(found[1], HasSubstr("-Wunused-variable"));
  EXPECT_EQ(tellingWarnings(output, 1).size(), 1u);
}

} // namespace
