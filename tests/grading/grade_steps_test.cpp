// A student's way through the handout: every program with the first k TODOs filled in.

#include "tool.hpp"

#include "grading/program.hpp"
#include "image/compare.hpp"
#include "image/png.hpp"

#include <gmock/gmock.h>

using namespace tool;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

namespace {

/// A function, because kSource is initialised elsewhere.
fs::path assignmentFolder() {
  return kSource / "assignments/floor";
}

/// What a student has after each step of a part.
struct Way {
  const char* part;
  std::vector<double> scores; ///< after 0, 1, 2, ... steps
  double bonus;               ///< after all of them
  std::vector<int> unseen;    ///< steps that change nothing in the window
};

std::ostream& operator<<(std::ostream& out, const Way& way) {
  return out << way.part;
}

class Step : public testing::TestWithParam<Way> {};

INSTANTIATE_TEST_SUITE_P(
    Every, Step,
    testing::Values(
        // Points come with the steps that the rubric can see: sampling an empty texture is worth
        // nothing, the mirrored objects are, inside out or not. A map that nobody asks is none.
        Way{"mirror", {0, 0, 0, 0, 45, 85, 100, 100}, 10, {1, 2}},
        Way{"shadow", {0, 0, 0, 0, 100, 100, 100}, 20, {1, 2, 3}},
        Way{"bloom", {0, 0, 10, 35, 55, 70, 100}, 0, {1, 3, 4, 5}}),
    [](const auto& way) { return std::string(way.param.part); });

TEST_P(Step, IsGradedWithoutAnErrorAndEarnsWhatItShows) {
  const Way& way = GetParam();
  double bonus = 0;
  for (std::size_t k = 0; k < way.scores.size(); ++k) {
    const Graded graded =
        gradePart(way.part, Submission::firstSteps(static_cast<int>(k), way.part));
    EXPECT_EQ(graded.outcome(), "graded") << k; // neither gl_error nor no_frame
    EXPECT_NEAR(graded.score(), way.scores[k], 0.1) << "step " << k;
    EXPECT_GE(graded.bonus(), bonus) << "step " << k;
    bonus = graded.bonus();
  }
  EXPECT_EQ(bonus, way.bonus);
}

std::string pictureName(const std::string& part, std::size_t k, const char* more = "") {
  return "handout/" + part + "-" + std::to_string(k) + more + ".png";
}

TEST_P(Step, ShowsInTheWindowOrInAPassWhatTheHandoutSays) {
  const Way& way = GetParam();
  for (std::size_t k = 1; k < way.scores.size(); ++k) {
    const ggrade::Comparison comparison =
        ggrade::compare(ggrade::readPng(assignmentFolder() / pictureName(way.part, k)),
                        ggrade::readPng(assignmentFolder() / pictureName(way.part, k - 1)));
    ASSERT_TRUE(comparison.compared()) << comparison.message;
    // Making a framebuffer object changes nothing, nor does what nobody reads yet.
    if (testing::Value(static_cast<int>(k), testing::AnyOfArray(way.unseen)))
      EXPECT_EQ(comparison.wrongPixels, 0u) << k;
    else
      EXPECT_GT(comparison.wrongShare, 0.005) << k;
  }
}

TEST_P(Step, CompilesWithoutAWarning) {
  const Way& way = GetParam();
  for (std::size_t k = 0; k < way.scores.size(); ++k) {
    const Submission made = Submission::firstSteps(static_cast<int>(k), way.part);
    const ggrade::grading::Happened built =
        ggrade::grading::buildProgram("floor", made.path(), ggrade::sandbox::Isolation::none);
    EXPECT_TRUE(built.ok()) << k;
    EXPECT_EQ(built.output, "") << k;
  }
}

/// What `derive` makes of an assignment's solution is what is handed out.
void expectInStep(const ggrade::Assignment& assignment) {
  const TemporaryFolder made;
  // A program is built for every picture.
  const Ended ended = runTool({"derive", assignment.id, "--out", made.path()}, {}, 400);
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  for (const std::string& name : names(made.path()))
    if (name != "handout") {
      EXPECT_EQ(read(made.path() / name), read(assignment.folder / name)) << name;
    }
  EXPECT_TRUE(fs::exists(made.path() / "README.md"));
  for (const std::string& name : assignment.files)
    EXPECT_TRUE(fs::exists(made.path() / name)) << name;
  const std::vector<std::string> pictures = names(made.path() / "handout");
  EXPECT_EQ(pictures, names(assignment.folder / "handout"));
  for (const std::string& name : pictures) {
    if (name.ends_with(".svg")) {
      EXPECT_EQ(read(made.path() / "handout" / name), read(assignment.folder / "handout" / name));
      continue;
    }
    const ggrade::Comparison comparison =
        ggrade::compare(ggrade::readPng(made.path() / "handout" / name),
                        ggrade::readPng(assignment.folder / "handout" / name));
    EXPECT_EQ(comparison.wrongPixels, 0u) << name << ": " << comparison.message;
  }
}

TEST(Steps, StubHandoutsAndPicturesAreInStepWithTheSolution) {
  for (const ggrade::Assignment& assignment : ggrade::loadAssignments(kSource / "assignments")) {
    SCOPED_TRACE(assignment.id);
    expectInStep(assignment);
  }
}

TEST(Steps, EveryStepOfTheFloorHasItsTextAndItsPicture) {
  for (const char* name : {"mirror.md", "shadow.md", "bloom.md"})
    EXPECT_TRUE(fs::exists(assignmentFolder() / name)) << name;
  const std::vector<std::string> pictures = names(assignmentFolder() / "handout");
  // A step that shows nothing in the window, but draws, shows its pass.
  for (const char* name : {"mirror-2-pass.png", "shadow-3-pass.png", "bloom-3-pass.png",
                           "bloom-4-pass.png", "bloom-5-pass.png"})
    EXPECT_THAT(pictures, Contains(name));
}

TEST(Steps, NothingOfTheSolutionStandsInTheAssignment) {
  for (const ggrade::Assignment& assignment : ggrade::loadAssignments(kSource / "assignments")) {
    SCOPED_TRACE(assignment.id);
    EXPECT_GE(expectNoSolutionIn(assignment, assignment.folder),
              assignment.id == "floor" ? 7 + 6 + 6 : 1);
  }
}

} // namespace
