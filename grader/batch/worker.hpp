#pragma once
/// \file
/// A process that grades one upload after the other.

#include "assignment/assignment.hpp"
#include "grading/scenes.hpp"
#include "report/reveal.hpp"

#include <optional>

namespace ggrade::batch {

struct WorkerOptions {
  std::filesystem::path out; ///< results go to folders in it
  grading::Draw draw;
  report::Reveal reveal = report::Reveal::names;
  bool diagnosis = true;
  unsigned run = 1;
};

/// Says "ready" on standard output, then takes jobs from standard input, a line of JSON each, and
/// answers each with a line, until the input ends. What goes wrong with a job is its reply; throws
/// only where no job at all can be done, and Interrupted. Ends at once if the parent does.
void work(const Target& target, const std::filesystem::path& solutionFolder,
          const WorkerOptions& options);

} // namespace ggrade::batch
