// The kit of everything, and one that is built with nothing at hand. See kit_release_test.cpp.

#include "kit.hpp"

#include <gmock/gmock.h>

using namespace tool;

namespace {

TEST(LongKit, HoldsNoSolutionAndKnowsEveryStep) {
  const TemporaryFolder folder;
  const fs::path kit = folder.path() / "kit";
  const Ended ended = runTool({"release", "--out", kit}, {}, 1700);
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  expectKit(kit, ended, ggrade::loadAssignments(kSource / "assignments"));
}

TEST(LongKit, BuildsAndChecksOnItsOwn) {
  const TemporaryFolder folder;
  const fs::path kit = folder.path() / "kit";
  ASSERT_EQ(runTool({"release", "--parts", "ssao", "--out", kit}, {}, 600).exitCode, 0);
  expectThatItChecks(kit, {});
}

} // namespace
