// `ggrade new`, in a copy of this tree: what it makes is built, graded and calibrated by a tool
// that finds it by folder alone.

#include "tool.hpp"

#include <gmock/gmock.h>

#include <csignal>

using namespace tool;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

namespace {

/// Most objects of the copy's build are taken from this one, see reuse_object.sh.
constexpr double kSeconds = 300;

/// A copy of the sources, under version control, with the tool built in it.
class NewAssignment : public testing::Test {
protected:
  void SetUp() override {
    fs::create_directory(tree_);
    for (const char* name : {".gitignore", "CMakeLists.txt", "assignments", "cmake", "framework",
                             "grader", "solutions"})
      fs::copy(kSource / name, tree_ / name, fs::copy_options::recursive);
    git({"init", "--quiet"});
    git({"add", "--all"});
    git({"-c", "user.name=test", "-c", "user.email=test@localhost", "commit", "--quiet", "-m",
         "a tree"});
    const std::string launcher =
        (kSource / "tests/grading/reuse_object.sh").string() + ';' + kBuild.string();
    run({GGRADE_CMAKE, "-S", tree_, "-B", build_, "-G", "Ninja", "-DGGRADE_LEVEL=author",
         "-DCMAKE_BUILD_TYPE=" GGRADE_BUILD_TYPE, "-DCMAKE_CXX_COMPILER_LAUNCHER=" + launcher,
         "-DCMAKE_C_COMPILER_LAUNCHER=" + launcher});
    build({"ggrade_author"});
    ASSERT_FALSE(HasFailure()) << "the copy is not as this tree";
  }
  Ended run(const Arguments& words) {
    const Ended ended = Running(words, {}, tree_).wait(kSeconds);
    EXPECT_EQ(ended.exitCode, 0) << words[0] << ":\n" << ended.out << ended.errors;
    return ended;
  }
  std::string git(Arguments words) {
    words.insert(words.begin(), GGRADE_GIT);
    return run(words).out;
  }
  std::string build(Arguments targets) {
    targets.insert(targets.begin(), {GGRADE_NINJA, "-C", build_});
    return run(targets).out;
  }
  /// The copy's own tool.
  Arguments tool(Arguments words) const {
    words.insert(words.begin(), build_ / "bin/ggrade");
    return words;
  }
  json grade(const Arguments& words) {
    Arguments all = {"grade", "test_lamp"};
    all.insert(all.end(), words.begin(), words.end());
    all.insert(all.end(), {"--no-diagnosis", "--json", "--out", files_.path() / "graded"});
    return json::parse(run(tool(all)).out).at("extra_data");
  }

  TemporaryFolder files_;
  fs::path tree_ = files_.path() / "tree", build_ = tree_ / "build/release";
};

TEST_F(NewAssignment, IsBuiltGradedAndCalibratedAndNoOtherFileChanges) {
  // What is refused, or stopped, leaves nothing.
  const Ended refused = Running(tool({"new", "mirror"})).wait(kSeconds);
  EXPECT_EQ(refused.exitCode, 2);
  EXPECT_THAT(refused.errors, HasSubstr("ID \"mirror\": floor has a part of this name"));
  Running stopped(tool({"new", "test_lamp"}));
  EXPECT_TRUE(stopped.says("handout pictures of test_lamp", kSeconds));
  stopped.signalGroup(SIGINT);
  EXPECT_EQ(stopped.wait(kSeconds).exitCode, 130);
  EXPECT_EQ(git({"status", "--porcelain"}), "");

  const Ended made = run(tool({"new", "test_lamp", "--title", "A lamp"}));
  EXPECT_THAT(made.out, AllOf(HasSubstr("./ggrade derive test_lamp"),
                              HasSubstr("./ggrade grade test_lamp solutions/test_lamp --solution"),
                              HasSubstr("./ggrade calibrate test_lamp")));
  EXPECT_EQ(git({"status", "--porcelain"}), "?? assignments/test_lamp/\n?? solutions/test_lamp/\n");
  const Ended again = Running(tool({"new", "test_lamp"})).wait(kSeconds);
  EXPECT_EQ(again.exitCode, 2);
  EXPECT_THAT(again.errors, HasSubstr("ID \"test_lamp\": there is such an assignment"));

  // Nobody tells the build of it.
  build({"ggrade_author"});
  EXPECT_THAT(build({"-t", "query", "test_lamp", "test_lamp_solution"}),
              HasSubstr("test_lamp_solution"));
  EXPECT_THAT(
      run(tool({"list"})).out,
      HasSubstr("test_lamp  A lamp\n  100 points + 0 bonus, 1 TODO\n  edit: test_lamp.cpp "));

  EXPECT_EQ(grade({tree_ / "solutions/test_lamp", "--solution"}).at("score_without_bonus"), 100);
  const json stub = grade({tree_ / "assignments/test_lamp"});
  EXPECT_EQ(stub.at("outcome"), "graded");
  EXPECT_EQ(stub.at("score_without_bonus"), 0);
  const Ended calibrated = run(tool(
      {"calibrate", "test_lamp", "--seeds", "2", "--json", "--out", files_.path() / "calibrated"}));
  const json programs = json::parse(calibrated.out).at("parts").at(0).at("programs");
  EXPECT_EQ(
      std::ranges::count_if(programs, [](const json& one) { return one.at("lowest") == 100; }),
      2); // the reference and the right answer

  // Made from the solution as `derive` makes it.
  const fs::path derived = files_.path() / "derived";
  run(tool({"derive", "test_lamp", "--out", derived}));
  for (const std::string name : {"test_lamp.cpp", "object.vert", "object.frag", "README.md",
                                 "handout/test_lamp-0.png", "handout/test_lamp-1.png"})
    EXPECT_EQ(read(derived / name), read(tree_ / "assignments/test_lamp" / name)) << name;
  EXPECT_NE(read(derived / "handout/test_lamp-0.png"), read(derived / "handout/test_lamp-1.png"));
}

} // namespace
