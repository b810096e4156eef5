// Processes: how many, how long, and that none is left.
#include "sandbox_fixture.hpp"

#include "grader/sandbox/worker_uid.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <set>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace ggrade::sandbox;
using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::MatchesRegex;

SANDBOX_SUITE(SandboxProcesses);

namespace {

/// Runs `command` beside us until it is up, then calls `meanwhile`.
template <class Meanwhile> Result runBeside(const Command& command, Meanwhile meanwhile) {
  std::atomic<bool> cancel = false;
  Result result;
  std::thread thread([&] { result = run(command, Isolation::bwrap, &cancel); });
  meanwhile(cancel);
  cancel = true;
  thread.join();
  return result;
}

/// Do all children end before so long?
bool childrenEnd(std::chrono::milliseconds longest) {
  for (const auto end = std::chrono::steady_clock::now() + longest;;) {
    const pid_t ended = waitpid(-1, nullptr, WNOHANG);
    if (ended < 0) return errno == ECHILD;
    if (ended == 0 && std::chrono::steady_clock::now() > end) return false;
    if (ended == 0) std::this_thread::sleep_for(1ms);
  }
}

std::string realUid(int pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  for (std::string word; status >> word;)
    if (word == "Uid:" && status >> word) return word;
  return {};
}

} // namespace

TEST_P(SandboxProcesses, ForkingWithoutEnd) {
  if (delegated()) return;
  const std::string mark = marker();
  const Result result = run(attack("fork", {mark}));
  EXPECT_EQ(result.end, End::timeLimit) << describe(result);
  // Everybody forks, so the first has at most 19 of the 20.
  EXPECT_THAT(result.standardOutput, MatchesRegex("1?[0-9] children\n"));
  EXPECT_THAT(processesWith(mark), IsEmpty());
}

TEST_P(SandboxProcesses, ForkingIsCountedFromOutside) {
  if (delegated()) return;
  const std::string mark = marker();
  Command command = attack("fork", {mark});
  command.limits.wallSeconds = 5;
  command.limits.cpuSeconds = 20;
  std::size_t most = 0;
  runBeside(command, [&](std::atomic<bool>&) {
    for (int i = 0; i < 20; ++i) {
      std::this_thread::sleep_for(50ms);
      most = std::max(most, processesWith(mark).size());
    }
  });
  EXPECT_EQ(most, 20u);
  EXPECT_THAT(processesWith(mark), IsEmpty());
}

TEST_P(SandboxProcesses, ThreadsWithoutEnd) {
  if (delegated()) return;
  const Result result = run(attack("thread"));
  EXPECT_EQ(result.standardOutput, "19 threads\n") << describe(result);
}

TEST_P(SandboxProcesses, DaemonsEndWithTheCommand) {
  if (delegated()) return;
  const std::string mark = marker();
  const Result result = run(attack("outlive", {mark}));
  EXPECT_EQ(result.end, End::exited) << describe(result);
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_LT(result.wallSeconds, 1);
  EXPECT_THAT(processesWith(mark), IsEmpty());
}

TEST_P(SandboxProcesses, DaemonsEndAtTheTimeLimit) {
  if (delegated()) return;
  const std::string mark = marker();
  const Result result = run(attack("outlive", {mark, "stay"}));
  EXPECT_EQ(result.end, End::timeLimit) << describe(result);
  EXPECT_THAT(result.detail, MatchesRegex("wall time: 2.[0-9] s, limit 2.0 s"));
  EXPECT_THAT(processesWith(mark), IsEmpty());
}

TEST_P(SandboxProcesses, SignalsCannotBeIgnored) {
  if (delegated()) return;
  const std::string mark = marker();
  EXPECT_EQ(run(attack("deaf", {mark})).end, End::timeLimit);
  EXPECT_THAT(processesWith(mark), IsEmpty());
}

TEST_P(SandboxProcesses, EverythingEndsWithTheCaller) {
  if (delegated()) return;
  const std::string mark = marker();
  Command command = attack("outlive", {mark, "stay"});
  command.limits.wallSeconds = 30;
  const pid_t caller = fork();
  if (caller == 0) {
    run(command);
    _exit(0);
  }
  for (int i = 0; i < 100 && processesWith(mark).size() < 2; ++i) std::this_thread::sleep_for(20ms);
  EXPECT_EQ(processesWith(mark).size(), 2u);
  kill(caller, SIGKILL);
  waitpid(caller, nullptr, 0);
  for (int i = 0; i < 50 && !processesWith(mark).empty(); ++i) std::this_thread::sleep_for(20ms);
  EXPECT_THAT(processesWith(mark), IsEmpty());
}

TEST_P(SandboxProcesses, WallTimeWhileSleeping) {
  if (delegated()) return;
  Command command = attack("sleep");
  command.limits.wallSeconds = 0.5;
  const Result result = run(command);
  EXPECT_EQ(result.end, End::timeLimit) << describe(result);
  EXPECT_THAT(result.detail, MatchesRegex("wall time: 0.[5-9] s, limit 0.5 s"));
  EXPECT_GE(result.wallSeconds, 0.5);
  EXPECT_LT(result.wallSeconds, 1);
  EXPECT_LT(result.cpuSeconds, 0.2);
}

TEST_P(SandboxProcesses, ProcessorTimeOfOne) {
  if (delegated()) return;
  Command command = attack("spin", {"1"});
  command.limits.wallSeconds = 10;
  command.limits.cpuSeconds = 0.5;
  const Result result = run(command);
  EXPECT_EQ(result.end, End::timeLimit) << describe(result);
  EXPECT_THAT(result.detail, MatchesRegex("processor time: 0.[5-9] s in 2 processes, limit 0.5 s"));
  EXPECT_LT(result.wallSeconds, 5);
}

