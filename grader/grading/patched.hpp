#pragma once
/// \file
/// Programs that are kept as a patch of the solution: examples, mistakes, variants.

#include "assignment/assignment.hpp"

#include <map>

namespace ggrade::grading {

/// The `Key: value` lines before a patch's first `diff --git` line. Continuation lines are
/// indented. Throws UsageError, also where one of the keys `needed` is not there or a key is there
/// twice.
std::map<std::string, std::string> patchHeader(const std::filesystem::path& patch,
                                               const std::vector<std::string>& needed = {
                                                   "Title", "Grades", "Outcome"});

/// Names of the files of `solutions/ID/` that a patch changes or adds. Throws UsageError for a path
/// elsewhere.
std::vector<std::string> patchedFiles(const Assignment& assignment,
                                      const std::filesystem::path& patch);

/// Writes the solution's own files to `into` (made if missing) and applies `patches`, one after the
/// other: each a `git diff` from the repository's root, which may add a file. Throws UsageError,
/// naming the patch, when one doesn't apply exactly.
void writePatched(const Assignment& assignment, const std::filesystem::path& solutionFolder,
                  const std::vector<std::filesystem::path>& patches,
                  const std::filesystem::path& into);

} // namespace ggrade::grading
