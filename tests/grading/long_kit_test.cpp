// The kit of everything, and one that is built with nothing at hand; what `check` says of every
// right answer. See kit_release_test.cpp and kit_check_test.cpp.

#include "kit.hpp"

#include "grading/catalogue.hpp"

#include <gmock/gmock.h>

using namespace tool;
using nlohmann::json;

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

TEST(LongCheck, IsSilentOnEveryRightAnswer) {
  const TemporaryFolder folder;
  const Ended made = runTool({"expect", "mirror", "--out", folder.path()}, {}, 900);
  ASSERT_EQ(made.exitCode, 0) << made.errors;
  const fs::path solutions = kSource / "solutions/floor";
  const ggrade::Target target = ggrade::findTarget(kSource / "assignments", "mirror");
  const auto catalogue =
      ggrade::grading::loadCatalogue(target.assignment, target.parts.front(), solutions, solutions);
  int count = 0;
  for (const ggrade::grading::Variant& variant : catalogue.variants) {
    if (!variant.loses.empty()) continue;
    SCOPED_TRACE(variant.name);
    const Submission files = Submission::variant(variant.name);
    const Ended ended =
        Running({kBuild / "bin/ggrade-check", "mirror", "--expected", folder.path(), "--folder",
                 files.path(), "--out", folder.path() / "check.html", "--json"})
            .wait(100);
    ASSERT_NE(ended.out, "") << ended.errors;
    const json part = json::parse(ended.out).at(0);
    EXPECT_EQ(part.at("cause"), "");
    EXPECT_EQ(part.at("messages"), json::array());
    for (const json& todo : part.at("todos")) EXPECT_EQ(todo.at("state"), "done") << todo;
    ++count;
  }
  EXPECT_GE(count, 8);
}

} // namespace
