// Every way that a run can end is told apart.
#include "sandbox_fixture.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <linux/capability.h>
#include <sched.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace fs = std::filesystem;
using namespace ggrade::sandbox;
using testing::HasSubstr;
using testing::MatchesRegex;

SANDBOX_SUITE(SandboxEnds);

TEST_P(SandboxEnds, IsAvailable) {
  if (delegated()) return;
  const SelfTest test = selfTest();
  EXPECT_EQ(test.problem, std::nullopt);
  EXPECT_EQ(test.refused.size(), 16U);
  EXPECT_THAT(test.refused, testing::Contains("opening a socket"));
}

TEST_P(SandboxEnds, ExitCodes) {
  if (delegated()) return;
  for (const int code : {0, 1, 7, 126, 127, 128 + SIGSEGV, 255}) {
    const Result result = run(attack("exit", {std::to_string(code)}));
    EXPECT_EQ(result.end, End::exited) << describe(result);
    EXPECT_EQ(result.exitCode, code);
    EXPECT_EQ(result.detail, "exit code " + std::to_string(code));
  }
}

TEST_P(SandboxEnds, Signals) {
  if (delegated()) return;
  for (const int number : {SIGHUP, SIGINT, SIGQUIT, SIGILL, SIGTRAP, SIGABRT, SIGBUS, SIGFPE,
                           SIGKILL, SIGSEGV, SIGPIPE, SIGTERM, SIGUSR1, SIGSYS}) {
    const Result result = run(attack("signal", {std::to_string(number)}));
    EXPECT_EQ(result.end, End::signalled) << number << describe(result);
    EXPECT_EQ(result.signal, number);
    EXPECT_THAT(result.detail, HasSubstr("signal " + std::to_string(number) + " (SIG"));
  }
}

/// What the kernel ends a process with that used up its own processor time.
TEST_P(SandboxEnds, ASignalOfTheProcessorLimitIsTheLimit) {
  if (delegated()) return;
  const Result result = run(attack("signal", {std::to_string(SIGXCPU)}));
  EXPECT_EQ(result.end, End::timeLimit) << describe(result);
}

TEST_P(SandboxEnds, Faults) {
  if (delegated()) return;
  const std::pair<const char*, int> faults[] = {
      {"segv", SIGSEGV}, {"stack", SIGSEGV}, {"fpe", SIGFPE}, {"ill", SIGILL}, {"abrt", SIGABRT}};
  for (const auto& [kind, number] : faults) {
    const Result result = run(attack("fault", {kind}));
    EXPECT_EQ(result.end, End::signalled) << kind << describe(result);
    EXPECT_EQ(result.signal, number) << kind;
    EXPECT_FALSE(fs::exists("core"));
  }
}

TEST_P(SandboxEnds, SetupFailedSaysWhy) {
  if (delegated()) return;
  const auto detail = [](const Command& command) {
    const Result result = run(command);
    EXPECT_EQ(result.end, End::setupFailed) << describe(result);
    return result.detail;
  };
  Command command;
  EXPECT_EQ(detail(command), "the command must be an absolute path");
  command.arguments = {"true"};
  EXPECT_EQ(detail(command), "the command must be an absolute path");
  command.arguments = {"/usr/bin/there-is-no-such-program"};
  EXPECT_EQ(detail(command),
            "cannot start /usr/bin/there-is-no-such-program: No such file or directory");
  command.arguments = {"/usr/bin/true", std::string("a\0b", 3)};
  EXPECT_EQ(detail(command), "an argument holds a NUL byte");
  command.arguments = {"/usr/bin/true"};
  command.workingDirectory = "/nowhere";
  EXPECT_EQ(detail(command), "cannot enter /nowhere: No such file or directory");
  command.workingDirectory = "/scratch";
  command.mounts = {{folder() + "/missing", "/missing"}};
  EXPECT_EQ(detail(command), "cannot mount " + folder() + "/missing: it does not exist");
  command.mounts = {{folder(), "/usr"}};
  EXPECT_EQ(detail(command), "mount point /usr is the sandbox's own");
  command.mounts = {{folder(), "/a/../b"}};
  EXPECT_EQ(detail(command), "mount point /a/../b is not a plain absolute path");
  command.mounts = {};
  command.collect.assign(9, {"/scratch/product", folder() + "/product"});
  EXPECT_EQ(detail(command), "at most 8 files can be collected");
  command.collect = {{"/scratch/product", folder() + "/no/folder"}};
  EXPECT_EQ(detail(command), "cannot write " + folder() + "/no/folder: No such file or directory");
  command.collect = {};
  command.inheritedDescriptor = 1;
  EXPECT_EQ(detail(command), "descriptors 0 to 2 cannot be inherited");
  command.inheritedDescriptor = 4000;
  EXPECT_EQ(detail(command), "the inherited descriptor is not open");
}

