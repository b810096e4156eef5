#pragma once
/// \file
/// A result becomes a folder.

#include "batch/job.hpp"
#include "report/results.hpp"
#include "report/reveal.hpp"

namespace ggrade::batch {

struct Destination {
  std::filesystem::path out; ///< of the class
  report::Reveal reveal = report::Reveal::names;
  std::string grader; ///< as in Record
  unsigned run = 1;
};

/// Writes pages and record of `job` aside and moves them to their folder in one step; what stood
/// there is replaced. Throws with the remedy if that can't be done, and leaves nothing.
void publish(report::Result result, const Job& job, const Destination& destination);

} // namespace ggrade::batch
