#pragma once
/// \file
/// Files that are either complete or absent.

#include <filesystem>
#include <string_view>

namespace ggrade::report {

/// Writes `text` to `path` whole or not at all (a new file beside it, then a rename), so that a
/// reader, an interruption or a full disk never meets half a file. The folder must exist. \throws
/// std::runtime_error naming the path, the cause and the remedy; nothing is left behind.
void writeFile(const std::filesystem::path& path, std::string_view text);

/// Creates the folder and its parents. Does nothing where it exists.
/// \throws std::runtime_error naming the path, the cause and the remedy.
void makeFolder(const std::filesystem::path& folder);

} // namespace ggrade::report
