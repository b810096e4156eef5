// Which of two things is told of a submission: what was observed, or what it looks like.

#include "grading/diagnose.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

using namespace ggrade;
using grading::Diagnoser;
using grading::Graded;

namespace {

/// One that lost its points while OpenGL reported errors.
Graded withErrors() {
  Graded graded;
  graded.result.outcome = results::Outcome::glError;
  results::Item item;
  item.id = "mirror.where";
  item.step = "Step 3";
  item.points = 20;
  item.judged = true;
  graded.result.items = {item};
  graded.facts.frames = {{5, 0}};
  return graded;
}

std::vector<results::Diagnosis> told(const Graded& graded) {
  Target target;
  target.parts.emplace_back().id = "mirror";
  return grading::diagnosesOf(
      target, graded,
      [](const Part&) -> Diagnoser& { throw std::runtime_error("resemblances are asked for"); },
      [](const auto&, const auto&) { return false; });
}

TEST(Diagnose, WhatWasObservedGoesBeforeAResemblance) {
  Graded graded = withErrors();
  graded.facts.incomplete = {"FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT"};
  const std::vector<results::Diagnosis> diagnoses = told(graded);
  ASSERT_EQ(diagnoses.size(), 1U);
  EXPECT_EQ(diagnoses[0].id, "framebuffer_incomplete");
  EXPECT_EQ(diagnoses[0].part, "mirror");
  EXPECT_EQ(diagnoses[0].step, "Step 3");
  EXPECT_EQ(diagnoses[0].confidence, 1);
}

TEST(Diagnose, ThatThereAreErrorsSaysLessThanAResemblance) {
  EXPECT_THAT([] { told(withErrors()); },
              testing::ThrowsMessage<std::runtime_error>("resemblances are asked for"));
}

} // namespace
