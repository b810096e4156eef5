#pragma once
/// \file
/// What an upload may hold at most.

#include <cstddef>
#include <cstdint>

namespace ggrade::intake {

struct Limits {
  std::size_t entries = 2000;               ///< files, folders and whatever else, but for clutter
  std::size_t clutter = 20000;              ///< entries that are passed over, see clutterIn
  std::uint64_t bytes = 32ull << 20;        ///< of all files that are taken
  std::uint64_t fileBytes = 4ull << 20;     ///< of one file; larger ones are refused by name
  std::uint64_t archiveBytes = 64ull << 20; ///< of an archive, as uploaded
  std::uint64_t expandedBytes = 1ull << 30; ///< of all that an archive says it holds, taken or not
  double cpuSeconds = 10;                   ///< for unpacking one archive
};

/// One student's upload.
inline constexpr Limits kUploadLimits;

/// The archive of a whole class, uploads still packed.
inline constexpr Limits kClassLimits = {
    .entries = 20000,
    .clutter = 200000,
    .bytes = 256ull << 20,
    .fileBytes = 64ull << 20,
    .archiveBytes = 512ull << 20,
    .expandedBytes = 4ull << 30,
    .cpuSeconds = 60,
};

inline constexpr std::size_t kLongestComponent = 255; ///< bytes of a file's or folder's name
inline constexpr std::size_t kDeepest = 16;           ///< components of a path, the file included
/// Bytes of a path in a bundle, where longer ones are cut: more than any that is accepted.
inline constexpr std::size_t kLongestPath = kDeepest * (kLongestComponent + 1) + 100;

} // namespace ggrade::intake
