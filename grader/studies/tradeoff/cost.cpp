#include "tradeoff/cost.hpp"

#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ggrade::tradeoff {

namespace {

constexpr double kOutside = 0.05; ///< how often the median may lie outside its interval

/// How many values may be left out at each end.
std::size_t leftOut(std::size_t count) {
  // probability: of exactly `below` values below the median; sum: of as many or fewer.
  double probability = std::pow(0.5, double(count)), sum = probability;
  std::size_t below = 0;
  while (2 * sum <= kOutside) {
    ++below;
    probability *= double(count - below + 1) / double(below);
    sum += probability;
  }
  return below > 0 ? below - 1 : 0;
}

Interval differences(const Pairs& pairs) {
  std::vector<double> all;
  for (std::size_t i = 0; i < pairs.with.size(); ++i)
    all.push_back(pairs.with[i] - pairs.without.at(i));
  return medianInterval(std::move(all));
}

bool isNarrow(const Interval& interval, double whole) {
  const double width = interval.high - interval.low;
  return width < kNarrow * whole && (interval.low <= 0 || width < kNarrowOfCost * interval.median);
}

/// Two digits, none of them less than there is.
double roundedUp(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return unit * std::ceil(value / unit - 1e-9);
}

} // namespace

double medianOf(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t count = values.size();
  return (values[(count - 1) / 2] + values[count / 2]) / 2;
}

Interval medianInterval(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const std::size_t out = leftOut(values.size());
  return {medianOf(values), values[out], values[values.size() - 1 - out]};
}

Cost costOf(const Pairs& pairs) {
  const Interval interval = differences(pairs);
  const double whole = medianOf(pairs.with);
  return {std::max(0.0, interval.median), std::max(0.0, interval.low), std::max(0.0, interval.high),
          whole, isNarrow(interval, whole)};
}

bool needsMore(const Pairs& pairs) {
  return pairs.with.size() < kLeastPairs || !isNarrow(differences(pairs), medianOf(pairs.with));
}

bool faster(const Cost& a, const Cost& b) {
  return a.high < b.low && b.median > (1 + kSameTime) * a.median;
}

std::string msText(double ms) {
  return fmt::format("{:.{}f} ms", ms, std::abs(ms) >= 10 ? 1 : std::abs(ms) >= 0.1 ? 2 : 3);
}

std::string costText(const Cost& cost) {
  if (!cost.hidden()) return msText(cost.median);
  return cost.high > 0 ? gg::say("below {:.3g} ms", roundedUp(cost.high)) : gg::say("none");
}

} // namespace ggrade::tradeoff
