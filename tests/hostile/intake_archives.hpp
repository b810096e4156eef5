#pragma once
/// \file
/// Archives as students' computers make them, and as nobody's computer does.

#include <cstdint>
#include <string>
#include <vector>

struct ZipEntry {
  std::string name; ///< bytes as they stand in the file
  std::string bytes;
  std::uint16_t flags = 0;            ///< 1 encrypted, 0x800 the name is UTF-8
  std::uint8_t system = 3;            ///< that it was made on: 0 MS-DOS, 3 Unix
  std::uint16_t mode = 0100644;       ///< of Unix
  std::int64_t modified = 1700000000; ///< seconds since 1970, as Unix systems store it
  bool deflated = false;
  std::int64_t claimedSize = -1; ///< in place of the true one
  std::uint32_t crcError = 0;    ///< added to the true checksum
};

std::string zipOf(const std::vector<ZipEntry>& entries);

/// A zip file of `count` files that share their compressed bytes: each one's hold the headers of
/// those behind it as text, then the same `size` zeros (Fifield 2019, "A better zip bomb").
std::string overlappingZip(std::size_t count, std::size_t size);

struct TarEntry {
  std::string name;
  std::string bytes = {};
  char type = '0'; ///< '1' hard link, '2' symbolic link, '3' device, '5' folder, '6' FIFO
  std::int64_t claimedSize = -1;
  std::string target = {}; ///< of links
};

/// A tar file (ustar).
std::string tarOf(const std::vector<TarEntry>& entries);

enum class Compression { none, gzip, bzip2, xz, zstd };

/// The same as `gzip`, `xz`, ... make of it.
std::string compressed(const std::string& bytes, Compression kind);
