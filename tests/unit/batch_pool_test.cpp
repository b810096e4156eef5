// Workers that do well, die, hang, lie, or never start; shell scripts in place of the real ones.

#include "batch/pool.hpp"
#include "batch/worker.hpp"

#include "assignment/usage_error.hpp"
#include "framework_temporary_folder.hpp"
#include "grading/workspace.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <thread>

#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using namespace ggrade;
using testing::HasSubstr;

constexpr char kGood[] =
    R"(echo '{"problem":"","outcome":"graded","score":1,"max_score":2,"seconds":0}')";

class BatchPool : public testing::Test {
protected:
  /// \param script what a worker does with each job; $line holds it, $n counts from 1
  std::map<std::string, batch::Reply> run(const std::string& script, std::size_t count,
                                          unsigned processes = 1, double seconds = 60,
                                          const std::string& begin = "echo ready") {
    std::vector<batch::Job> jobs(count);
    for (std::size_t i = 0; i < count; ++i) jobs[i].upload.name = "student" + std::to_string(i);
    batch::PoolOptions options;
    options.program = "/bin/sh";
    options.worker = {"sh", "-c",
                      begin + "\nn=0; while read -r line; do n=$((n + 1))\n" + script + "\ndone",
                      "worker"};
    options.processes = processes;
    options.temporary = folder_.path();
    options.seconds = seconds;
    std::map<std::string, batch::Reply> answers;
    batch::runJobs(jobs, options, [&](std::size_t job, const batch::Reply& answer) {
      const std::string& name = jobs[job].upload.name;
      EXPECT_FALSE(answers.contains(name)) << name << " was answered twice";
      answers[name] = answer;
    });
    return answers;
  }
  std::string mark(const std::string& name) const { return (folder_.path() / name).string(); }
  bool isMarked(const std::string& name) const { return fs::exists(folder_.path() / name); }

  TemporaryFolder folder_;
};

TEST_F(BatchPool, AnswersEveryJobOnce) {
  for (const unsigned processes : {1U, 3U, 20U}) {
    const auto answers = run(kGood, 7, processes);
    ASSERT_EQ(answers.size(), 7U) << processes;
    for (const auto& [name, answer] : answers) {
      EXPECT_EQ(answer.problem, "") << name;
      EXPECT_EQ(answer.outcome, "graded");
      EXPECT_EQ(answer.score, 1);
    }
  }
}

/// Asks for runs of a kind, and waits for its turn.
std::string turn(const std::string& kind) {
  return "echo '{\"runs\":\"" + kind + "\"}'; read -r go; [ \"$go\" = go ] || exit 1\n";
}

TEST_F(BatchPool, RunsThatAreToldGoBesideNoHiddenOnes) {
  // Each notes when its runs begin and end; at no time may both kinds be open.
  const std::string log = mark("log");
  const auto noted = [&](const std::string& kind) {
    return turn(kind) + "echo begin " + kind + " >> " + log +
           "\nsleep 0.0$((n % 3 + 1))\necho end " + kind + " >> " + log + '\n';
  };
  const auto answers =
      run(noted("told") + noted("hidden") + "echo '{\"runs\":\"none\"}'\n" + kGood, 12, 4);
  ASSERT_EQ(answers.size(), 12U);
  for (const auto& [name, answer] : answers) EXPECT_EQ(answer.problem, "") << name;
  std::map<std::string, int> open;
  int together = 0;
  std::ifstream in(log);
  for (std::string what, kind; in >> what >> kind;) {
    open[kind] += what == "begin" ? 1 : -1;
    EXPECT_FALSE(open["told"] > 0 && open["hidden"] > 0);
    together = std::max(together, open["hidden"]);
  }
  EXPECT_GT(together, 1) << "nothing goes side by side";
}

TEST_F(BatchPool, WhoDiesInItsTurnKeepsNobodyFromTheirs) {
  const auto answers = run("if [ ! -e " + mark("died") + " ]; then touch " + mark("died") + '\n' +
                               turn("hidden") + "kill -KILL $$; fi\n" + turn("told") + kGood,
                           3, 2);
  ASSERT_EQ(answers.size(), 3U);
  for (const auto& [name, answer] : answers) EXPECT_EQ(answer.problem, "") << name;
}

TEST_F(BatchPool, NoSuchKindOfRunsIsNoSense) {
  const auto answers = run("echo '{\"runs\":\"secret\"}'; read -r go", 1);
  EXPECT_EQ(answers.at("student0").problem, "a worker gave an answer that makes no sense");
}

TEST_F(BatchPool, NoJobsNoWorkers) {
  EXPECT_TRUE(run("touch " + mark("started"), 0, 2, 60, "touch " + mark("started")).empty());
  EXPECT_FALSE(isMarked("started"));
}

TEST_F(BatchPool, WorkersHaveATemporaryFolderOfTheRun) {
  run("echo \"$TMPDIR\" > " + mark("where") + "\n" + kGood, 1);
  std::string where;
  std::ifstream(mark("where")) >> where;
  EXPECT_EQ(where, folder_.path().string());
}

