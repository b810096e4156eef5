#pragma once
/// \file
/// Takes from an upload only what a student may edit, onto a clean tree.

#include "assignment/assignment.hpp"

namespace ggrade::grading {

inline constexpr std::uintmax_t kLargestSource = 1 << 20; ///< bytes of one uploaded file
/// Of one upload: bytes that are taken of all its files, and names that are looked at beside those
/// of the assignment. A small archive can hold millions of either.
inline constexpr std::uintmax_t kLargestUpload = 32 << 20;
inline constexpr std::size_t kMostOtherFiles = 256;

/// An upload that holds no file of the assignment.
struct NothingToGrade : UsageError {
  using UsageError::UsageError;
};

struct Overlay {
  std::vector<std::string> used; ///< files taken from the upload
  std::vector<std::string>
      missing; ///< editable files that the upload lacks; the handed-out ones stand in
  std::vector<std::string> unused; ///< what else the upload holds, each with the reason
};

/// Is this read by the compiler, not by the program when it runs?
bool isCompiled(const std::filesystem::path& file);

/// Does an upload's file of this name count: one that is edited, or matches an optional pattern?
bool takes(const Assignment& assignment, const std::string& name);

/// The names of the files that `folder` (a solution's, or an upload) brings to the program, sorted.
/// Headers of rubrics and truths match a pattern for students' files, too, but nothing that is
/// built reads them.
std::vector<std::string> ownFiles(const Assignment& assignment,
                                  const std::filesystem::path& folder);

/// Copies the clean files of `cleanFolder` (the handed-out ones) and the assignment's JSON files to
/// `into`, then the editable and optional files of `upload` over them. Only regular files are
/// taken, no links, and no more than an upload may have (above). Throws UsageError when `upload` is
/// missing, NothingToGrade when it holds no file of the assignment.
Overlay overlay(const Assignment& assignment, const std::filesystem::path& upload,
                const std::filesystem::path& into);

} // namespace ggrade::grading
