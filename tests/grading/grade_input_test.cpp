// What a person can get wrong: one clear message with the remedy, the right exit code, and nothing
// half-written.

#include "tool.hpp"

#include <gmock/gmock.h>

#include <csignal>

#include <sys/stat.h>
#include <unistd.h>

using namespace tool;
using testing::AllOf;
using testing::Contains;
using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Matcher;
using testing::Not;

namespace {

/// Exit code 2, nothing on stdout, and a message; no file in `out`'s parent.
class BadInput : public testing::Test {
protected:
  void expectRefusal(const Arguments& arguments, const Matcher<std::string>& message) {
    const Ended ended = runTool(arguments);
    EXPECT_EQ(ended.exitCode, 2) << ended.errors;
    EXPECT_EQ(ended.out, "");
    EXPECT_THAT(ended.errors, message);
    EXPECT_THAT(ended.errors, Not(HasSubstr("terminate called")));
    EXPECT_LE(std::count(ended.errors.begin(), ended.errors.end(), '\n'), 3) << ended.errors;
    EXPECT_FALSE(fs::exists(out_));
    EXPECT_THAT(names(folder_.path()), Not(Contains(testing::StartsWith(".ggrade-"))));
  }
  /// Graded as in a class: nothing was built, and the result says why. No usage error.
  void expectNothingBuilt(const fs::path& upload, const Matcher<std::string>& reason) {
    const Ended ended = runTool(gradeInto(upload));
    EXPECT_EQ(ended.exitCode, 0) << ended.errors;
    EXPECT_THAT(ended.out, HasSubstr("build_failed"));
    EXPECT_THAT(ended.errors, Not(HasSubstr("terminate called")));
    const auto results = nlohmann::json::parse(read(out_ / "results.json"));
    EXPECT_EQ(results.at("score"), 0);
    EXPECT_EQ(results.at("extra_data").at("outcome"), "build_failed");
    EXPECT_EQ(results.at("extra_data").at("submission"), upload.filename().string());
    EXPECT_THAT(results.at("extra_data").at("detail").get<std::string>(), reason);
    EXPECT_THAT(names(folder_.path()), Not(Contains(testing::StartsWith(".ggrade-"))));
    fs::remove_all(out_);
  }
  Arguments gradeInto(const fs::path& folder) { return {"grade", "mirror", folder, "--out", out_}; }

