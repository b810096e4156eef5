#pragma once
/// \file
/// Takes a submission whose score was disputed into the catalogue.

#include "assignment/assignment.hpp"

#include <filesystem>
#include <string>

namespace ggrade::calibration {

enum class AdoptAs { mistake, variant };

/// Writes `folder/{mistakes,variants}/<part>_<name>.patch`, which makes the solution's
/// files the submission's, and returns its path. The patch says nothing of where it comes from; the
/// code is as it was handed in, comments included. An empty `name` becomes disputed_1, disputed_2,
/// ... A mistake's header names the item that lost the largest share in `items` (a grading's), its
/// step and its scenes. Throws UsageError: no such folder, a name that is taken, a submission equal
/// to the solution.
std::filesystem::path adopt(const Target& target, const std::filesystem::path& solutionFolder,
                            const std::filesystem::path& folder,
                            const std::filesystem::path& submission, AdoptAs as,
                            const std::string& name, const std::vector<results::Item>& items);

} // namespace ggrade::calibration
