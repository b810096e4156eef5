#pragma once
/// \file
/// Charts as SVG inside a page; colours come from the page's sheet.

#include "tradeoff/findings.hpp"

namespace ggrade::tradeoff {

/// What stands at the points of a front: their places from 1, as in the page's table, or the names
/// of the presets among them.
enum class Labels { places, presets };

/// All settings, time against error, both as logarithms; the front's are joined.
std::string frontChart(const Measured& measured, const Findings& findings, Labels labels);

/// One number alone: its values in a row, their error (`what` "error") or cost ("time") as a
/// logarithm.
std::string curveChart(const Measured& measured, const Curve& curve, bool cost);

} // namespace ggrade::tradeoff
