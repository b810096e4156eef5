// The same submission and the same seed: the same frames, bit for bit, and the same score.

#include "tool.hpp"

#include <gmock/gmock.h>

#include <set>

using namespace tool;
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

TEST(SameSeed, TenRunsAgreeInEveryBitAndPoint) {
  // A faulty submission: a score between the ends is the one that could waver.
  const Submission submission = Submission::example("light_not_mirrored");
  const Graded first = grade(submission);
  ASSERT_THAT(hashes(first), SizeIs(9));
  EXPECT_THAT(hashes(first), Each(Ne("")));
  EXPECT_GT(first.score(), 0);
  EXPECT_LT(first.score(), 100);
  for (int run = 1; run < 10; ++run) {
    const Graded again = grade(submission);
    EXPECT_EQ(hashes(again), hashes(first)) << "run " << run;
    EXPECT_EQ(again.results.at("tests"), first.results.at("tests")) << "run " << run;
    EXPECT_EQ(again.results.at("score"), first.results.at("score")) << "run " << run;
    EXPECT_EQ(again.results.at("extra_data").at("fingerprint"),
              first.results.at("extra_data").at("fingerprint"));
  }
}

TEST(SameSeed, AnotherSeedDrawsOtherHiddenScenesAndARegradeIsExact) {
  const Submission submission = Submission::example("light_not_mirrored");
  const Graded usual = grade(submission);
  const Graded other = grade(submission, {"--seed", "7"});
  EXPECT_EQ(usual.results.at("extra_data").at("seed"), 1301);
  EXPECT_EQ(other.results.at("extra_data").at("seed"), 7);
  const auto before = hashes(usual), after = hashes(other);
  ASSERT_EQ(before.size(), after.size());
  // The two public frames come first; none of the hidden ones is the same.
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_EQ(before[i] == after[i], i < 2) << "frame " << i;

  const auto seed = other.results.at("extra_data").at("seed").get<std::uint64_t>();
  const Graded again = grade(submission, {"--seed", std::to_string(seed)});
  EXPECT_EQ(hashes(again), after);
  EXPECT_EQ(again.results.at("tests"), other.results.at("tests"));
  EXPECT_EQ(again.results.at("score"), other.results.at("score"));
}

TEST(SameSeed, TheReferenceKeepsItsScoreUnderOtherSeeds) {
  for (const char* seed : {"2", "18446744073709551615"}) {
    const Graded reference = grade(Submission::solution(), {"--seed", seed});
    EXPECT_EQ(reference.score(), 100) << seed;
    EXPECT_EQ(reference.bonus(), 10) << seed;
  }
}

TEST(Quality, DecidesHowManyScenesAreDrawn) {
  const Submission submission = Submission::example("light_not_mirrored");
  const std::size_t balanced = grade(submission).results.at("extra_data").at("scenes").size();
  for (const auto& [quality, scenes] :
       {std::pair("fast", balanced - 2), std::pair("thorough", 2 * balanced - 1)}) {
    const Graded graded = grade(submission, {"--quality", quality, "--no-diagnosis"});
    const auto& extra = graded.results.at("extra_data");
    EXPECT_EQ(extra.at("quality"), quality);
    EXPECT_EQ(extra.at("scenes").size(), scenes) << quality;
    EXPECT_GT(graded.score(), 0) << quality;
    EXPECT_LT(graded.score(), 80) << quality;
    EXPECT_EQ(grade(Submission::solution(), {"--quality", quality, "--no-diagnosis"}).score(), 100)
        << quality;
  }
}

} // namespace