// For an ordinary user the worker is the user itself.
class SandboxWorker : public Sandbox {};
INSTANTIATE_TEST_SUITE_P(As, SandboxWorker, testing::Values("root"));

TEST_P(SandboxWorker, IsNamedWhenItMayNotReadAFolder) {
  fs::create_directory(folder() + "/locked");
  fs::permissions(folder() + "/locked", fs::perms(0700));
  Command command = attack("exit", {"0"});
  command.mounts.push_back({folder() + "/locked", "/locked"});
  const Result result = run(command);
  EXPECT_EQ(result.end, End::setupFailed);
  EXPECT_EQ(result.detail, "the sandbox's user may not read " + folder() +
                               "/locked: Permission denied (remedy: chmod -R go+rX " + folder() +
                               "/locked)");
  // A folder below one that only root may enter, like a clone in /root, works.
  fs::create_directory(folder() + "/locked/open");
  command.mounts.back() = {folder() + "/locked/open", "/open"};
  EXPECT_EQ(run(command).end, End::exited) << describe(run(command));
}

TEST_P(SandboxEnds, AFileThatCannotBeExecutedIsNotOurFault) {
  if (delegated()) return;
  std::ofstream(folder() + "/data/program") << "no program\n";
  fs::permissions(folder() + "/data/program", fs::perms(0755));
  Command command = attack("exit");
  command.arguments = {"/attack/data/program"};
  const Result result = run(command);
  EXPECT_EQ(result.end, End::exited) << describe(result);
  EXPECT_EQ(result.exitCode, 126);
  EXPECT_EQ(result.detail, "cannot execute /attack/data/program: Exec format error");
}

/// As where another thread starts a process just when the program was written.
TEST_P(SandboxEnds, AProgramThatIsStillOpenForWritingIsWaitedFor) {
  if (delegated()) return;
  const std::string program = folder() + "/data/program";
  fs::copy_file("/bin/true", program);
  Command command = attack("exit");
  command.arguments = {"/attack/data/program"};
  std::ofstream open(program, std::ios::binary | std::ios::in);
  ASSERT_TRUE(open);
  std::thread closer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    open.close();
  });
  const Result result = run(command);
  closer.join();
  EXPECT_EQ(result.end, End::exited) << describe(result);
  EXPECT_EQ(result.exitCode, 0) << describe(result);
}

// In a user namespace of its own, whose settings hurt nobody.
TEST(SandboxUnavailable, SaysWhyWithTheRemedy) {
  if (geteuid() != 0) GTEST_SKIP() << "needs root";
  int ready[2], go[2], answer[2];
  ASSERT_EQ(pipe(ready) | pipe(go) | pipe(answer), 0);
  const pid_t child = fork();
  if (child == 0) {
    char byte = 0;
    if (unshare(CLONE_NEWUSER) != 0 || write(ready[1], "x", 1) != 1 || read(go[0], &byte, 1) != 1)
      _exit(1);
    std::string text = selfTest().problem.value_or("available") + "; ";
    std::ofstream("/proc/sys/user/max_user_namespaces") << 0;
    text += selfTest().problem.value_or("available");
    (void)!write(answer[1], text.data(), text.size());
    _exit(0);
  }
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  for (const char* map : {"uid_map", "gid_map"})
    std::ofstream("/proc/" + std::to_string(child) + "/" + map) << "0 0 65536";
  ASSERT_EQ(write(go[1], "x", 1), 1);
  std::string text(1000, '\0');
  text.resize(static_cast<std::size_t>(read(answer[0], text.data(), text.size())));
  waitpid(child, nullptr, 0);
  EXPECT_EQ(text,
            "available; user namespaces are off. Remedy: sysctl user.max_user_namespaces=10000");
  for (const int end : {ready[0], ready[1], go[0], go[1], answer[0], answer[1]}) close(end);
}

