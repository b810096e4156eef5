// The file of recorded passes, with any of its bytes changed, or any bytes in its place: it is
// refused with UsageError or can be read without harm.
#include "../unit/framework_temporary_folder.hpp"
#include "../unit/trace_samples.hpp"
#include "fuzz_look.hpp"

#include "assignment/usage_error.hpp"

#include <cstdint>
#include <iterator>

namespace {

std::string savedSample(const std::filesystem::path& folder) {
  ggrade::trace::save(ggrade::trace::samples::mirror(), folder);
  std::ifstream in(folder / "trace.bin", std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ggrade;
  static const TemporaryFolder folder;
  static const std::string sample = savedSample(folder.path());
  if (size == 0) return 0;
  std::string bytes = sample;
  if (data[0] % 4 == 0)
    bytes.assign(reinterpret_cast<const char*>(data) + 1, size - 1);
  else // three bytes each: where, and what stands there from then on
    for (std::size_t i = 1; i + 2 < size; i += 3)
      bytes[(data[i] | data[i + 1] << 8) % bytes.size()] = char(data[i + 2]);
  folder.write("trace.bin", bytes);
  try {
    lookAt(trace::load(folder.path()));
  } catch (const UsageError&) {
  }
  return 0;
}
