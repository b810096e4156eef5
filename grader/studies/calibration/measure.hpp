#pragma once
/// \file
/// Grades every program with every seed, as closely as it is asked to look.

#include "calibration/programs.hpp"
#include "grading/references.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ggrade::calibration {

/// How closely a grading looks: the quality that `--quality` names, and less than any of them, to
/// learn what each scene and each pixel is worth.
struct Look {
  grading::Quality quality = grading::Quality::balanced;
  double scale = 1;                  ///< of the sides of the hidden scenes' windows
  std::optional<std::size_t> hidden; ///< only the first so many hidden scenes; none: all of them
  bool twice = false;                ///< the public scene's second run, see grading::GradeOptions
  bool measures = false;             ///< are the pictures compared by whole-image measures, too?

  bool operator==(const Look&) const = default;
};

/// "balanced", "balanced, windows x 0.5", "balanced, 2 hidden scenes".
std::string nameOf(const Look& look);

/// Multiplies the sides of the hidden scenes' windows, probes included, to whole pixels of at least
/// 1. Nothing else in the scenes changes, quality numbers neither. Throws UsageError for a scene
/// without a size.
void scaleWindows(grading::ScenePlan& plan, double scale);

/// How many of the plan's scenes come before the hidden scene after the first `hidden` ones, in the
/// order of scenes.json; all if it has no more.
std::size_t scenesUpTo(const grading::ScenePlan& plan, std::size_t hidden);

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
