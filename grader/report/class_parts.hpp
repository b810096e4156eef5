#pragma once
/// \file
/// The parts of the class page as data for templates/class.mustache.

#include "report/class_figures.hpp"
#include "report/page.hpp"
#include "report/summary.hpp"

#include <span>
#include <string>

namespace ggrade::report {

/// A name as the page shows it, short enough for a cell; never empty.
std::string shownName(const std::string& name);
/// "61.5", or "no score" for what is no number.
std::string scoreText(double score);
/// What the overview's words and colours are made of; without picture and link.
Summary summaryOf(const ClassRow& row);
/// Sets `link`, `studentLink` (false without a folder) and `name`.
void setStudent(Data& data, const std::string& folder, const std::string& name);

/// The table of all students: `columns` that only some classes have, and `rows`.
void setTable(Data& data, const ClassPage& page, const ScoreFigures& figures);

/// Sets `histogram` with the drawing and its bins; false without a score.
void setHistogram(Data& data, std::span<const ClassRow> rows, const ScoreFigures& figures);

} // namespace ggrade::report
