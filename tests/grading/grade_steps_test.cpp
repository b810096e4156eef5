// A student's way through the handout: every program with the first k TODOs filled in.

#include "tool.hpp"

#include "authoring/solution_blocks.hpp"
#include "image/compare.hpp"
#include "image/png.hpp"

#include <gmock/gmock.h>

#include <sstream>

using namespace tool;
using testing::HasSubstr;
using testing::Not;

namespace {

constexpr int kTodos = 7;

ggrade::Image handoutPicture(const fs::path& folder, int k) {
  return ggrade::readPng(folder / ("handout/mirror-" + std::to_string(k) + ".png"));
}

TEST(Step, EveryStepIsGradedWithoutAnErrorAndLosesNothing) {
  // Points come with the steps that the rubric can see: sampling an empty texture is worth
  // nothing, the mirrored objects are, inside out or not.
  double before = 0, bonus = 0;
  for (int k = 0; k <= kTodos; ++k) {
    const Graded graded = grade(Submission::firstSteps(k));
    EXPECT_EQ(graded.outcome(), "graded") << k; // neither gl_error nor no_frame
    EXPECT_GE(graded.score(), before) << "step " << k;
    EXPECT_GE(graded.bonus(), bonus) << "step " << k;
    if (k <= 3) EXPECT_EQ(graded.score(), 0) << k;
    if (k == 4) EXPECT_GT(graded.score(), 0);
    if (k == 5) EXPECT_EQ(graded.score(), 85);
    if (k >= 6) EXPECT_EQ(graded.score(), 100) << k;
    if (k == 6) EXPECT_EQ(graded.bonus(), 0);
    before = graded.score();
    bonus = graded.bonus();
  }
  EXPECT_EQ(bonus, 10);
}

TEST(Step, StubHandoutAndPicturesAreInStepWithTheSolution) {
  const fs::path committed = kSource / "assignments/floor";
  const TemporaryFolder made;
  const Ended ended = runTool({"derive", "floor", "--out", made.path()});
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  for (const std::string& name : names(made.path()))
    if (name != "handout") EXPECT_EQ(read(made.path() / name), read(committed / name)) << name;
  EXPECT_EQ(names(made.path() / "handout"), names(committed / "handout"));
  ASSERT_TRUE(fs::exists(made.path() / "README.md"));
  ASSERT_TRUE(fs::exists(made.path() / "floor.cpp"));
  for (int k = 0; k <= kTodos; ++k) {
    const ggrade::Comparison comparison =
        ggrade::compare(handoutPicture(made.path(), k), handoutPicture(committed, k));
    EXPECT_EQ(comparison.wrongPixels, 0u) << k << ": " << comparison.message;
  }
}

TEST(Step, PicturesChangeWhereTheHandoutSaysSo) {
  const fs::path folder = kSource / "assignments/floor";
  for (int k = 1; k <= kTodos; ++k) {
    const ggrade::Comparison comparison =
        ggrade::compare(handoutPicture(folder, k), handoutPicture(folder, k - 1));
    ASSERT_TRUE(comparison.compared()) << comparison.message;
    // Making the framebuffer object and drawing nothing into it changes nothing.
    if (k <= 2)
      EXPECT_EQ(comparison.wrongPixels, 0u) << k;
    else
      EXPECT_GT(comparison.wrongShare, 0.005) << k;
  }
}

TEST(Step, NothingOfTheSolutionStandsInTheAssignment) {
  std::string handedOut;
  for (const auto& entry : fs::recursive_directory_iterator(kSource / "assignments"))
    if (entry.is_regular_file() && entry.path().extension() != ".png")
      handedOut += read(entry.path());
  EXPECT_THAT(handedOut, Not(HasSubstr("SOLUTION(")));
  int blocks = 0;
  for (const auto& entry : fs::directory_iterator(kSource / "solutions/floor")) {
    const std::string name = entry.path().filename();
    if (!entry.is_regular_file() || name == "rubric.cpp") continue;
    const std::string text = read(entry.path());
    const std::string around = ggrade::authoring::withFilled(text, name, {});
    for (const std::string& block : ggrade::authoring::blocks(text, name)) {
      ++blocks;
      EXPECT_EQ(handedOut.find(block), handedOut.npos) << name << ":\n" << block;
      std::istringstream in(block);
      for (std::string line; std::getline(in, line);) {
        line.erase(0, line.find_first_not_of(' '));
        // Shorter ones are no secret, nor what stands outside of blocks, too.
        if (line.size() < 30 || around.find(line) != around.npos) continue;
        EXPECT_EQ(handedOut.find(line), handedOut.npos) << name << ": " << line;
      }
    }
  }
  EXPECT_GE(blocks, kTodos);
}

} // namespace
