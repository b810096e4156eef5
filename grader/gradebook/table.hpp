#pragma once

#include "gradebook/csv.hpp"

namespace ggrade::gradebook {

enum class OtherColumns { allowed, refused };

/// Where the columns `names` stand in the first row, whatever their order and case. Throws
/// UsageError with the file and the header to write if one is missing, stands there twice or is
/// none of them.
std::vector<std::size_t> columnsNamed(const Csv& csv, const std::string& fileName,
                                      const std::vector<std::string>& names, OtherColumns others);

/// The cell without blanks at its ends; empty where the row is too short.
std::string cellOf(const Csv& csv, std::size_t row, std::size_t column);

} // namespace ggrade::gradebook
