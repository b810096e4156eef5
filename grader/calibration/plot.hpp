#pragma once

#include "calibration/verdicts.hpp"

#include <string>

namespace ggrade::calibration {

/// Scores by kind as an inline SVG: a dot for each program and seed, and the bounds.
std::string plotOf(const Verdicts& verdicts, const std::vector<Measured>& measured);

} // namespace ggrade::calibration
