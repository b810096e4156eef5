#pragma once
/// \file
/// What the trade of a part is: presets that are one setting together, and one sentence.

#include "tradeoff/analysis.hpp"

namespace ggrade::tradeoff {

/// Presets that are one setting, with what it costs.
struct PresetRow {
  std::vector<std::string> names; ///< at least one
  nlohmann::json setting;
  Cost cost;
  double error = 0;

  std::string name() const; ///< "fast, balanced"
};

/// In the order of the presets; a row stands where its first preset does.
std::vector<PresetRow> presetRows(const std::vector<Point>& points,
                                  const std::vector<Preset>& presets);

/// Adds a preset to the row of its setting, or a row.
void addPreset(std::vector<PresetRow>& rows, PresetRow preset);

/// "Between fast (1.20 ms, error 3.1%) and reference (14.0 ms, error 0.40%), a frame takes 32.1 ms
/// instead of 19.3 ms, and the error falls to 12.9% of it." In the language that was chosen. `rows`
/// begins with fast and ends with the best setting.
std::string tradeText(const std::vector<PresetRow>& rows);

} // namespace ggrade::tradeoff
