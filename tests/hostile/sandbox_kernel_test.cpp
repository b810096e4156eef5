// The system calls that the filter refuses.
#include "sandbox_fixture.hpp"

#include <csignal>

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
