// ggrade-unpack ARCHIVE BUNDLE ENTRIES CLUTTER BYTES FILE_BYTES EXPANDED_BYTES. Started by
// ggrade::intake in the sandbox, never by hand. Exit code 1 with one sentence on standard error
// where the archive is refused.
#include "intake/archive_reader.hpp"

#include <cerrno>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

int main(int argc, char** argv) {
  using namespace ggrade::intake;
  if (argc != 8) {
    std::fputs("This program is part of ggrade's intake; ggrade starts it.\n", stderr);
    return 2;
  }
  // libarchive hands names over in the locale's encoding.
  if (!std::setlocale(LC_CTYPE, "C.UTF-8")) {
    std::fputs("the locale C.UTF-8 is missing\n", stderr);
    return 2;
  }
  Limits limits;
  limits.entries = std::strtoull(argv[3], nullptr, 10);
  limits.clutter = std::strtoull(argv[4], nullptr, 10);
  limits.bytes = std::strtoull(argv[5], nullptr, 10);
  limits.fileBytes = std::strtoull(argv[6], nullptr, 10);
  limits.expandedBytes = std::strtoull(argv[7], nullptr, 10);
  try {
    std::ofstream out(argv[2], std::ios::binary);
    bundleFile(argv[1], limits, out);
    if (!out.flush()) {
      // The sandbox has room for every bundle within the limits: the disk is full, or fails.
      std::fprintf(stderr, "can't write %s: %s", argv[2], std::strerror(errno));
      return 2;
    }
    return 0;
  } catch (const std::system_error& error) {
    std::fputs(error.what(), stderr);
    return 2; // no fault of the archive's
  } catch (const std::exception& error) {
    std::fputs(error.what(), stderr);
    return 1;
  }
}
