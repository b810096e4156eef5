#pragma once
/// \file
/// How closely a grading looks: the quality that `--quality` names, and less than any of them, to
/// learn what each scene and each pixel is worth.

#include "grading/references.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ggrade::calibration {

struct Look {
  grading::Quality quality = grading::Quality::balanced;
  double scale = 1;                  ///< of the sides of the hidden scenes' windows
  std::optional<std::size_t> hidden; ///< only the first so many hidden scenes; none: all of them
  bool twice = false;                ///< the public scene's second run, see grading::GradeOptions
  bool measures = false;             ///< are the pictures compared by whole-image measures, too?

  bool operator==(const Look&) const = default;
};

/// "balanced", "balanced, windows x 0.5", "balanced, 2 hidden scenes".
std::string nameOf(const Look& look);

/// Multiplies the sides of the hidden scenes' windows, probes included, to whole pixels of at least
/// 1. Nothing else in the scenes changes, quality numbers neither. Throws UsageError for a scene
/// without a size.
void scaleWindows(grading::ScenePlan& plan, double scale);

/// How many of the plan's scenes come before the hidden scene after the first `hidden` ones, in the
/// order of scenes.json; all if it has no more.
std::size_t scenesUpTo(const grading::ScenePlan& plan, std::size_t hidden);

} // namespace ggrade::calibration
