#pragma once
/// \file
/// Programs that are kept as a patch of the solution: examples, mistakes, variants.

#include "assignment/assignment.hpp"

#include <map>

namespace ggrade::grading {

/// The `Key: value` lines before a patch's first `diff --git` line. Continuation lines are
/// indented. Throws UsageError.
std::map<std::string, std::string> patchHeader(const std::filesystem::path& patch);

/// Writes the solution's editable files to `into` (made if missing) and applies `patch`, a `git
/// diff` from the repository's root. Throws UsageError, naming the patch, when it doesn't apply
/// exactly.
void writePatched(const Assignment& assignment, const std::filesystem::path& solutionFolder,
                  const std::filesystem::path& patch, const std::filesystem::path& into);

} // namespace ggrade::grading
