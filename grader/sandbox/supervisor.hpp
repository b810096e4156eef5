#pragma once
/// \file
/// Watches one started helper until nothing of it is left.

#include "descriptor.hpp"
#include "helper_plan.hpp"
#include "process_tree.hpp"
#include "sandbox.hpp"

#include <chrono>

namespace ggrade::sandbox {

/// The supervisor's ends of what it shares with the helper.
struct Connections {
  Descriptor standardOutput; ///< read ends, non-blocking
  Descriptor standardError;
  Descriptor reports;
  Descriptor info;     ///< bwrap tells the pid of the namespace's init here
  Descriptor lifeline; ///< write end; closing it ends a run without a namespace
};

class Supervisor {
public:
  /// `helper` is the started child of this process; `writableFolders` every tmpfs inside.
  Supervisor(const Limits& limits, Connections connections, pid_t helper, bool inNamespace,
             std::vector<std::string> writableFolders);

  /// Returns when the helper and everything that it started is gone.
  Result watch(const std::atomic<bool>* cancel);
  /// After `watch`: whether collected file `n` was executable inside.
  bool wasExecutable(std::size_t n) const { return executables_ >> n & 1; }

private:
  using Clock = std::chrono::steady_clock;

  void wait(std::chrono::milliseconds longest);
  void readReports();
  void readInfo();
  void checkLimits(const std::atomic<bool>* cancel);
  void stop(End end, std::string detail);
  void killNamespace() const;
  bool helperIsGone();
  void conclude();
  double secondsSince(Clock::time_point start) const;

  const Limits limits_;
  Connections connections_;
  const pid_t helper_;
  const bool inNamespace_;
  const std::vector<std::string> writableFolders_;
  const Descriptor helperEnd_; ///< pidfd of the helper

  ProcessTree tree_;
  Descriptor init_; ///< pidfd of the namespace's init
  pid_t initPid_ = -1;
  std::string info_;
  Clock::time_point spawned_ = Clock::now();
  Clock::time_point started_{};
  Clock::time_point measured_{};
  Clock::time_point stopped_{};
  std::vector<HelperReport> reports_;
  Usage last_;
  bool begun_ = false; ///< the helper reported that the command runs
  bool measurable_ = false;
  bool stopping_ = false;
  int helperStatus_ = 0;
  double helperCpuSeconds_ = 0;
  std::uint32_t executables_ = 0;
  Result result_;
};

} // namespace ggrade::sandbox
