// The same submission and the same seed: the same frames, bit for bit, and the same score.

#include "tool.hpp"

#include <gmock/gmock.h>

#include <limits>

using namespace tool;
using ggrade::grading::Quality;
using testing::Each;
using testing::Ne;
using testing::SizeIs;

namespace {

/// The hashes of all frames that were judged, scene by scene.
std::vector<std::string> hashes(const Graded& graded) {
  std::vector<std::string> all;
  for (const auto& scene : graded.results.at("extra_data").at("scenes"))
    for (const auto& frame : scene.at("frames")) all.push_back(frame.at("hash"));
  return all;
}

void expectSame(const Graded& again, const Graded& first) {
  EXPECT_EQ(hashes(again), hashes(first));
  EXPECT_EQ(again.results.at("tests"), first.results.at("tests"));
  EXPECT_EQ(again.results.at("score"), first.results.at("score"));
  EXPECT_EQ(again.results.at("extra_data").at("fingerprint"),
            first.results.at("extra_data").at("fingerprint"));
}

TEST(SameSeed, EveryRunAgreesInEveryBitAndPoint) {
  // A faulty submission: a score between the ends is the one that could waver.
  const Submission submission = Submission::example("light_not_mirrored");
  const How how{.pictures = true, .repair = true};
  const Graded first = grade(submission, how);
  ASSERT_THAT(hashes(first), SizeIs(9));
  EXPECT_THAT(hashes(first), Each(Ne("")));
  EXPECT_GT(first.score(), 0);
  EXPECT_LT(first.score(), 100);
  Grader& grader = Grader::of("mirror");
  expectSame(grader.grade(grader.build(submission.path()), how), first);
  expectSame(gradeByTool(submission), first); // the judge of one grading is another one
}

TEST(SameSeed, AnotherSeedDrawsOtherHiddenScenesAndARegradeIsExact) {
  const Submission submission = Submission::example("light_not_mirrored");
  const Graded usual = grade(submission, {.pictures = true});
  const std::uint64_t seed = std::numeric_limits<std::uint64_t>::max();
  const How how{.pictures = true, .repair = true, .draw = {.seed = seed}};
  const Graded other = grade(submission, how);
  EXPECT_EQ(usual.results.at("extra_data").at("seed"), 1301);
  EXPECT_EQ(other.results.at("extra_data").at("seed"), seed);
  const auto before = hashes(usual), after = hashes(other);
  ASSERT_EQ(before.size(), after.size());
  // The two public frames come first; none of the hidden ones is the same.
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_EQ(before[i] == after[i], i < 2) << "frame " << i;

  expectSame(gradeByTool(submission, {"--seed", std::to_string(seed)}), other);
  const Graded reference = grade(Submission::solution(), {.draw = how.draw});
  EXPECT_EQ(reference.score(), 100);
  EXPECT_EQ(reference.bonus(), 10);
}

TEST(Quality, DecidesHowManyScenesAreDrawn) {
  const Submission submission = Submission::example("light_not_mirrored");
  const auto scenesOf = [](const Graded& graded) {
    return graded.results.at("extra_data").at("scenes").size();
  };
  const std::size_t balanced = scenesOf(grade(submission, {.pictures = true}));
  for (const auto& [quality, scenes] :
       {std::pair(Quality::fast, balanced - 2), std::pair(Quality::thorough, 2 * balanced - 1)}) {
    const std::string name = nameOf(quality);
    const Graded graded = grade(submission, {.pictures = true, .draw = {std::nullopt, quality}});
    EXPECT_EQ(graded.results.at("extra_data").at("quality"), name);
    EXPECT_EQ(scenesOf(graded), scenes) << name;
    EXPECT_GT(graded.score(), 0) << name;
    EXPECT_LT(graded.score(), 80) << name;
    EXPECT_EQ(grade(Submission::solution(), {.draw = {std::nullopt, quality}}).score(), 100)
        << name;
  }
}

} // namespace
