// `ggrade release`, and the kit that it makes.

#include "kit.hpp"

#include <gmock/gmock.h>

#include <fstream>

using namespace tool;
using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

namespace {

/// The kit of one assignment, made once for all tests that only look at it.
class Kit : public testing::Test {
protected:
  static void SetUpTestSuite() {
    made_ = std::make_unique<TemporaryFolder>();
    released_ = runTool({"release", "--parts", "ssao", "--out", kit()}, {}, 600);
    ASSERT_EQ(released_.exitCode, 0) << released_.errors;
  }
  static void TearDownTestSuite() { made_.reset(); }
  static fs::path kit() { return made_->path() / "グラフィックス 演習"; }

  static inline std::unique_ptr<TemporaryFolder> made_;
  static inline Ended released_;
};

/// All assignments: long_kit_test.cpp.
TEST_F(Kit, HoldsNoSolutionAndKnowsEveryStep) {
  expectKit(kit(), released_, {ggrade::Assignment::load(kSource / "assignments/ssao")});
  // Its examples name what it has.
  EXPECT_THAT(read(kit() / "cmake/help/ggrade.ja.txt"),
              AllOf(HasSubstr("ggrade check ssao --watch"), Not(HasSubstr("mirror"))));
  EXPECT_THAT(read(kit() / "grader/check/main.cpp"),
              AllOf(HasSubstr("ggrade check ssao --hint"), Not(HasSubstr("ggrade check mirror"))));
}

/// As a student's machine does it, but for what the same compiler has made of the same sources.
TEST_F(Kit, BuildsAndChecksOnItsOwn) {
  const std::string launcher =
      (kSource / "tests/grading/reuse_object.sh").string() + ';' + kBuild.string();
  expectThatItChecks(
      kit(), {{"CMAKE_CXX_COMPILER_LAUNCHER", launcher}, {"CMAKE_C_COMPILER_LAUNCHER", launcher}});
}

/// Of all effects together, as `check --json` says it after the part.
std::string stateOfAll(const std::string& said) {
  return nlohmann::json::parse(said).at(1).at("todos").at(0).at("state");
}

/// In a kit whose comments are Japanese.
TEST(Release, TodosThatAreNotNamedComeFilledIn) {
  const TemporaryFolder folder;
  const fs::path kit = folder.path() / "kit";
  const Ended ended = runTool(
      {"release", "--blank", "mirror.4,mirror.5", "--devcontainer", "--lang", "ja", "--out", kit},
      {}, 600);
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  EXPECT_THAT(ended.out,
              AllOf(HasSubstr("to do mirror.4, mirror.5"), HasSubstr("comes filled in")));
  EXPECT_THAT(names(kit / "assignments"), ElementsAre("CMakeLists.txt", "floor"));
  EXPECT_THAT(names(kit / "expected"), ElementsAre("floor", "mirror"));
  EXPECT_THAT(names(folder.path() / "kit-quiz"),
              testing::IsSupersetOf({"mirror.md", "mirror.ja.gift.txt"}));
  EXPECT_FALSE(fs::exists(folder.path() / "kit-quiz/shadow.md"));
  const std::string program = read(kit / "assignments/floor/mirror.hpp");
  EXPECT_THAT(program, HasSubstr("TODO(mirror.4)"));
  EXPECT_THAT(program, HasSubstr("DONE(mirror.2)"));
  EXPECT_THAT(program, Not(HasSubstr("TODO(mirror.2)")));
  EXPECT_THAT(program, HasSubstr("glBindFramebuffer(GL_FRAMEBUFFER, reflection.framebuffer);"));
  EXPECT_THAT(program, Not(HasSubstr("mirroredView")));
  EXPECT_THAT(program,
              AllOf(HasSubstr("// TODO(mirror.4): y = 0の平面での物体の鏡像を描画する。\n"),
                    Not(HasSubstr("Given:"))));
  EXPECT_EQ(read(kit / "expected/mirror/handed_out/mirror.hpp"), program);
  EXPECT_THAT(read(kit / "assignments/floor/mirror.md"),
              testing::StartsWith("> In this kit these steps come filled in, marked `DONE`: "
                                  "mirror.1, mirror.2, mirror.3, mirror.6, mirror.7.\n"));
  EXPECT_THAT(read(kit / "assignments/floor/shadow.ja.md"),
              testing::StartsWith("> このキットでは、このパートはすべて完成した"));
  EXPECT_TRUE(fs::exists(kit / ".devcontainer/devcontainer.json"));
  EXPECT_TRUE(fs::exists(kit / ".devcontainer/Dockerfile"));
  const fs::path expected = kit / "expected";
  EXPECT_THAT(statesOf("mirror", expected, kit / "assignments/floor"),
              ElementsAre("not_begun", "not_begun"));
  // Of the parts that come filled in nothing is judged but how they go with this one.
  std::string said;
  EXPECT_THAT(statesOf("mirror", expected, kSource / "solutions/floor", &said),
              ElementsAre("done", "done"));
  EXPECT_EQ(stateOfAll(said), "done");
  Submission leavesUnitOne = Submission::solution();
  leavesUnitOne.replace("shadow.hpp", "  glActiveTexture(GL_TEXTURE0);\n", "");
  EXPECT_THAT(statesOf("mirror", expected, leavesUnitOne.path(), &said),
              ElementsAre("done", "done"));
  EXPECT_EQ(stateOfAll(said), "wrong") << said;
}

TEST(Release, AnAutogradersArchiveHasItsTwoScriptsOnTop) {
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
  EXPECT_FALSE(fs::exists(folder.path() / "autograder-quiz"));
}

/// What run_autograder does with a tool that answers as it is told: leaves results where they are
/// looked for, and tries again without a sandbox only where there is none.
TEST(Release, AnAutograderLeavesResults) {
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

TEST(Release, WrongWordsAreNamedBeforeAnyWork) {
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
