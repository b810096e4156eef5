#pragma once
/// \file
/// The page that says how the grader was measured: one HTML file that needs nothing else.

#include "calibration/verdicts.hpp"

#include <string>
#include <vector>

namespace ggrade::calibration {

/// What another measurement has to say of a part: a heading, a paragraph, a table, a chart.
struct Section {
  std::string title, text;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  std::string chart{}; ///< an inline SVG above the table, or empty
};

struct PagePart {
  std::string title; ///< "Mirror reflection through a framebuffer object"
  Verdicts verdicts;
  std::vector<Measured> measured; ///< in the order of verdicts.rows
  std::vector<Section> sections;  ///< below the table: cross-validation, diagnosis
  std::string alone{}; ///< where there are no verdicts, what was measured: "the diagnosis"
};

/// `figures` is the file beside the page that has all figures. \throws std::logic_error if the
/// template doesn't parse.
std::string calibrationPage(const std::vector<PagePart>& parts,
                            const std::string& figures = "calibration.json");

} // namespace ggrade::calibration
