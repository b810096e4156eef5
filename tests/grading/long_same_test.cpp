// More runs and more seeds, see grade_same_test.cpp.

#include "tool.hpp"

#include <gmock/gmock.h>

using namespace tool;

namespace {

nlohmann::json frames(const Graded& graded) {
  nlohmann::json all;
  for (const auto& scene : graded.results.at("extra_data").at("scenes"))
    for (const auto& frame : scene.at("frames")) all.push_back(frame.at("hash"));
  return all;
}

TEST(LongSameSeed, TenRunsAgreeInEveryBitAndPoint) {
  const Submission submission = Submission::example("light_not_mirrored");
  const Graded first = gradeByTool(submission);
  for (int run = 1; run < 10; ++run) {
    const Graded again = gradeByTool(submission);
    EXPECT_EQ(frames(again), frames(first)) << "run " << run;
    EXPECT_EQ(again.results.at("tests"), first.results.at("tests")) << "run " << run;
    EXPECT_EQ(again.results.at("score"), first.results.at("score")) << "run " << run;
    EXPECT_EQ(again.results.at("extra_data").at("fingerprint"),
              first.results.at("extra_data").at("fingerprint"));
  }
}

TEST(LongSameSeed, TheReferenceKeepsItsScoreUnderOtherSeeds) {
  for (std::uint64_t seed = 2; seed < 12; ++seed) {
    const Graded reference = grade(Submission::solution(), {.draw = {.seed = seed}});
    EXPECT_EQ(reference.score(), 100) << seed;
    EXPECT_EQ(reference.bonus(), 10) << seed;
  }
}

} // namespace
