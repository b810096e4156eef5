#pragma once
/// \file
/// Grading a class.

#include "batch/pool.hpp"
#include "batch/record.hpp"
#include "batch/state.hpp"
#include "gradebook/lateness.hpp"
#include "grading/references.hpp"

namespace ggrade::batch {

/// Every `of`-th upload, from number `index` (from 1) on.
struct Shard {
  unsigned index = 1, of = 1;
};

struct BatchOptions {
  std::filesystem::path uploads, out;
  grading::Draw draw;
  unsigned jobs = 1;
  bool resume = false, regrade = false;
  std::vector<std::string> only; ///< students' keys, names or folders; empty: all
  Shard shard;
  report::Reveal reveal = report::Reveal::names;
  bool diagnosis = true;
  std::string selfTest; ///< what the sandbox was seen to do, in words; empty: there is none
};

/// One finished submission, for who shows progress.
struct Step {
  std::size_t done, total; ///< of this run
  std::string name;
  const Reply& reply;
};

struct Outcome {
  std::size_t graded = 0;              ///< in this run
  std::size_t kept = 0;                ///< results of an earlier one that still hold
  std::vector<std::string> unfinished; ///< "name: reason", our fault; nothing was written for them
  std::vector<report::ScoreChange> changes; ///< since the last finished run, drops first
  std::vector<std::string> refused;         ///< of the folder of uploads, "name: why"
  std::vector<std::string> remarks;         ///< on it, besides
};

/// Grades what there is to grade into folders of `options.out`: one a submission, each written
/// aside and moved into place in one step. A folder that an earlier run has filled is gone on with
/// (`resume`: what is missing, not gradable, or changed since, the grader included) or done again
/// (`regrade`); neither: UsageError. Throws Interrupted; what is graded stays.
Outcome gradeClass(const Target& target, const std::filesystem::path& solutionFolder,
                   const BatchOptions& options, const grading::Progress& preparing,
                   const std::function<void(const Step&)>& step);

} // namespace ggrade::batch
