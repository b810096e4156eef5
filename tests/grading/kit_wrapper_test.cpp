// The script in front of the tool: what it says before anything is installed or built.

#include "tool.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include <unistd.h>

using namespace tool;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

namespace {

/// The script and its texts alone, in a folder where nothing could be built.
class Wrapper : public testing::Test {
protected:
  void SetUp() override {
    fs::copy_file(kSource / "ggrade", folder_.path() / "ggrade");
    fs::create_directories(folder_.path() / "cmake");
    fs::copy(kSource / "cmake" / "help", folder_.path() / "cmake" / "help");
  }

  Ended run(Arguments arguments) const {
    arguments.insert(arguments.begin(), folder_.path() / "ggrade");
    Ended ended = Running(arguments, {}, folder_.path()).wait(10);
    EXPECT_THAT(names(folder_.path()), ElementsAre("cmake", "ggrade"))
        << "nothing was built for this";
    return ended;
  }

  TemporaryFolder folder_;
};

/// As in a kit that root has built.
TEST_F(Wrapper, SaysWhereItMayNotWrite) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can become somebody else";
  const fs::path build = folder_.path() / "build/release";
  fs::create_directories(build);
  const Ended ended = Running({"/usr/bin/setpriv", "--reuid=65534", "--regid=65534",
                               "--clear-groups", folder_.path() / "ggrade", "check"},
                              {{"GGRADE_PRESET", "release"}})
                          .wait(10);
  EXPECT_EQ(ended.exitCode, 2);
  EXPECT_EQ(ended.errors,
            "ggrade: can't write to " + build.string() + ": run ggrade in a folder of your own\n");
}

TEST_F(Wrapper, SaysWhatThereIsBeforeAnythingIsBuilt) {
  const Ended help = run({"--help"}), nothing = run({}), japanese = run({"--lang", "ja", "--help"});
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_EQ(nothing.exitCode, 2);
  EXPECT_EQ(nothing.out, "");
  EXPECT_EQ(nothing.errors, help.out);
  const auto expectCommand = [&](const std::string& command) {
    EXPECT_THAT(help.out, HasSubstr("\n  " + command + ' '));
    EXPECT_THAT(japanese.out, HasSubstr("\n  " + command + ' '));
  };
  for (const char* command : {"run", "check", "compare", "test"}) expectCommand(command);
  // And all that the tool's programs have.
  int count = 0;
  for (const char* program : {"ggrade", "ggrade-look", "ggrade-author"}) {
    std::istringstream lines(Running({kBuild / "bin" / program, "--help"}).wait(100).out);
    std::string line;
    while (std::getline(lines, line) && line != "Subcommands:") {
    }
    for (; std::getline(lines, line) && !line.empty(); ++count)
      expectCommand(line.substr(2, line.find(' ', 2) - 2));
  }
  EXPECT_GE(count, 12);
}

TEST_F(Wrapper, TakesTheLanguageBeforeTheCommand) {
  const Ended help = run({"--lang", "ja", "--help"});
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_THAT(help.out, HasSubstr("使い方：ggrade COMMAND"));
  EXPECT_THAT(run({"--lang", "ja", "run"}).out, HasSubstr("使い方：ggrade run ID"));
  EXPECT_THAT(run({"--lang", "en", "run", "--help"}).out, HasSubstr("Usage: ggrade run ID"));
  const Ended wrong = run({"--lang", "fr", "run", "mirror"});
  EXPECT_EQ(wrong.exitCode, 2);
  EXPECT_EQ(wrong.errors, "ggrade: --lang fr: there are en and ja\n");
  EXPECT_EQ(run({"--lang", "ja", "run", "none"}).errors,
            "ggrade: 課題またはパート「none」はありません。あるのは：\n");
}

TEST_F(Wrapper, SpeaksTheLanguageThatStandsAfterTheCommand) {
  const std::string said = "ggrade: 課題またはパート「none」はありません。あるのは：\n";
  EXPECT_EQ(run({"run", "none", "--lang", "ja"}).errors, said);
  EXPECT_EQ(run({"run", "none", "--lang=ja"}).errors, said);
  EXPECT_THAT(run({"run", "none", "--", "--lang", "ja"}).errors,
              StartsWith("ggrade: there is no assignment or part"));
}

