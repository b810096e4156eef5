#pragma once
/// \file
/// A process that grades one upload after the other.

#include "assignment/assignment.hpp"
#include "batch/job.hpp"
#include "grading/scenes.hpp"
#include "report/reveal.hpp"

#include <functional>
#include <optional>

namespace ggrade::batch {

struct WorkerOptions {
  std::filesystem::path out; ///< results go to folders in it
  grading::Draw draw;
  report::Reveal reveal = report::Reveal::names;
  bool diagnosis = true;
  unsigned run = 1;
};

/// A worker whose parent was killed must not go on beside the next run's.
void endWithParent();

/// Says "ready" on standard output, then takes jobs from standard input, a line of JSON each, and
/// answers each with a line, until the input ends. An exception of `grade` is its job's reply,
/// Interrupted excepted.
void answerJobs(const std::function<Reply(const Job&)>& grade);

/// Does so with a Grader that it keeps. Throws only where no job at all can be done, and
/// Interrupted. Ends at once if the parent does.
void work(const Target& target, const std::filesystem::path& solutionFolder,
          const WorkerOptions& options);

} // namespace ggrade::batch
