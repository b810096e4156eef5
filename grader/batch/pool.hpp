#pragma once
/// \file
/// Worker processes, and what becomes of the jobs that they are given.

#include "batch/job.hpp"

#include <functional>
#include <vector>

namespace ggrade::batch {

struct PoolOptions {
  std::string program = "/proc/self/exe";
  std::vector<std::string> worker; ///< its words, as for execv
  unsigned processes = 1;
  std::string temporary; ///< TMPDIR of the workers
  /// More than the limits of everything that is done for a submission; beyond it the worker itself
  /// must be stuck, which is our fault.
  double seconds = 900;
};

/// Called with the number of a job and its last reply. A `problem` there says that two attempts
/// failed and nothing was written.
using Replied = std::function<void(std::size_t job, const Reply& reply)>;

/// Hands every job to the next idle worker. A job that fails by our own fault (the worker died or
/// was stuck, the disk is full, `not_gradable`) is tried once more, with a new worker if its own is
/// gone. Throws std::runtime_error where workers can't be started, and Interrupted; no worker is
/// left then.
void runJobs(const std::vector<Job>& jobs, const PoolOptions& options, const Replied& answered);

} // namespace ggrade::batch