/// Into a pipe, too, where ninja's own lines don't go.
TEST_F(Wrapper, SaysFromTimeToTimeHowFarABuildIs) {
  const fs::path tools = folder_.path() / "tools";
  fs::create_directories(tools);
  const auto make = [&](const char* name, const std::string& script) {
    std::ofstream(tools / name) << "#!/bin/sh\n" << script << '\n';
    fs::permissions(tools / name, fs::perms::owner_all);
  };
  make("cmake", "exit 0");
  make("sleep", "exec /bin/sleep 0.2"); // in place of 10 s
  make("ninja", "echo \"[1/7] one\"; echo \"[3/7] three\"; /bin/sleep 1");
  std::ofstream(folder_.path() / "cmake" / "packages.txt") << "[student]\n";
  fs::create_directories(folder_.path() / "assignments/small");
  std::ofstream(folder_.path() / "assignments/small/assignment.json") << R"({"id": "small"})";
  std::ofstream(folder_.path() / "assignments/small/small.cpp") << '\n';
  const std::string path = tools.string() + ":/usr/bin:/bin";
  const Ended ended =
      Running({folder_.path() / "ggrade", "run", "small"}, {{"PATH", path}}, folder_.path())
          .wait(10);
  EXPECT_THAT(ended.errors, HasSubstr("ggrade: configuring (release, student)\n"
                                      "ggrade: building [3/7]\n"
                                      "ggrade: building [3/7]\n"));
  EXPECT_FALSE(ended.late);
}

/// A command that isn't there, or can't do its work here, is refused at once: minutes of building
/// and hundreds of megabytes of packages aren't the price of a slip of the finger.
TEST_F(Wrapper, RefusesACommandThatIsNotThere) {
  for (const char* command : {"chekc", "ggrade", "r.n", "-x", "Usage:"}) {
    const Ended refused = run({command});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_THAT(refused.errors, StartsWith("ggrade: there is no command \"" + std::string(command) +
                                           "\"; there are: run, check, render, "));
  }
  EXPECT_THAT(run({"--lang", "ja", "chekc"}).errors,
              StartsWith("ggrade: コマンド「chekc」はありません。あるのは：run, check, "));
}

TEST_F(Wrapper, RefusesInAKitWhatNeedsTheSolutions) {
  for (const std::string command : {"demo", "grade", "batch", "calibrate", "tradeoff", "derive"}) {
    const Ended refused = run({command, "mirror"});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_EQ(refused.errors, "ggrade: ggrade " + command +
                                  " needs the solutions, which are not there: " +
                                  (folder_.path() / "solutions").string() + "\n");
  }
  EXPECT_EQ(run({"test"}).errors,
            "ggrade: the tests are not there: " + (folder_.path() / "tests").string() + "\n");
}

/// Whatever it says, it says in both languages.
TEST_F(Wrapper, EveryTextIsThereInJapanese) {
  const std::string script = read(kSource / "ggrade");
  int texts = 0;
  for (const std::string call : {" note \"", " die \""})
    for (std::size_t at = script.find(call); at != script.npos; at = script.find(call, at + 1)) {
      if (script.compare(at, 10, " note \"$@\"") == 0) continue;
      const std::size_t end = script.find("\" \"", at);
      ASSERT_NE(end, script.npos) << script.substr(at, 80);
      const std::string english = script.substr(at, end - at);
      const auto isForeign = [](char c) { return static_cast<unsigned char>(c) >= 0x80; };
      EXPECT_TRUE(std::ranges::none_of(english, isForeign)) << english;
      EXPECT_TRUE(std::ranges::any_of(script.substr(end, script.find('\n', end) - end), isForeign))
          << english;
      ++texts;
    }
  EXPECT_GE(texts, 12);
}

} // namespace
