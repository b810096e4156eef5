#pragma once
/// \file
/// Copies of this tree's folders.

#include <filesystem>

namespace ggrade::cli {

/// Copies a folder with all that is in it but hidden files, to where nothing stands yet.
void copyTree(const std::filesystem::path& from, const std::filesystem::path& to);

} // namespace ggrade::cli
