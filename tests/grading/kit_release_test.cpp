// `ggrade release`, and the kit that it makes.

#include "tool.hpp"

#include <gmock/gmock.h>

#include <fstream>

using namespace tool;
using nlohmann::json;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

namespace {

/// The states of a part's TODOs, as ggrade-check sees the files in `folder`; `said` becomes all
/// that it says.
std::vector<std::string> statesOf(const std::string& part, const fs::path& expected,
                                  const fs::path& folder, std::string* said = nullptr) {
  const TemporaryFolder out;
  const Ended ended = Running({kBuild / "bin/ggrade-check", part, "--expected", expected,
                               "--folder", folder, "--out", out.path() / "a.html", "--json"})
                          .wait(100);
  EXPECT_THAT(ended.exitCode, testing::AnyOf(0, 1)) << ended.errors;
  if (said) *said = ended.out;
  std::vector<std::string> states;
  const json all = json::parse(ended.out);
  for (const json& todo : all.at(0).at("todos")) states.push_back(todo.at("state"));
  return states;
}

/// Each step's program: exactly the first k TODOs are done, nothing else is begun.
void expectEveryStepKnown(const ggrade::Part& part, const fs::path& expected) {
  for (std::size_t k = 0; k <= part.todos.size(); ++k) {
    const TemporaryFolder step;
    const Ended ended =
        runTool({"derive", part.id, "--done", std::to_string(k), "--out", step.path()});
    ASSERT_EQ(ended.exitCode, 0) << ended.errors;
    std::vector<std::string> wanted(part.todos.size(), "not_begun");
    std::fill_n(wanted.begin(), k, "done");
    std::string said;
    EXPECT_EQ(statesOf(part.id, expected, step.path(), &said), wanted)
        << part.id << " after step " << k << '\n'
        << said;
  }
}

TEST(Kit, HoldsNoSolutionAndKnowsEveryStep) {
  const TemporaryFolder folder;
  const fs::path kit = folder.path() / "kit";
  const Ended ended = runTool({"release", "--out", kit}, {}, 3000);
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  EXPECT_THAT(names(kit),
              IsSupersetOf({"CMakeLists.txt", "README.md", "README.ja.md", "assignments", "cmake",
                            "expected", "framework", "ggrade", "grader"}));
  EXPECT_THAT(names(kit), Not(Contains("solutions")));
  EXPECT_THAT(names(kit), Not(Contains("tests")));
  EXPECT_TRUE(fs::exists(folder.path() / "kit.zip"));
  EXPECT_THAT(ended.out, HasSubstr("kit.zip"));
  for (const ggrade::Assignment& assignment : ggrade::loadAssignments(kSource / "assignments")) {
    SCOPED_TRACE(assignment.id);
    // No line of it where the assignment's own files are, and no block of several lines anywhere.
    EXPECT_GE(expectNoSolutionIn(assignment, kit / "assignments" / assignment.id), 1);
    for (const ggrade::Part& part : assignment.parts)
      expectNoSolutionIn(assignment, kit / "expected" / part.id);
    for (const char* name : {"framework", "grader", "cmake"})
      expectNoSolutionIn(assignment, kit / name, true);
    for (const auto& entry : fs::directory_iterator(kSource / "assignments" / assignment.id))
      if (entry.is_regular_file()) {
        EXPECT_EQ(read(kit / "assignments" / assignment.id / entry.path().filename()),
                  read(entry.path()));
      }
    for (const ggrade::Part& part : assignment.parts) {
      expectEveryStepKnown(part, kit / "expected");
      // The finished program's passes as numbers, for whoever wants to compare.
      EXPECT_FALSE(names(kit / "expected" / part.id / "reference").empty()) << part.id;
    }
  }
}

TEST(Kit, TodosThatAreNotNamedComeFilledIn) {
  const TemporaryFolder folder;
  const fs::path kit = folder.path() / "kit";
  const Ended ended =
      runTool({"release", "--blank", "mirror.4,mirror.5", "--devcontainer", "--out", kit}, {}, 600);
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  EXPECT_THAT(ended.out,
              AllOf(HasSubstr("to do mirror.4, mirror.5"), HasSubstr("comes filled in")));
  EXPECT_THAT(names(kit / "assignments"), ElementsAre("CMakeLists.txt", "floor"));
  EXPECT_THAT(names(kit / "expected"), ElementsAre("mirror"));
  const std::string program = read(kit / "assignments/floor/floor.cpp");
  EXPECT_THAT(program, HasSubstr("TODO(mirror.4)"));
  EXPECT_THAT(program, HasSubstr("DONE(mirror.2)"));
  EXPECT_THAT(program, Not(HasSubstr("TODO(mirror.2)")));
  EXPECT_THAT(program, HasSubstr("glBindFramebuffer(GL_FRAMEBUFFER, reflection.framebuffer);"));
  EXPECT_THAT(program, Not(HasSubstr("mirroredView")));
  EXPECT_TRUE(fs::exists(kit / ".devcontainer/devcontainer.json"));
  EXPECT_TRUE(fs::exists(kit / ".devcontainer/Dockerfile"));
  const fs::path expected = kit / "expected";
  EXPECT_THAT(statesOf("mirror", expected, kit / "assignments/floor"),
              ElementsAre("not_begun", "not_begun"));
  EXPECT_THAT(statesOf("mirror", expected, kSource / "solutions/floor"),
              ElementsAre("done", "done"));
}

TEST(Kit, BuildsAndChecksOnItsOwn) {
  const TemporaryFolder folder;
  const fs::path kit = folder.path() / "kit";
  ASSERT_EQ(runTool({"release", "--parts", "ssao", "--out", kit}, {}, 600).exitCode, 0);
  const Ended ended =
      Running({kit / "ggrade", "check", "--json"}, {{"GGRADE_PRESET", "release"}}, kit).wait(900);
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  const json part = json::parse(ended.out).at(0);
  EXPECT_EQ(part.at("part"), "ssao");
  EXPECT_EQ(part.at("outcome"), "graded");
  for (const json& todo : part.at("todos")) EXPECT_EQ(todo.at("state"), "not_begun");
  EXPECT_THAT(read(kit / "out/check-ssao.html"), HasSubstr("data:image/png"));
}

TEST(Kit, AnAutogradersArchiveHasItsTwoScriptsOnTop) {
  const TemporaryFolder folder;
  const fs::path made = folder.path() / "autograder";
  const Ended ended = runTool(
      {"release", "--gradescope", "--parts", "mirror", "--lang", "ja", "--out", made}, {}, 100);
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  EXPECT_THAT(names(made), ElementsAre("ggrade", "run_autograder", "setup.sh"));
  EXPECT_THAT(read(made / "run_autograder"),
              AllOf(HasSubstr("grade mirror"), HasSubstr("export GG_LANG=ja\n")));
  EXPECT_THAT(read(made / "setup.sh"), HasSubstr("grade mirror assignments/floor"));
  for (const char* script : {"run_autograder", "setup.sh"}) {
    EXPECT_NE(fs::status(made / script).permissions() & fs::perms::owner_exec, fs::perms::none);
    EXPECT_EQ(Running({"/bin/bash", "-n", made / script}).wait(10).exitCode, 0) << script;
  }
  EXPECT_THAT(names(made / "ggrade/solutions"), ElementsAre("CMakeLists.txt", "floor"));
  EXPECT_TRUE(fs::exists(folder.path() / "autograder.zip"));
}

/// What run_autograder does with a tool that answers as it is told: leaves results where they are
/// looked for, and tries again without a sandbox only where there is none.
TEST(Kit, AnAutograderLeavesResults) {
  const TemporaryFolder folder;
  const fs::path root = folder.path() / "root";
  ASSERT_EQ(
      runTool({"release", "--gradescope", "--parts", "mirror", "--out", root / "source"}, {}, 100)
          .exitCode,
      0);
  fs::create_directories(root / "submission");
  const fs::path tool = root / "source/ggrade/ggrade";
  const auto answer = [&](const char* lines) {
    std::ofstream(tool, std::ios::trunc)
        << "#!/bin/bash\necho \"$@\" >> \"" << (root / "calls").string() << "\"\n"
        << "out=\nfor a; do [[ $before == --out ]] && out=$a; before=$a; done\nmkdir -p \"$out\"\n"
        << lines << '\n';
  };
  const auto run = [&] {
    fs::remove(root / "calls");
    return Running({root / "source/run_autograder"}, {{"AUTOGRADER_ROOT", root}}).wait(20).exitCode;
  };
  answer("echo '{\"score\": 7}' > \"$out/results.json\"");
  EXPECT_EQ(run(), 0);
  EXPECT_EQ(json::parse(read(root / "results/results.json")).at("score"), 7);
  EXPECT_THAT(read(root / "calls"), Not(HasSubstr("--sandbox none")));
  answer("[[ $* == *none* ]] || exit 3\necho '{\"score\": 8}' > \"$out/results.json\"");
  EXPECT_EQ(run(), 0);
  EXPECT_EQ(json::parse(read(root / "results/results.json")).at("score"), 8);
}

TEST(Kit, WrongWordsAreNamedBeforeAnyWork) {
  const TemporaryFolder folder;
  const auto said = [&](Arguments arguments) {
    arguments.insert(arguments.begin(), "release");
    arguments.insert(arguments.end(), {"--out", folder.path() / "kit"});
    const Ended ended = runTool(arguments);
    EXPECT_EQ(ended.exitCode, 2);
    EXPECT_FALSE(fs::exists(folder.path() / "kit"));
    return ended.errors;
  };
  EXPECT_THAT(said({"--blank", "mirror.44"}), HasSubstr("there is no TODO mirror.44"));
  EXPECT_THAT(said({"--parts", "mirrors"}), HasSubstr("mirrors"));
  EXPECT_THAT(said({"--parts", "shadow", "--blank", "mirror.4"}),
              HasSubstr("mirror is not one of --parts shadow"));
  EXPECT_THAT(said({"--gradescope"}), HasSubstr("--parts mirror"));
}

} // namespace
