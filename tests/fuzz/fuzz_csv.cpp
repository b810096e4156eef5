// Any bytes as a table: read and written they are the same, and a cell that was set is read back,
// with every other cell as before. Only UsageError may be thrown.
#include "require.hpp"

#include "assignment/usage_error.hpp"
#include "gradebook/csv.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cstdint>

using ggrade::gradebook::Csv;

namespace {

void requireSameCells(const Csv& a, const Csv& b) {
  require(a.rows() == b.rows() && a.delimiter() == b.delimiter());
  for (std::size_t row = 0; row < a.rows(); ++row) {
    require(a.columns(row) == b.columns(row));
    for (std::size_t column = 0; column < a.columns(row); ++column)
      require(a.cell(row, column) == b.cell(row, column));
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Three bytes say which cell is set and how long its text is; then the text, then the table.
  if (size < 3) return 0;
  const std::string_view rest(reinterpret_cast<const char*>(data) + 3, size - 3);
  const std::string text = ggrade::report::sanitize(rest.substr(0, data[2] % 32));
  const std::string_view bytes = rest.substr(std::min<std::size_t>(data[2] % 32, rest.size()));
  try {
    Csv csv(bytes, "table.csv");
    require(csv.bytes() == bytes);
    if (csv.rows() == 0) return 0;
    const std::size_t row = data[0] % csv.rows(), column = data[1] % csv.columns(row);
    const std::string before = csv.cell(row, column);
    csv.set(row, column, text);
    const Csv again(csv.bytes(), "table.csv");
    require(again.cell(row, column) == text);
    requireSameCells(again, csv);
    csv.set(row, column, before);
    require(csv.bytes() == bytes);
  } catch (const ggrade::UsageError&) {
  }
  return 0;
}
