// Ctrl-C in the middle: one message, exit code 130, and nothing left behind.

#include "tool.hpp"

#include <gmock/gmock.h>

#include <csignal>

#include <sys/prctl.h>
#include <sys/wait.h>

using namespace tool;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

class Interrupt : public testing::Test {
protected:
  // Whatever outlives the tool becomes a child of this process, and is seen.
  void SetUp() override { ASSERT_EQ(prctl(PR_SET_CHILD_SUBREAPER, 1), 0); }

  /// Starts the tool, waits until stderr holds `text` and `seconds` more, presses Ctrl-C.
  void interruptWhen(const std::string& text, double seconds, const Arguments& arguments) {
    const fs::path temporary = folder_.path() / "tmp";
    fs::create_directories(temporary);
    Environment environment = environment_;
    environment.emplace_back("TMPDIR", temporary);
    Running running(words(arguments), environment);
    ASSERT_TRUE(running.says(text, 60)) << running.errors();
    usleep(useconds_t(seconds * 1e6));
    running.signalGroup(signal_);
    const Ended ended = running.wait(30); // where much else runs
    EXPECT_FALSE(ended.late);
    EXPECT_EQ(ended.exitCode, 130) << ended.errors;
    EXPECT_EQ(ended.out, "");
    const std::string message = "ggrade: stopped; nothing half-written was left behind\n";
    EXPECT_THAT(ended.errors, testing::EndsWith(message));
    EXPECT_EQ(ended.errors.find(message), ended.errors.rfind(message));
    EXPECT_THAT(names(temporary), IsEmpty());
    EXPECT_TRUE(nothingRuns(5)) << "a process outlived the tool";
  }

  /// Have all orphans ended? What was killed may take its time to go where much else runs.
  static bool nothingRuns(double seconds) {
    for (double waited = 0; waited < seconds;) {
      const pid_t ended = waitpid(-1, nullptr, WNOHANG);
      if (ended < 0) return errno == ECHILD;
      if (ended > 0) continue;
      usleep(10'000);
      waited += 0.01;
    }
    return false;
  }

  TemporaryFolder folder_;
  fs::path out_ = folder_.path() / "results/out";
  Environment environment_;
  int signal_ = SIGINT;
};

TEST_F(Interrupt, WhileBuilding) {
  interruptWhen("building", 0.1,
                {"grade", "mirror", kSource / "solutions/floor", "--solution", "--out", out_});
  EXPECT_FALSE(fs::exists(out_.parent_path()));
}

TEST_F(Interrupt, WhileAHangingProgramRenders) {
  Submission hangs = Submission::solution();
  hangs.replace("floor.cpp", "    window.swapBuffers();\n",
                "    window.swapBuffers();\n    for (volatile int i = 0; i >= 0; i = 0) {}\n");
  interruptWhen("rendering", 0.5, {"grade", "mirror", hangs.path(), "--out", out_});
  EXPECT_FALSE(fs::exists(out_));
}

TEST_F(Interrupt, WhileJudgingByTerminate) {
  signal_ = SIGTERM;
  interruptWhen("judging", 0.05,
                {"grade", "mirror", kSource / "solutions/floor", "--solution", "--out", out_});
  EXPECT_FALSE(fs::exists(out_));
}

TEST_F(Interrupt, AnEarlierResultStands) {
  const Arguments arguments = {"grade",      "mirror", kSource / "solutions/floor",
                               "--solution", "--out",  out_};
  ASSERT_EQ(runTool(arguments).exitCode, 0);
  const std::string before = read(out_ / "results.json");
  interruptWhen("judging", 0.05, arguments);
  EXPECT_EQ(read(out_ / "results.json"), before);
  EXPECT_THAT(names(out_), ElementsAre("index.html", "junit.xml", "results.json", "student.html"));
  EXPECT_THAT(names(out_.parent_path()), ElementsAre("out"));
}

TEST_F(Interrupt, WhileTheReferenceIsRendered) {
  // A cache of its own, so that there is something to render; it stays usable.
  const fs::path cache = folder_.path() / "cache";
  environment_ = {{"GGRADE_CACHE", cache}};
  const Arguments arguments = {"grade",      "mirror",    kSource / "solutions/floor",
                               "--solution", "--quality", "fast",
                               "--out",      out_};
  interruptWhen("rendering the reference", 0.2, arguments);
  for (const auto& entry : fs::recursive_directory_iterator(cache))
    EXPECT_FALSE(entry.path().filename().string().starts_with(".ggrade-")) << entry.path();
  EXPECT_FALSE(fs::exists(out_));
  const Ended again = runTool(arguments, environment_);
  EXPECT_EQ(again.exitCode, 0) << again.errors;
  EXPECT_EQ(fs::status(cache).permissions(), fs::perms(0700)); // hidden scenes lie in it
  EXPECT_THAT(again.out, HasSubstr("100 / 100 + 10 bonus"));
}

TEST_F(Interrupt, TheDemo) {
  interruptWhen("-stub", 0.3, {"demo", "--out", out_});
  EXPECT_FALSE(fs::exists(out_));
  EXPECT_THAT(names(folder_.path()), ElementsAre("results", "tmp"));
  EXPECT_THAT(names(out_.parent_path()), IsEmpty());
}

TEST_F(Interrupt, Render) {
  interruptWhen("rendering", 0.05,
                {"render", "floor", "--times", "0,1,2,3,4,5,6,7,8,9,10", "--size", "2000x2000",
                 "--out", out_});
  EXPECT_FALSE(fs::exists(out_));
}

} // namespace
