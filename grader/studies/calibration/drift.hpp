#pragma once
/// \file
/// What another context or another processor's instructions do to scores: two calibrations of the
/// same programs, seeds and scenes, compared grading by grading.

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace ggrade::calibration {

/// A score may move by so much where grades are made; by any amount elsewhere.
inline constexpr double kDriftOfScore = 0.5, kNoLimit = 1e9;

struct Drift {
  std::string variant;
  unsigned gradings = 0;
  unsigned moved = 0;  ///< gradings whose score or bonus is not the same
  double furthest = 0; ///< in points
  std::string where;   ///< the program that moved furthest
  /// Programs whose verdict or outcome changed, or whose score moved by more than the limit.
  std::vector<std::string> failures;
};

/// `before` and `after`: what `ggrade calibrate` writes as calibration.json.
Drift driftOf(const std::string& variant, const nlohmann::json& before, const nlohmann::json& after,
              double limit = kDriftOfScore);

std::string tableOf(const std::vector<Drift>& drifts);
nlohmann::json toJson(const std::vector<Drift>& drifts);

} // namespace ggrade::calibration
