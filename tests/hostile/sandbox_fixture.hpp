#pragma once
/// \file
/// What the sandbox tests share: every test runs as root and as an ordinary user, with tight
/// limits.

#include "grader/sandbox/sandbox.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

/// Parameter: "root" or "user". As root the "user" tests run this program again under an unused
/// uid; as an ordinary user the "root" tests are skipped.
class Sandbox : public testing::TestWithParam<const char*> {
protected:
  void SetUp() override;
  void TearDown() override;

  /// True when the test was handed to another process, whose failures are ours.
  bool delegated();

  /// The attack program with limits that no attack can hurt the host in:
  /// 2 s wall, 3 s processor time, 100 MB, files of 8 MB, 16 MB of scratch, 20 processes, 64 kB of
  /// output.
  ggrade::sandbox::Command attack(const std::string& name,
                                  const std::vector<std::string>& arguments = {}) const;
  /// Runs it in the sandbox.
  static ggrade::sandbox::Result run(const ggrade::sandbox::Command& command);
  /// Runs an attack of which every attempt must fail.
  void expectRefused(const std::string& name, const std::vector<std::string>& arguments = {}) const;

  /// A string that no other process has in its command line.
  std::string marker() const;
  /// Pids on the host whose command line holds the marker.
  std::vector<int> processesWith(const std::string& marker) const;

  const std::string& folder() const { return folder_; }     ///< of this test, on the host, 0755
  const std::string& programs() const { return programs_; } ///< sources of the programs

private:
  std::string folder_;
  std::string programs_;
};

#define SANDBOX_SUITE(name)                                                                        \
  class name : public Sandbox {};                                                                  \
  INSTANTIATE_TEST_SUITE_P(As, name, testing::Values("root", "user"),                              \
                           [](const auto& parameter) { return std::string(parameter.param); })

/// Prints a result whole, so that a failure explains itself.
std::string describe(const ggrade::sandbox::Result& result);
