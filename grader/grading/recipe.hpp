#pragma once
/// \file
/// How a program is made: from a folder of files, with patches or with some of its TODOs filled in.

#include "assignment/assignment.hpp"

#include <map>
#include <optional>
#include <set>

namespace ggrade::grading {

/// What every program that is built and rendered is made of: the reference, the stub, a mistake, an
/// unfinished program, an upload.
/// \code
/// Recipe{solutions}                             // the reference
/// Recipe{solutions, {mistake.patch}}            // a mistake
/// Recipe{solutions, {}, {{"mirror.1"}}}         // the program with one step done
/// Recipe{upload}                                // what somebody handed in
/// \endcode
struct Recipe {
  std::filesystem::path folder; ///< a solution's with patches or `filled`, else any folder of files
  /// Applied one after the other: each a `git diff` from the repository's root, which may add a
  /// file.
  std::vector<std::filesystem::path> patches{};
  /// Only these TODOs are filled in; nothing: all that the folder has.
  std::optional<std::set<std::string>> filled{};

  bool isFolder() const { return patches.empty() && !filled; }
};

/// Writes the folder's own files to `into` (made if missing), applies the patches and takes out
/// what isn't filled in. Throws UsageError, naming the patch, when one doesn't apply exactly.
void writeFiles(const Assignment& assignment, const Recipe& recipe,
                const std::filesystem::path& into);

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

} // namespace ggrade::grading
