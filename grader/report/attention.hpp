#pragma once
/// \file
/// Who of a class needs a person to look, and why: said on the class page, by the terminal and in
/// JSON alike.

#include "report/class_page.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ggrade::report {

struct Attention {
  std::size_t row = 0;              ///< of the class
  std::vector<std::string> reasons; ///< a sentence each
  bool lacksScore = false;          ///< no gradebook has a score for this student
};

/// Rows that were not gradable, unless somebody gave a total; that look like other uploads; whose
/// overrides are beyond what can be given.
std::vector<Attention> needingAPerson(std::span<const ClassRow> rows);

} // namespace ggrade::report
