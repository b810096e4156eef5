#pragma once
/// \file
/// Regular files on disk, read without following a link or waiting on a FIFO.

#include "intake/bundle.hpp"

#include <filesystem>
#include <string>

namespace ggrade::intake {

/// What stands at `path` itself, no link followed. Throws std::runtime_error where nothing does.
Kind kindAt(const std::filesystem::path& path);

/// Bytes and time of modification. Throws std::runtime_error with the reason ("is not a regular
/// file") for anything but a regular file of at most `limit` bytes, and std::system_error, which
/// names the file, where the machine can't read it: that is nothing to hold against the file.
struct ReadFile {
  std::string bytes;
  std::int64_t modified = 0;
};
ReadFile readRegular(const std::filesystem::path& path, std::uint64_t limit);

/// Makes a file of mode 0644 that was not there before. Throws UsageError with the remedy.
void writeNew(const std::filesystem::path& path, std::string_view bytes);

} // namespace ggrade::intake