TEST_P(SandboxProcesses, ProcessorTimeOfMany) {
  if (delegated()) return;
  Command command = attack("spin", {"10"});
  command.limits.wallSeconds = 10;
  command.limits.cpuSeconds = 1;
  const Result result = run(command);
  EXPECT_EQ(result.end, End::timeLimit) << describe(result);
  EXPECT_THAT(result.detail,
              MatchesRegex("processor time: 1.[0-9] s in 11 processes, limit 1.0 s"));
  EXPECT_LT(result.cpuSeconds, 2);
}

TEST_P(SandboxProcesses, KillingEverybodySparesTheFirstProcess) {
  if (delegated()) return;
  const Result result = run(attack("killAll"));
  EXPECT_EQ(result.end, End::signalled) << describe(result);
  EXPECT_EQ(result.signal, SIGKILL);
}

TEST_P(SandboxProcesses, TheFirstProcessCannotBeKilled) {
  if (delegated()) return;
  const Result result = run(attack("killInit"));
  EXPECT_EQ(result.end, End::exited) << describe(result);
  EXPECT_EQ(result.exitCode, 5);
}

TEST_P(SandboxProcesses, CancellingTakesATenthOfASecond) {
  if (delegated()) return;
  const std::string mark = marker();
  auto quickest = std::chrono::steady_clock::duration::max();
  // More than once: another program may have the processor just then.
  for (int attempt = 0; attempt < 5 && quickest > 100ms; ++attempt) {
    std::chrono::steady_clock::time_point asked;
    const Result result =
        runBeside(attack("outlive", {mark, "stay"}), [&](std::atomic<bool>& cancel) {
          std::this_thread::sleep_for(300ms);
          asked = std::chrono::steady_clock::now();
          cancel = true;
        });
    quickest = std::min(quickest, std::chrono::steady_clock::now() - asked);
    EXPECT_EQ(result.end, End::interrupted) << describe(result);
    EXPECT_EQ(result.detail, "interrupted");
  }
  EXPECT_LT(quickest, 100ms);
  EXPECT_THAT(processesWith(mark), IsEmpty());
}

// bwrap that is killed between its fork and its word to the child leaves a child that waits for
// that word for ever.
TEST_P(SandboxProcesses, CancellingWhileTheSandboxStartsLeavesNothing) {
  if (delegated()) return;
  ASSERT_EQ(prctl(PR_SET_CHILD_SUBREAPER, 1), 0); // what is left becomes our child
  for (int attempt = 0; attempt < 60; ++attempt) {
    const Result result = runBeside(attack("sleep", {marker()}), [&](std::atomic<bool>&) {
      std::this_thread::sleep_for(attempt * 500us);
    });
    EXPECT_EQ(result.end, End::interrupted) << describe(result);
    ASSERT_TRUE(childrenEnd(1s)) << attempt * 500 << " microseconds after the start";
  }
}

TEST_P(SandboxProcesses, RunsBesideEachOtherHaveDistinctUids) {
  if (delegated()) return;
  const std::string marks[] = {marker() + "!", marker() + "!", marker() + "!"};
  std::atomic<bool> cancel = false;
  std::vector<std::thread> threads;
  for (const std::string& mark : marks)
    threads.emplace_back(
        [&, mark] { ggrade::sandbox::run(attack("sleep", {mark}), Isolation::bwrap, &cancel); });
  std::set<std::string> uids;
  for (const std::string& mark : marks) {
    for (int i = 0; i < 100 && processesWith(mark).empty(); ++i) std::this_thread::sleep_for(10ms);
    for (const int pid : processesWith(mark)) uids.insert(realUid(pid));
  }
  cancel = true;
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(uids.count("0"), 0u);
  EXPECT_EQ(uids.size(), geteuid() == 0 ? 3u : 1u);
}

// Neither sees the other's claim, and each would take the other's processes for left over.
TEST(SandboxLeftOver, IsNotWhatRunsInAnotherNetwork) {
  if (geteuid() != 0) GTEST_SKIP() << "needs root";
  const uid_t here = ggrade::sandbox::WorkerUid().get();
  std::set<uid_t> all = {here};
  for (int i = 0; i < 8; ++i) {
    uid_t there = 0;
    std::thread([&] {
      if (unshare(CLONE_NEWNET) == 0) there = ggrade::sandbox::WorkerUid().get();
    }).join();
    all.insert(there);
  }
  // Of 606; now and then two are the same.
  EXPECT_GE(all.size(), 7U);
  for (const uid_t uid : all) EXPECT_TRUE(uid >= 60578 && uid <= 61183) << uid;
}

// What a killed tool leaves behind: a bwrap that nobody waits for any more, say.
TEST(SandboxLeftOver, IsEndedByTheNextRunWithTheSameUid) {
  if (geteuid() != 0) GTEST_SKIP() << "needs root";
  const uid_t uid = ggrade::sandbox::WorkerUid().get(); // the next run's, or a neighbour's
  const pid_t child = fork();
  if (child == 0) {
    if (setresuid(uid, uid, uid) != 0) _exit(1);
    for (;;) pause();
  }
  while (realUid(child) != std::to_string(uid)) std::this_thread::sleep_for(1ms);
  Command command;
  command.arguments = {"/bin/true"};
  command.limits.wallSeconds = 10;
  EXPECT_EQ(run(command, Isolation::bwrap).exitCode, 0);
  int status = 0;
  pid_t ended = 0;
  for (int tries = 0; tries < 500 && ended == 0; ++tries) {
    ended = waitpid(child, &status, WNOHANG);
    if (ended == 0) std::this_thread::sleep_for(10ms);
  }
  EXPECT_TRUE(ended == child && WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << status;
  if (ended == 0) kill(child, SIGKILL);
}
