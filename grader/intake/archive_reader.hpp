#pragma once
/// \file
/// Turns an archive from a student into a bundle. Runs in the sandbox, as ggrade-unpack: libarchive
/// is large, and every byte that it reads here is chosen by somebody we don't trust.

#include "intake/limits.hpp"

#include <iosfwd>
#include <string_view>

namespace ggrade::intake {

/// Reads a zip or tar file (plain, gzip, bzip2, xz, zstd) and writes a bundle. Names stay as they
/// are, but for those that a zip marks as UTF-8 or gives as Unicode. The locale must be UTF-8.
/// Throws std::runtime_error with a sentence about the archive ("holds more than ...").
void bundleFile(const char* path, const Limits& limits, std::ostream& out);

/// The same with an archive in memory.
void bundleMemory(std::string_view archive, const Limits& limits, std::ostream& out);

} // namespace ggrade::intake
