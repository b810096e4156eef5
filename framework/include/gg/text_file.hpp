#pragma once
/// \file
/// Text files and their names, in UTF-8 on every system.

#include <filesystem>
#include <string>
#include <string_view>

namespace gg {

/// The path as UTF-8, for messages.
std::string toUtf8(const std::filesystem::path& path);
/// The path that a UTF-8 string names.
std::filesystem::path fromUtf8(std::string_view text);

/// Reads a whole file, byte for byte. Throws FileError with the name and the reason.
std::string readFile(const std::filesystem::path& file);

} // namespace gg
