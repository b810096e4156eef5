#include "calibration/classifier.hpp"

#include <algorithm>
#include <cmath>

namespace ggrade::calibration {

Errors& Errors::operator+=(const Errors& other) {
  right += other.right;
  rightRejected += other.rightRejected;
  wrong += other.wrong;
  wrongAccepted += other.wrongAccepted;
  return *this;
}

double upperBound(std::size_t found, std::size_t count) {
  if (count == 0) return 1;
  constexpr double z = 1.959963984540054; // 97.5% of a normal distribution lie below
  const double n = double(count), share = double(found) / n;
  const double middle = share + z * z / (2 * n);
  const double reach = z * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
  return std::min(1.0, (middle + reach) / (1 + z * z / n));
}

std::optional<double> areaUnderRoc(const std::vector<Rated>& all) {
  double above = 0, pairs = 0;
  for (const Rated& right : all) {
    if (!right.right) continue;
    for (const Rated& wrong : all) {
      if (wrong.right) continue;
      ++pairs;
      above += wrong.value > right.value ? 1 : wrong.value == right.value ? 0.5 : 0;
    }
  }
  if (pairs == 0) return std::nullopt;
  return above / pairs;
}

Errors errorsOf(const std::vector<Rated>& all, int half, double threshold) {
  Errors errors;
  for (const Rated& one : all) {
    if (one.half != half) continue;
    const bool accepted = one.value <= threshold;
    ++(one.right ? errors.right : errors.wrong);
    errors.rightRejected += one.right && !accepted;
    errors.wrongAccepted += !one.right && accepted;
  }
  return errors;
}

double chooseThreshold(const std::vector<Rated>& all, int half) {
  std::vector<double> values;
  for (const Rated& one : all)
    if (one.half == half && std::isfinite(one.value)) values.push_back(one.value);
  std::ranges::sort(values);
  double best = 0, least = 2;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double threshold = i + 1 < values.size() ? (values[i] + values[i + 1]) / 2 : values[i];
    const Errors errors = errorsOf(all, half, threshold);
    const double sum = (errors.right ? double(errors.rightRejected) / double(errors.right) : 0) +
                       (errors.wrong ? double(errors.wrongAccepted) / double(errors.wrong) : 0);
    if (sum >= least) continue;
    least = sum;
    best = threshold;
  }
  return best;
}

} // namespace ggrade::calibration
