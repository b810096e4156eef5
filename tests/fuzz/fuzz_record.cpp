// Any bytes as what is kept of a submission: it is taken whole or not at all, never with an
// exception, and what was taken is the same when it was written and read again.
#include "require.hpp"

#include "../unit/framework_temporary_folder.hpp"

#include "batch/record.hpp"

#include <cmath>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ggrade;
  static const TemporaryFolder folder;
  const auto file = folder.write("s1/record.json", {reinterpret_cast<const char*>(data), size});
  const auto record = batch::loadRecord(file.parent_path());
  if (!record) return 0;
  require(record->row.folder == "s1" && std::isfinite(record->row.score));
  batch::saveRecord(file.parent_path(), *record);
  const auto again = batch::loadRecord(file.parent_path());
  require(again.has_value());
  require(again->row.student == record->row.student && again->row.score == record->row.score);
  require(again->row.items.size() == record->row.items.size());
  require(again->upload == record->upload && again->seed == record->seed);
  return 0;
}
