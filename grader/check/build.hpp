#pragma once
/// \file
/// Builds a student's program for `check`.

#include "grading/program.hpp"

#include <filesystem>

namespace ggrade::check {

/// Puts the student's files where they are built, in `program`, and builds them unless the program
/// there was built of this very text with the framework as it is.
grading::Happened buildChanged(const Assignment& assignment, const std::filesystem::path& folder,
                               const std::filesystem::path& program);

} // namespace ggrade::check
