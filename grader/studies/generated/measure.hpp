#pragma once
/// \file
/// Grades programs that were generated.

#include "generated/figures.hpp"
#include "grading/parallel.hpp"
#include "grading/progress.hpp"
#include "grading/scenes.hpp"

namespace ggrade::generated {

struct MeasureOptions {
  std::size_t count = 100; ///< wrong programs, and as many right ones
  std::uint64_t seed = 1;  ///< programs and hidden scenes are drawn by it
  std::size_t scenes = 200;
  grading::Quality quality = grading::Quality::balanced;
  unsigned jobs = grading::workers();
  grading::Progress progress;
};

/// Generates the programs of one part (the only one of `target`), writes them below
/// `folder`/programs, and grades each once, with a diagnosis. Gradings are kept in the cache, so
/// that what was broken off goes on. Throws UsageError and Interrupted.
Figures measure(const Target& target, const std::filesystem::path& solutionFolder,
                const std::filesystem::path& folder, const MeasureOptions& options);

} // namespace ggrade::generated