// As in a container that runs as root.
TEST(SandboxUnavailable, ToRootWithoutTheRightToTrace) {
  if (geteuid() != 0) GTEST_SKIP() << "needs root";
  int answer[2];
  ASSERT_EQ(pipe(answer), 0);
  const pid_t child = fork();
  if (child == 0) {
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    __user_cap_data_struct rights[2];
    if (syscall(SYS_capget, &header, rights) != 0) _exit(1);
    rights[0].effective &= ~(1U << CAP_SYS_PTRACE);
    if (syscall(SYS_capset, &header, rights) != 0) _exit(1);
    const std::string text = selfTest().problem.value_or("available");
    (void)!write(answer[1], text.data(), text.size());
    _exit(0);
  }
  std::string text(1000, '\0');
  text.resize(static_cast<std::size_t>(read(answer[0], text.data(), text.size())));
  waitpid(child, nullptr, 0);
  EXPECT_THAT(text, testing::AllOf(HasSubstr("(CAP_SYS_PTRACE)"), HasSubstr("--user 1000:1000")));
  for (const int end : answer) close(end);
}

SANDBOX_SUITE(SandboxNone);

TEST_P(SandboxNone, LimitsHoldWithoutASandbox) {
  if (delegated()) return;
  Command command;
  command.workingDirectory = "/tmp";
  const auto outcome = [&](const std::string& script, double wallSeconds = 30) {
    command.arguments = {"/bin/sh", "-c", script};
    command.environment = {{"PATH", "/usr/bin"}};
    command.limits.wallSeconds = wallSeconds;
    return ggrade::sandbox::run(command, Isolation::none);
  };
  EXPECT_EQ(outcome("exit 9").exitCode, 9);
  EXPECT_EQ(outcome("kill -ABRT $$").signal, SIGABRT);
  EXPECT_EQ(outcome("ls /proc/self/fd").standardOutput, "0\n1\n2\n3\n");
  const std::string mark = marker();
  const Result late =
      outcome("setsid sh -c 'while :; do sleep 1; done; # " + mark + "' & sleep 60", 0.5);
  EXPECT_EQ(late.end, End::timeLimit) << describe(late);
  EXPECT_TRUE(processesWith(mark).empty());
  command.limits.memoryBytes = 50 << 20;
  const Result large = outcome("x=$(head -c 200000000 /dev/zero | tr '\\0' x); sleep 60");
  EXPECT_EQ(large.end, End::memoryLimit) << describe(large);
}

TEST_P(SandboxNone, WhatItCannotDoIsRefused) {
  if (delegated()) return;
  Command command;
  command.arguments = {"/usr/bin/true"};
  command.workingDirectory = "/tmp";
  command.mounts = {{folder(), folder()}};
  EXPECT_EQ(ggrade::sandbox::run(command, Isolation::none).end, End::exited);
  command.mounts = {{folder(), "/elsewhere"}};
  EXPECT_EQ(ggrade::sandbox::run(command, Isolation::none).detail,
            "without a sandbox " + folder() + " cannot appear as /elsewhere");
  command.mounts = {};
  command.privateCopies = {{folder(), "/copy"}};
  EXPECT_EQ(ggrade::sandbox::run(command, Isolation::none).detail,
            "without a sandbox there are no private copies");
}
