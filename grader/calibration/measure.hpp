#pragma once
/// \file
/// Grades every program with every seed.

#include "calibration/programs.hpp"
#include "grading/references.hpp"

namespace ggrade::calibration {

struct MeasureOptions {
  std::vector<std::uint64_t> seeds;
  grading::Quality quality = grading::Quality::balanced;
  unsigned jobs = grading::workers(); ///< gradings at a time, each on one thread
  grading::Progress progress;
};

/// Builds each program once and grades it as `ggrade grade` does, but for the report's pictures.
/// What was graded before with the same tool, program, scenes and points is taken from the cache
/// (`GGRADE_CACHE`/scores); the pictures of the reference are kept for the assignment's own seed
/// only. A patch that doesn't apply is its program's `problem`; the rest goes on. Throws
/// UsageError, and Interrupted, which loses only the gradings that were under way.
std::vector<Measured> measure(const Target& target, const std::filesystem::path& solutionFolder,
                              const std::vector<Program>& programs, const MeasureOptions& options);

} // namespace ggrade::calibration
