#include "gradebook/entry.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace ggrade::gradebook {

std::optional<double> finalScore(const Entry& entry) {
  if (!entry.score) return {};
  return std::max(0.0, *entry.score - entry.penalty);
}

void checkNumbers(const std::vector<Entry>& entries) {
  for (const Entry& entry : entries) {
    const bool fine = std::isfinite(entry.score.value_or(0)) && std::isfinite(entry.maxScore) &&
                      entry.maxScore > 0 && std::isfinite(entry.penalty) && entry.penalty >= 0;
    if (!fine)
      throw std::invalid_argument(fmt::format("{}: score {} of {}, penalty {}", entry.student,
                                              entry.score.value_or(0), entry.maxScore,
                                              entry.penalty));
  }
}

} // namespace ggrade::gradebook