  TemporaryFolder folder_;
  fs::path out_ = folder_.path() / "out";
};

TEST_F(BadInput, MissingFolder) {
  expectRefusal(gradeInto("/nowhere/ada"),
                AllOf(HasSubstr("/nowhere/ada: there is no such folder"), HasSubstr("floor.cpp")));
  expectRefusal({"render", "/nowhere/ada", "--out", out_}, HasSubstr("/nowhere/ada"));
}

TEST_F(BadInput, AFileInPlaceOfAFolder) {
  expectNothingBuilt(folder_.write("ada.txt", "hello"),
                     HasSubstr("the upload holds none of floor.cpp, mirror.hpp, "));
}

TEST_F(BadInput, AnArchiveThatIsCutOff) {
  const Submission solution = Submission::solution();
  const fs::path archive = folder_.path() / "ada.tar.gz";
  ASSERT_EQ(
      Running({"/usr/bin/tar", "-czf", archive, "-C", solution.path(), "."}).wait(20).exitCode, 0);
  fs::resize_file(archive, fs::file_size(archive) / 2);
  expectNothingBuilt(archive, HasSubstr("ada.tar.gz"));
}

TEST_F(BadInput, EmptyFolder) {
  fs::create_directory(folder_.path() / "ada");
  expectNothingBuilt(folder_.path() / "ada",
                     HasSubstr("the upload holds none of floor.cpp, mirror.hpp, "));
  expectRefusal({"render", folder_.path() / "ada", "--out", out_},
                AllOf(HasSubstr("ID.cpp"), HasSubstr("ggrade list")));
}

TEST_F(BadInput, FolderWithOtherFilesOnly) {
  folder_.write("ada/main.cpp", "int main() {}\n");
  folder_.write("ada/floor/other.cpp", "int main() {}\n");
  expectNothingBuilt(folder_.path() / "ada", HasSubstr("the upload holds none of floor.cpp"));
}

TEST_F(BadInput, AnArchiveWithAFolderInItIsNone) {
  const Submission solution = Submission::solution();
  const fs::path archive = folder_.path() / "ada.tar.gz";
  const Ended packed =
      Running({"/usr/bin/tar", "-czf", archive, "-C", solution.path().parent_path(), "submission"})
          .wait(20);
  ASSERT_EQ(packed.exitCode, 0) << packed.errors;
  const Graded graded = gradeByTool(archive);
  EXPECT_EQ(graded.score(), 100);
  EXPECT_EQ(graded.results.at("extra_data").at("submission"), "ada.tar.gz");
}

TEST_F(BadInput, UnknownAssignmentListsWhatThereIs) {
  const auto message = AllOf(HasSubstr("no assignment or part \"mirrror\""),
                             ContainsRegex("there are: .*floor, mirror, shadow, bloom"));
  expectRefusal({"grade", "mirrror", kSource / "assignments/floor", "--out", out_}, message);
  expectRefusal({"derive", "mirrror", "--out", out_}, message);
  expectRefusal({"render", "mirrror", "--out", out_}, message);
}

TEST_F(BadInput, OutputBelowAFile) {
  const fs::path file = folder_.write("notes.txt", "mine");
  for (const Arguments& command : {Arguments{"grade", "mirror", kSource / "assignments/floor"},
                                   Arguments{"demo"}, Arguments{"render", "floor"}}) {
    Arguments arguments = command;
    arguments.insert(arguments.end(), {"--out", file / "out"});
    expectRefusal(arguments, AllOf(HasSubstr("notes.txt"), HasSubstr("--out")));
  }
  EXPECT_EQ(read(file), "mine");
}

TEST_F(BadInput, OutputThatCannotBeWritten) {
  // /proc refuses root, too.
  expectRefusal({"grade", "mirror", kSource / "assignments/floor", "--out", "/proc/out/ada"},
                AllOf(HasSubstr("/proc"), HasSubstr("--out")));
  expectRefusal({"render", "floor", "--out", "/proc/out"},
                AllOf(HasSubstr("/proc"), HasSubstr("--out")));
}

TEST_F(BadInput, AnOutputFolderWithOtherThingsIsLeftAlone) {
  const fs::path letter = folder_.write("home/letter.txt", "dear");
  for (const Arguments& command : {Arguments{"grade", "mirror", kSource / "assignments/floor"},
                                   Arguments{"demo"}, Arguments{"render", "floor"}}) {
    Arguments arguments = command;
    arguments.insert(arguments.end(), {"--out", folder_.path() / "home"});
    expectRefusal(arguments, AllOf(HasSubstr("holds letter.txt, which is no earlier result"),
                                   HasSubstr("--out")));
    EXPECT_THAT(names(folder_.path() / "home"), ElementsAre("letter.txt"));
    EXPECT_EQ(read(letter), "dear");
  }
}

TEST_F(BadInput, ACacheThatCannotBeUsed) {
  const fs::path file = folder_.write("notes.txt", "mine");
  const Ended ended = runTool({"grade", "mirror", kSource / "assignments/floor", "--out", out_},
                              {{"GGRADE_CACHE", file / "cache"}});
  EXPECT_EQ(ended.exitCode, 2);
  EXPECT_THAT(ended.errors, AllOf(HasSubstr("can't use the cache"), HasSubstr("GGRADE_CACHE")));
  EXPECT_FALSE(fs::exists(out_));
}

TEST_F(BadInput, ACacheThatWasThereKeepsItsPermissions) {
  const fs::path cache = folder_.path() / "cache";
  fs::create_directory(cache);
  fs::permissions(cache, fs::perms(0755));
  Running running(words({"grade", "mirror", kSource / "assignments/floor", "--out", out_}),
                  {{"GGRADE_CACHE", cache}});
  ASSERT_TRUE(running.says("building the reference", 30)) << running.errors();
  EXPECT_EQ(fs::status(cache).permissions(), fs::perms(0755));
  running.signalGroup(SIGTERM);
  EXPECT_EQ(running.wait(10).exitCode, 130);
}

TEST_F(BadInput, AnEarlierResultIsReplacedWhole) {
  const Ended first =
      runTool({"render", "floor", "--times", "0,0.1", "--size", "64x48", "--out", out_});
  ASSERT_EQ(first.exitCode, 0) << first.errors;
  EXPECT_THAT(names(out_), ElementsAre("frame-0.png", "frame-1.png", "trace.json"));
  const Ended second = runTool({"render", "floor", "--size", "64x48", "--out", out_});
  ASSERT_EQ(second.exitCode, 0) << second.errors;
  EXPECT_THAT(names(out_), ElementsAre("frame-0.png", "trace.json"));
}

TEST_F(BadInput, ASlashAtTheEndOfAFolderIsNoMistake) {
  Submission upload = Submission::solution();
  for (int time = 0; time < 2; ++time) {
    const Ended ended = runTool(
        {"render", upload.path().string() + "/", "--size", "64x48", "--out", out_.string() + "/"});
    ASSERT_EQ(ended.exitCode, 0) << ended.errors;
    EXPECT_THAT(names(out_), ElementsAre("frame-0.png", "trace.json"));
    EXPECT_THAT(names(folder_.path()), ElementsAre("out"));
  }
}

TEST_F(BadInput, SceneWithAWrongTypeNamesFileLineAndKey) {
  const fs::path scene = folder_.write("my.json", "{\n  \"size\": [64, 48],\n  \"ring\": {\n"
                                                  "    \"count\": \"six\"\n  }\n}\n");
  expectRefusal(
      {"render", "floor", "--scene", scene, "--out", out_},
      HasSubstr(
          "my.json:4: ring.count: must be a whole number between 0 and 10000, but is \"six\""));
}

TEST_F(BadInput, SceneWithAnUnknownKeyNamesFileLineAndKey) {
  const fs::path scene =
      folder_.write("my.json", "{\n  \"size\": [64, 48],\n  \"rings\": { \"count\": 6 }\n}\n");
  expectRefusal({"render", "floor", "--scene", scene, "--out", out_},
                HasSubstr("my.json:3: rings: is not a key of this scene; did you mean ring?"));
}

TEST_F(BadInput, SceneThatIsNoJsonNamesTheLine) {
  const fs::path scene = folder_.write("my.json", "{\n  \"size\": [64, 48],\n}\n");
  expectRefusal({"render", "floor", "--scene", scene, "--out", out_},
                ContainsRegex("my\\.json:3:"));
  expectRefusal({"render", "floor", "--scene", "/nowhere.json", "--out", out_},
                HasSubstr("/nowhere.json"));
}

TEST_F(BadInput, OptionsThatMakeNoSense) {
  const auto render = [&](const std::string& option, const std::string& value) {
    return Arguments{"render", "floor", option, value, "--out", out_};
  };
  for (const char* size : {"0x0", "640", "640x", "x480", "640x480x3", "-1x480", "640X480", "1e3x4",
                           "99999x99999", "640x4294967297"})
    expectRefusal(render("--size", size), AllOf(HasSubstr(size), HasSubstr("640x480")));
  for (const char* times : {"soon", "0,later", "-1", "nan", "inf"})
    expectRefusal(render("--times", times), HasSubstr("--times"));
  for (const char* before : {"soon", "0,later", "-1", "nan"})
    expectRefusal(render("--before", before), HasSubstr("--before"));
  expectRefusal({"grade", "mirror", kSource / "assignments/floor", "--seed", "-1", "--out", out_},
                HasSubstr("--seed"));
  expectRefusal(
      {"grade", "mirror", kSource / "assignments/floor", "--seed", "lucky", "--out", out_},
      HasSubstr("--seed"));
  expectRefusal(
      {"grade", "mirror", kSource / "assignments/floor", "--reveal", "all", "--out", out_},
      AllOf(HasSubstr("--reveal"), HasSubstr("details")));
  expectRefusal({"derive", "mirror", "--done", "8", "--out", out_},
                HasSubstr("mirror has 7 TODOs"));
}

TEST_F(BadInput, MoreFramesThanFit) {
  std::string times = "0";
  for (int i = 1; i < 65; ++i) times += "," + std::to_string(i);
  expectRefusal({"render", "floor", "--times", times, "--out", out_},
                AllOf(HasSubstr("--times"), HasSubstr("64")));
  times.resize(times.rfind(','));
  expectRefusal({"render", "floor", "--times", "100", "--before", times, "--out", out_},
                AllOf(HasSubstr("--before"), HasSubstr("65 frames are more than 64")));
}

TEST_F(BadInput, UnknownOptionsAndCommands) {
  expectRefusal({"grade", "mirror", "x", "--fast"},
                AllOf(HasSubstr("--fast"), HasSubstr("--help")));
  expectRefusal({"grad", "mirror", "x"}, HasSubstr("--help"));
  expectRefusal({"grade"}, AllOf(HasSubstr("ID"), HasSubstr("--help")));
  expectRefusal({}, HasSubstr("--help"));
}

TEST_F(BadInput, ArgumentsThatGoogleTestDoesNotKnow) {
  expectRefusal({"grade", "mirror", kSource / "assignments/floor", "--out", out_, "--", "--fast"},
                HasSubstr("--fast"));
}

TEST_F(BadInput, WhatAnUploadHoldsBesidesIsNamed) {
  Submission upload = Submission::solution();
  fs::remove(upload.path() / "object.frag");
  fs::create_symlink("/etc/passwd", upload.path() / "object.frag");
  fs::remove(upload.path() / "object.vert");
  ASSERT_EQ(mkfifo((upload.path() / "object.vert").c_str(), 0644), 0);
  upload.write("extra.frag", std::string((1 << 20) + 1, ' '));
  upload.write("notes.txt", "hello").write("<b>.cpp", "int main() {}").write("floor.cpp~", "");
  upload.write("make.log", "");
  fs::create_directory(upload.path() / "build");
  fs::rename(upload.path() / "make.log", upload.path() / "build/make.log");
  fs::create_directory(upload.path() / "folder.vert");
  fs::create_symlink("/dev/zero", upload.path() / "zero.vert");
  upload.write("assignment.json", "not even JSON").write("scene.json", "{\"size\": [1, 1]}");

  const Graded graded = gradeByTool(upload);
  // The handed-out files stand in, and they are the solution's.
  EXPECT_EQ(graded.score(), 100);
  std::string unused;
  for (const auto& line : graded.results.at("extra_data").at("unused_files"))
    unused += line.get<std::string>() + "\n";
  for (const char* line :
       {"object.frag: is a symbolic link", "object.vert: is a FIFO",
        "extra.frag: larger than 1024 KiB", "notes.txt: not a file of this assignment",
        "<b>.cpp: not a file of this assignment", "floor.cpp~: not a file of this assignment",
        "zero.vert: is a symbolic link",
        "object.frag: not in the upload; the handed-out file stands in"})
    EXPECT_THAT(unused, HasSubstr(line));
  EXPECT_THAT(graded.results.at("output").get<std::string>(), HasSubstr("Not used: notes.txt"));
}

} // namespace
