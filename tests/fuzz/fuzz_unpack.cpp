// From any bytes as an archive to files: whatever ggrade-unpack writes, its reader accepts.
#include "fuzz_contents.hpp"

#include "intake/archive_reader.hpp"

#include <clocale>
#include <sstream>
#include <stdexcept>

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  return std::setlocale(LC_CTYPE, "C.UTF-8") ? 0 : 1;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace ggrade::intake;
  std::ostringstream out;
  try {
    bundleMemory({reinterpret_cast<const char*>(data), size}, kFuzzLimits, out);
  } catch (const std::runtime_error&) {
    return 0;
  }
  const std::string bundle = out.str();
  takeAsUpload(readBundle(bundle, kFuzzLimits));
  return 0;
}