TEST_F(BatchPool, TriesAgainWhenAWorkerDies) {
  const auto answers =
      run("case $line in *student1*) if ! [ -e " + mark("died") + " ]; then touch " + mark("died") +
              "; kill -9 $$; fi;; esac\n" + kGood,
          3);
  EXPECT_TRUE(isMarked("died"));
  ASSERT_EQ(answers.size(), 3U);
  for (const auto& [name, answer] : answers) EXPECT_EQ(answer.problem, "") << name;
}

TEST_F(BatchPool, GivesUpAfterTwoDeathsAndGoesOn) {
  const auto answers = run(std::string("case $line in *student1*) kill -9 $$;; esac\n") + kGood, 3);
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_EQ(answers.at("student0").problem, "");
  EXPECT_EQ(answers.at("student1").problem, "the grader's own process died of signal 9");
  EXPECT_EQ(answers.at("student2").problem, "");
}

TEST_F(BatchPool, ANotGradableResultIsTriedOnceMore) {
  const std::string script = "echo x >> " + mark("tries") +
                             R"(
echo '{"problem":"","outcome":"not_gradable","score":0,"max_score":2,"seconds":0}')";
  const auto answers = run(script, 1);
  EXPECT_EQ(answers.at("student0").outcome, "not_gradable");
  EXPECT_EQ(fs::file_size(mark("tries")), 4U);
}

TEST_F(BatchPool, ATimeOutOfASubmissionIsNotTriedAgain) {
  const std::string script = "echo x >> " + mark("tries") + R"(
echo '{"problem":"","outcome":"timeout","score":0,"max_score":2,"seconds":0}')";
  run(script, 1);
  EXPECT_EQ(fs::file_size(mark("tries")), 2U);
}

TEST_F(BatchPool, AStuckWorkerDelaysNobodyElse) {
  const auto start = std::chrono::steady_clock::now();
  const auto answers =
      run(std::string("case $line in *student0*) exec sleep 1000;; esac\n") + kGood, 6, 2, 1.0);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  EXPECT_LT(passed.count(), 20);
  ASSERT_EQ(answers.size(), 6U);
  EXPECT_EQ(answers.at("student0").problem, "the grader itself was stuck for 1 s");
  for (int i = 1; i < 6; ++i) EXPECT_EQ(answers.at("student" + std::to_string(i)).problem, "");
}

TEST_F(BatchPool, NonsenseIsNoAnswer) {
  const auto answers = run(
      std::string("case $line in *student0*) echo '{\"outcome\": ';; *) ") + kGood + ";; esac", 2);
  EXPECT_EQ(answers.at("student0").problem, "a worker gave an answer that makes no sense");
  EXPECT_EQ(answers.at("student1").problem, "");
}

TEST_F(BatchPool, AWorkerThatNeverStartsEndsTheRun) {
  try {
    run(kGood, 3, 2, 60, "exit 3");
    FAIL() << "must throw";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(
        error.what(),
        "the grader's own process ended with code 3 before it could grade anything. Mend that, "
        "then run the command again");
  }
}

TEST_F(BatchPool, AWorkerThatIsNeverReadyEndsTheRun) {
  try {
    run(kGood, 1, 1, 1.0, "exec sleep 1000");
    FAIL() << "must throw";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "the grader itself was stuck for 1 s before it could grade anything. Mend that, "
                 "then run the command again");
  }
}

TEST_F(BatchPool, CtrlCEndsTheWorkersToo) {
  std::thread later([] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    grading::interrupted = true;
  });
  EXPECT_THROW(run("echo $$ > " + mark("pid") + "; exec sleep 1000", 2), grading::Interrupted);
  later.join();
  grading::interrupted = false;
  int pid = 0;
  std::ifstream(mark("pid")) >> pid;
  ASSERT_GT(pid, 1);
  EXPECT_NE(kill(pid, 0), 0) << "still running";
}

/// The exit code of a worker whose parent is number 1, as a container's first process is; 77 where
/// there are no such namespaces.
/// \param held does the parent hold the other end of the jobs?
int workerOfTheFirstProcess(bool held) {
  const auto codeOf = [](pid_t child) {
    int status = 0;
    return waitpid(child, &status, 0) == child && WIFEXITED(status) ? WEXITSTATUS(status) : 78;
  };
  const pid_t outer = fork();
  if (outer != 0) return codeOf(outer);
  if (unshare(CLONE_NEWUSER | CLONE_NEWPID) != 0) _exit(77);
  const pid_t first = fork();
  if (first != 0) _exit(codeOf(first));
  int jobs[2];
  if (pipe(jobs) != 0 || getpid() != 1) _exit(79);
  if (!held) close(jobs[1]);
  const pid_t worker = fork();
  if (worker != 0) _exit(codeOf(worker));
  dup2(jobs[0], STDIN_FILENO);
  if (held) close(jobs[1]);
  batch::endWithParent();
  _exit(0);
}

TEST(BatchWorker, GoesOnBelowAContainersFirstProcessAndEndsWithIt) {
  const int held = workerOfTheFirstProcess(true);
  if (held == 77) GTEST_SKIP() << "no namespaces of users and processes here";
  EXPECT_EQ(held, 0);
  EXPECT_EQ(workerOfTheFirstProcess(false), 1);
}

} // namespace
