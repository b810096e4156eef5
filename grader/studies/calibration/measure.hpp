#pragma once
/// \file
/// Grades every program with every seed.

#include "calibration/look.hpp"
#include "calibration/programs.hpp"

namespace ggrade::calibration {

struct MeasureOptions {
  std::vector<std::uint64_t> seeds;
  std::vector<Look> looks = {Look{}}; ///< quickest if those of one size and quality stand together
  unsigned jobs = grading::workers(); ///< gradings at a time, each on one thread
  grading::Progress progress;
};

/// Builds each program once and grades it as `ggrade grade` does, but for the report's pictures.
/// What was graded before with the same tool, program, scenes and points is taken from the cache
/// (`GGRADE_CACHE`/scores); the pictures of the reference are kept for the assignment's own seed
/// only. What can't be judged is an error, but with scaled windows an outcome. A patch that doesn't
/// apply is its program's `problem`; the rest goes on. Returns the programs by look. Throws
/// UsageError, and Interrupted, which loses only the gradings that were under way.
std::vector<std::vector<Measured>> measure(const Target& target,
                                           const std::filesystem::path& solutionFolder,
                                           const std::vector<KnownAnswer>& programs,
                                           const MeasureOptions& options);

} // namespace ggrade::calibration
