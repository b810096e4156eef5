// Memory, disk space and output have limits that hold for the whole tree.
#include "sandbox_fixture.hpp"

#include <gmock/gmock.h>

using namespace ggrade::sandbox;
using testing::HasSubstr;
using testing::MatchesRegex;

SANDBOX_SUITE(SandboxMemory);

namespace {
constexpr std::uint64_t kMegabyte = 1 << 20;

void expectMemoryLimit(const Result& result) {
  EXPECT_EQ(result.end, End::memoryLimit) << describe(result);
  EXPECT_THAT(result.detail,
              MatchesRegex("memory: [0-9.]+ MB in [0-9]+ processes, limit 100.0 MB"));
  EXPECT_GT(result.peakMemoryBytes, 100 * kMegabyte);
  // Caught soon enough that it cannot hurt the host.
  EXPECT_LT(result.peakMemoryBytes, 500 * kMegabyte);
  EXPECT_LT(result.wallSeconds, 9);
}
/// With time enough to meet the memory limit on a busy machine too.
Command unhurried(Command command) {
  command.limits.wallSeconds = 10;
  command.limits.cpuSeconds = 10;
  return command;
}
} // namespace

TEST_P(SandboxMemory, OneProcess) {
  if (delegated()) return;
  expectMemoryLimit(run(unhurried(attack("plain"))));
}

TEST_P(SandboxMemory, ManySmallProcesses) {
  if (delegated()) return;
  expectMemoryLimit(run(unhurried(attack("many", {"15", "10"}))));
}

/// Each started by a thread of its own; in all more threads than are kept in sight between two
/// looks.
TEST_P(SandboxMemory, ManySmallProcessesOfManyThreads) {
  if (delegated()) return;
  expectMemoryLimit(run(unhurried(attack("manyThreads", {"9", "15"}))));
}

TEST_P(SandboxMemory, ProcessesBelowTheLimitLive) {
  if (delegated()) return;
  const Result result = run(attack("many", {"8", "10"}));
  EXPECT_EQ(result.end, End::timeLimit) << describe(result);
  EXPECT_GT(result.peakMemoryBytes, 80 * kMegabyte);
  EXPECT_LT(result.peakMemoryBytes, 100 * kMegabyte);
}

TEST_P(SandboxMemory, FilesAndHeapTogether) {
  if (delegated()) return;
  // 16 MB in each tmpfs and 75 MB of heap: only the sum is too much.
  Command command = attack("fill", {"/scratch", "75"});
  EXPECT_EQ(run(command).end, End::timeLimit);
  command.limits.scratchBytes = 40 << 20;
  expectMemoryLimit(run(unhurried(command)));
}

TEST_P(SandboxMemory, EmptyFiles) {
  if (delegated()) return;
  Command command = attack("emptyFiles");
  command.limits.wallSeconds = 20;
  command.limits.cpuSeconds = 20;
  const Result result = run(command);
  EXPECT_EQ(result.end, End::memoryLimit) << describe(result);
}

TEST_P(SandboxMemory, NoAddressSpaceWithoutEnd) {
  if (delegated()) return;
  expectRefused("addressSpace");
}

TEST_P(SandboxMemory, NoMemoryThatCannotBeCounted) {
  if (delegated()) return;
  expectRefused("hidden");
}

TEST_P(SandboxMemory, WritableFoldersAreSized) {
  if (delegated()) return;
  for (const char* folder : {"/scratch", "/tmp"}) {
    const Result result = run(attack("fill", {folder}));
    EXPECT_EQ(result.end, End::exited) << describe(result);
    EXPECT_EQ(result.standardOutput, "16777216 No space left on device\n");
  }
  for (const char* folder : {"/dev/shm", "/dev", "/run", "/"}) {
    const Result result = run(attack("fill", {folder}));
    EXPECT_THAT(result.standardOutput,
                MatchesRegex("0 (No such file or directory|Read-only file system)\n"))
        << folder;
  }
}

TEST_P(SandboxMemory, LargeFile) {
  if (delegated()) return;
  const Result result = run(attack("largeFile"));
  EXPECT_EQ(result.end, End::signalled) << describe(result);
  EXPECT_EQ(result.signal, SIGXFSZ);
  EXPECT_EQ(result.detail, "signal 25 (SIGXFSZ): a file beyond 8.0 MB");
}

TEST_P(SandboxMemory, SparseFile) {
  if (delegated()) return;
  expectRefused("sparseFile");
}

TEST_P(SandboxMemory, OutputIsCappedAndTheRestDropped) {
  if (delegated()) return;
  const Result result = run(unhurried(attack("flood", {"20"})));
  EXPECT_EQ(result.end, End::exited) << describe(result);
  EXPECT_EQ(result.standardOutput.size(), 64u << 10);
  EXPECT_EQ(result.standardOutput.substr(0, 32), "0123456789abcde\n0123456789abcde\n");
  EXPECT_EQ(result.standardError, "last words\n");
  EXPECT_TRUE(result.outputTruncated);
}

TEST_P(SandboxMemory, EndlessOutputMeetsTheTimeLimit) {
  if (delegated()) return;
  const Result result = run(attack("flood", {"100000000"}));
  EXPECT_EQ(result.end, End::timeLimit) << describe(result);
  EXPECT_LT(result.wallSeconds, 4);
  EXPECT_EQ(result.standardOutput.size(), 64u << 10);
}

TEST_P(SandboxMemory, ShortOutputIsWhole) {
  if (delegated()) return;
  Command command;
  command.arguments = {"/bin/sh", "-c", "printf 'out\\0put\\377'; printf error >&2"};
  const Result result = run(command);
  EXPECT_EQ(result.standardOutput, std::string("out\0put\377", 8));
  EXPECT_EQ(result.standardError, "error");
  EXPECT_FALSE(result.outputTruncated);
}
