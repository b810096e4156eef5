#pragma once
/// \file
/// Grading one submission, from the upload to a result that the reports are written from.

#include "grading/references.hpp"
#include "report/results.hpp"

#include <optional>

namespace ggrade::grading {

struct GradeOptions {
  std::filesystem::path upload;
  bool solution =
      false; ///< `upload` is a trusted folder of solutions/, its other files are expected
  std::optional<std::uint64_t> seed;
  std::vector<std::string> judgeArguments; ///< GoogleTest's
  Progress progress;
};

/// Overlays, builds, renders and judges. The result's outcome says how that went; faults of the
/// instructor's side (no such folder, a broken reference) are UsageErrors. Throws Interrupted.
report::Result grade(const Target& target, const std::filesystem::path& solutionFolder,
                     const GradeOptions& options);

} // namespace ggrade::grading
