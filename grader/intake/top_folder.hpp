#pragma once
/// \file
/// Which folder of an upload holds the assignment's files.

#include "intake/contents.hpp"

namespace ggrade::intake {

/// The name in `wanted` that `name` equals, case ignored; empty if there is none.
std::string wantedName(std::string_view name, const std::vector<std::string>& wanted);

struct TopFolder {
  std::vector<File> files;          ///< below the top, with paths from there
  std::vector<std::string> outside; ///< printable names of the rest
  std::string reason;               ///< why the rest doesn't count
  std::vector<std::string> remarks; ///< files that got the wanted name's case
};

/// The shallowest folder that holds one of `wanted` (case ignored) becomes the top; of several, the
/// one with more of them. Throws UploadProblem if none does, or if two do equally.
TopFolder takeTopFolder(std::vector<File> files, const std::vector<std::string>& wanted);

} // namespace ggrade::intake
