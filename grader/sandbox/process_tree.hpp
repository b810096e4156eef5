#pragma once
/// \file
/// What a run uses right now: memory, processor time, processes.

#include "descriptor.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ggrade::sandbox {

struct Usage {
  std::uint64_t memoryBytes =
      0; ///< private memory, page tables and swap of all processes, plus files in memory
  double cpuSeconds = 0; ///< of living processes and of the dead that their parents waited for
  int processes = 0;
};

/// Measures a run from outside, through the host's /proc: inside a namespace there is none.
class ProcessTree {
public:
  /// Counts the init of a PID namespace, which has `pid` here, with all its descendants, which are
  /// the namespace's members, since orphans become its children, and the contents of
  /// `writableFolders`, each a tmpfs inside. False when the namespace is gone already.
  bool openNamespace(pid_t pid, const std::vector<std::string>& writableFolders);
  /// Counts `pid` and its descendants, for runs without a namespace.
  void openDescendants(pid_t pid) { root_ = pid; }

  /// The sum over what lives at this moment. All zero before an `open...` and after the end.
  Usage measure();

private:
  /// False when some process ended meanwhile.
  bool addProcesses(Usage& usage);
  void addFolders(Usage& usage) const;
  std::string childrenOf(int proc, const std::string& thread);

  struct Thread {
    Descriptor children; ///< its file of that name in /proc
    bool isListed = true;
  };
  std::map<std::string, Thread> threads_; ///< by PID/task/TID

  std::vector<Descriptor> folders_;
  pid_t root_ = 0;
  bool inNamespace_ = false;
};

} // namespace ggrade::sandbox
