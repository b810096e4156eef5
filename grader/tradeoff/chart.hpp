#pragma once
/// \file
/// Charts as SVG inside a page; colours come from the page's sheet.

#include "tradeoff/findings.hpp"

namespace ggrade::tradeoff {

/// All settings, time against error, both as logarithms; the front's are joined and numbered from 1
/// as in the page's table.
std::string frontChart(const Measured& measured, const Findings& findings);

/// One number alone: its values in a row, their error (`what` "error") or cost ("time") as a
/// logarithm.
std::string curveChart(const Measured& measured, const Curve& curve, bool cost);

} // namespace ggrade::tradeoff
