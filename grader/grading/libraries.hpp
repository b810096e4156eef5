#pragma once
/// \file
/// What a submission's program needs of the system when it runs.

#include <filesystem>
#include <vector>

namespace ggrade::grading {

/// The libraries of a program that is linked as submissions are, and draws through the capture
/// library, with all that these need: files, canonical but for their own names. They are being
/// read into memory: so no run finds out which of them another has read. Throws std::runtime_error
/// where one is missing.
const std::vector<std::filesystem::path>& programLibraries();

} // namespace ggrade::grading
