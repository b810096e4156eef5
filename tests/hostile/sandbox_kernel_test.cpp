// The system calls that the filter refuses.
#include "sandbox_fixture.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <future>
#include <iostream>
#include <limits>

using namespace ggrade::sandbox;

SANDBOX_SUITE(SandboxKernel);

TEST_P(SandboxKernel, NoSockets) {
  if (delegated()) return;
  expectRefused("socket");
}

TEST_P(SandboxKernel, NoTracing) {
  if (delegated()) return;
  expectRefused("trace");
}

TEST_P(SandboxKernel, NoNamespaces) {
  if (delegated()) return;
  expectRefused("namespace");
}

TEST_P(SandboxKernel, NoKeyringsNoBpfNoOthers) {
  if (delegated()) return;
  expectRefused("kernel");
}

// Two sandboxes see the same system files: none may leave a note there, nor read one.
TEST_P(SandboxKernel, SharedFilesAreNoBlackboard) {
  if (delegated()) return;
  expectRefused("blackboard", {"/usr/bin/env"});
}

/// Memory of the kernel's that belongs to no process and can't be taken back, in bytes.
std::int64_t kernelMemory() {
  std::ifstream in("/proc/meminfo");
  for (std::string key; in >> key;)
    if (std::int64_t kilobytes = 0; key == "SUnreclaim:" && in >> kilobytes)
      return kilobytes * 1024;
  return 0;
}

// A million locks would be some 220 MB. What else a process can make the kernel keep is bounded by
// the numbers of its descriptors and mappings.
constexpr std::int64_t kLittle = 100 << 20;

TEST_P(SandboxKernel, KeepsLittleMemoryForACommand) {
  if (delegated()) return;
  ASSERT_GT(kernelMemory(), 0);
  // What others on the machine do at the time counts as well, but not each time.
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (int tries = 0; tries < 20 && least >= kLittle; ++tries) {
    const std::int64_t before = kernelMemory();
    std::int64_t most = 0;
    std::future<Result> run = std::async(std::launch::async, [&] {
      return SandboxKernel::run(attack("kernelMemory", {"/usr/bin/env"}));
    });
    while (run.wait_for(std::chrono::milliseconds(10)) != std::future_status::ready)
      most = std::max(most, kernelMemory() - before);
    const Result result = run.get();
    ASSERT_THAT(result.standardOutput, testing::StartsWith("0 locks, ")) << describe(result);
    std::cout << result.standardOutput << most / 1048576 << " MB\n";
    least = std::min(least, most);
  }
  EXPECT_LT(least, kLittle);
}

// With these arguments the kernel would answer something else.
TEST_P(SandboxKernel, TheFilterItselfRefuses) {
  if (delegated()) return;
  const Result result = run(attack("filter"));
  EXPECT_EQ(result.standardOutput, "keyctl 1\nptrace 1\nsocket 1\nunshare 1\nmount 1\nbpf 1\n"
                                   "memfd_create 1\nclone3 38\n")
      << describe(result);
}

TEST_P(SandboxKernel, ForeignCallsKill) {
  if (delegated()) return;
  for (const char* kind : {"i386", "x32"}) {
    const Result result = run(attack("foreign", {kind}));
    EXPECT_EQ(result.end, End::signalled) << describe(result);
    EXPECT_EQ(result.signal, SIGSYS);
  }
}
