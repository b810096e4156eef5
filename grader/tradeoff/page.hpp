#pragma once
/// \file
/// The page of time against error: one HTML file that needs nothing else.

#include "tradeoff/findings.hpp"

namespace ggrade::tradeoff {

/// What was measured of one assignment.
struct PageAssignment {
  std::string id, title;
  std::vector<Measured> measured;
  std::vector<Findings> findings; ///< one to each of `measured`
  std::vector<GrowthRow> growth;
  std::vector<SavedRow> saved;
  std::vector<std::pair<std::string, std::string>> machine;
  Effort effort;
  bool complete = true; ///< false: the measurement is still under way, or was broken off
};

/// \throws std::logic_error if the template doesn't parse.
std::string tradeoffPage(const std::vector<PageAssignment>& assignments);

} // namespace ggrade::tradeoff
