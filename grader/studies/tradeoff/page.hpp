#pragma once
/// \file
/// The page of time against error, one HTML file that needs nothing else, and its charts.

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

// Charts as SVG inside a page; colours come from the page's sheet.

/// What stands at the points of a front: their places from 1, as in the page's table, or the names
/// of the presets among them.
enum class Labels { places, presets };

/// All settings, time against error, both as logarithms; the front's are joined.
std::string frontChart(const Measured& measured, const Findings& findings, Labels labels);

/// One number alone: its values in a row, their error (`what` "error") or cost ("time") as a
/// logarithm.
std::string curveChart(const Measured& measured, const Curve& curve, bool cost);

} // namespace ggrade::tradeoff
