// The bundle's reader: any bytes, as a program taken over by a student's archive might write them.
#include "fuzz_contents.hpp"

#include <sstream>
#include <stdexcept>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace ggrade::intake;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  std::vector<Entry> entries;
  try {
    entries = readBundle(bytes, kFuzzLimits);
  } catch (const std::runtime_error&) {
    return 0;
  }
  // Written again it is the same, but for what the end says besides that it is one.
  std::ostringstream again;
  writeBundleMark(again);
  for (const Entry& entry : entries) writeEntry(again, entry);
  require(bytes.starts_with(again.str()));
  takeAsUpload(entries);
  return 0;
}
