#include "gradebook/table.hpp"

#include "assignment/usage_error.hpp"
#include "gradebook/cells.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ggrade::gradebook {

std::vector<std::size_t> columnsNamed(const Csv& csv, const std::string& fileName,
                                      const std::vector<std::string>& names, OtherColumns others) {
  const auto fault = [&](const std::string& what) {
    throw UsageError(fmt::format("{}:1: {}; the first line has the columns {}", fileName, what,
                                 fmt::join(names, ",")));
  };
  std::vector<std::size_t> found(names.size(), std::string::npos);
  for (std::size_t column = 0; csv.rows() > 0 && column < csv.columns(0); ++column) {
    const std::string header = csv.cell(0, column);
    const auto name = std::find(names.begin(), names.end(), foldedHeader(header));
    if (name == names.end()) {
      if (others == OtherColumns::refused)
        fault(fmt::format("unknown column \"{}\"", report::sanitizeLine(header)));
      continue;
    }
    std::size_t& place = found[name - names.begin()];
    if (place != std::string::npos) fault(fmt::format("two columns are called \"{}\"", *name));
    place = column;
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    if (found[i] == std::string::npos) fault(fmt::format("there is no column \"{}\"", names[i]));
  return found;
}

std::string cellOf(const Csv& csv, std::size_t row, std::size_t column) {
  return column < csv.columns(row) ? std::string(trimmed(csv.cell(row, column))) : "";
}

} // namespace ggrade::gradebook
