#pragma once
/// \file
/// What gradebooks need of one student.

#include <optional>
#include <string>
#include <vector>

namespace ggrade::gradebook {

struct Entry {
  std::string student; ///< identifier as in the upload's name: "1234"
  std::string name;    ///< empty where marking is blind
  /// Points before `penalty` is taken off; none: not gradable, no grade is written.
  std::optional<double> score{};
  double maxScore = 0;
  double penalty = 0;      ///< points taken off for lateness
  std::string feedback{};  ///< plain UTF-8, lines end in LF
  std::string submitted{}; ///< ISO 8601, or empty
};

/// The points that count, never below 0; none where there is no score.
std::optional<double> finalScore(const Entry& entry);

/// Throws std::invalid_argument with the student unless all numbers are finite, the maximum is
/// above 0 and the penalty is not negative.
void checkNumbers(const std::vector<Entry>& entries);

} // namespace ggrade::gradebook
