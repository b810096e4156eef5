#include "tradeoff/analysis.hpp"

#include "words/words.hpp"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <regex>

namespace ggrade::tradeoff {

namespace {

double quantile(const std::vector<double>& sorted, double share) {
  const double at = share * double(sorted.size() - 1);
  const std::size_t below = std::size_t(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - double(below)) * (sorted[above] - sorted[below]);
}

/// Where the curve of the front bends most: the point farthest below the line that joins its ends,
/// in logarithms of a frame's time and error that are scaled to 0 to 1.
std::size_t kneeOf(const std::vector<Point>& points, const std::vector<std::size_t>& front) {
  const Point &first = points[front.front()], &last = points[front.back()];
  const auto logs = [](double value) { return std::log(std::max(value, 1e-9)); };
  const double x0 = logs(first.cost.whole), x1 = logs(last.cost.whole);
  const double y0 = logs(first.error()), y1 = logs(last.error());
  std::size_t knee = front.front();
  double most = 0;
  for (std::size_t index : front) {
    const double x = x1 > x0 ? (logs(points[index].cost.whole) - x0) / (x1 - x0) : 0;
    const double y = y1 < y0 ? (logs(points[index].error()) - y1) / (y0 - y1) : 0;
    if (1 - x - y > most) {
      most = 1 - x - y;
      knee = index;
    }
  }
  return knee;
}

using Indices = std::vector<std::size_t>;

/// Those of `among` for which `holds`.
template <class Condition>
Indices kept(const std::vector<Point>& points, const Indices& among, Condition holds) {
  Indices left;
  for (std::size_t index : among)
    if (holds(points[index])) left.push_back(index);
  return left;
}

Indices everyOne(const std::vector<Point>& points) {
  Indices all(points.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

std::size_t leastError(const std::vector<Point>& points, const Indices& among) {
  return *std::ranges::min_element(among, {}, [&](std::size_t i) { return points[i].error(); });
}

/// Of those than which none is clearly faster, the one of least error. `among` is not empty.
std::size_t fastestOf(const std::vector<Point>& points, const Indices& among) {
  const std::size_t first =
      *std::ranges::min_element(among, {}, [&](std::size_t i) { return points[i].cost.high; });
  return leastError(points, kept(points, among, [&](const Point& point) {
                      return !faster(points[first].cost, point.cost);
                    }));
}

/// Of those whose error is nearly the least, the fastest. `among` is not empty.
std::size_t mostAccurateOf(const std::vector<Point>& points, const Indices& among) {
  const double least = points[leastError(points, among)].error();
  return fastestOf(points, kept(points, among, [&](const Point& point) {
                     return nearlyEqual(point.error(), least);
                   }));
}

} // namespace

Spread spreadOf(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  return {quantile(values, 0.5), quantile(values, 0.25), quantile(values, 0.75)};
}

std::vector<std::size_t> paretoFront(const std::vector<Point>& points) {
  Indices front, left = everyOne(points);
  while (!left.empty()) {
    front.push_back(mostAccurateOf(points, left));
    const Cost& cost = points[front.back()].cost;
    left = kept(points, left, [&](const Point& point) { return faster(point.cost, cost); });
  }
  std::ranges::reverse(front);
  return front;
}

bool nearlyEqual(double a, double b) {
  const double difference = std::abs(a - b);
  return difference <= kNearlyAbsolute || difference <= kNearlyShare * std::min(a, b);
}

std::optional<std::size_t> withinBudget(const std::vector<Point>& points, double ms) {
  const Indices all =
      kept(points, everyOne(points), [&](const Point& point) { return point.cost.high <= ms; });
  if (all.empty()) return std::nullopt;
  return mostAccurateOf(points, all);
}

std::optional<std::size_t> withinError(const std::vector<Point>& points, double limit) {
  const Indices all =
      kept(points, everyOne(points), [&](const Point& point) { return point.error() <= limit; });
  if (all.empty()) return std::nullopt;
  return fastestOf(points, all);
}

std::vector<Preset> presetsOf(const std::vector<Point>& points, const nlohmann::json& reference) {
  const Indices front = paretoFront(points);
  const double least = points[leastError(points, everyOne(points))].error();
  // The front is sorted by time, so its first point that is good enough is the fastest.
  const auto fastest = [&](double factor) {
    const double limit = std::max(factor * least, least + kNearlyAbsolute);
    return std::ranges::find_if(front,
                                [&](std::size_t index) { return points[index].error() <= limit; });
  };
  const auto fast = fastest(kFastFactor), accurate = fastest(kAccurateFactor);
  std::vector<Preset> presets = {
      {"fast", fmt::format("the fastest with at most {} times the least error", kFastFactor),
       *fast},
      {"balanced", "where the front bends most between fast and accurate",
       kneeOf(points, Indices(fast, accurate + 1))},
      {"accurate",
       fmt::format("the fastest within {:.0f}% of the least error", 100 * (kAccurateFactor - 1)),
       *accurate}};
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].setting == reference)
      presets.push_back({"reference", "every number at its highest quality", i});
  return presets;
}

std::optional<Growth> growthOf(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<std::pair<double, double>> logs;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
    if (x[i] > 0 && y[i] > 0) logs.emplace_back(std::log(x[i]), std::log(y[i]));
  if (logs.size() < 2) return std::nullopt;
  double meanX = 0, meanY = 0;
  for (const auto& [u, v] : logs) {
    meanX += u / double(logs.size());
    meanY += v / double(logs.size());
  }
  double xx = 0, xy = 0;
  for (const auto& [u, v] : logs) {
    xx += (u - meanX) * (u - meanX);
    xy += (u - meanX) * (v - meanY);
  }
  if (xx <= 0) return std::nullopt;
  Growth growth;
  growth.exponent = xy / xx;
  growth.factor = std::exp(meanY - growth.exponent * meanX);
  double squares = 0;
  for (const auto& [u, v] : logs) {
    const double residual = v - meanY - growth.exponent * (u - meanX);
    squares += residual * residual / double(logs.size());
  }
  growth.deviation = std::expm1(std::sqrt(squares));
  return growth;
}

namespace {

// What is said of a number. Of two places side by side the second is a share in brackets, or empty.
constexpr std::string_view kOneValue = gg::tag("{} has one value only: {} at {}.");
constexpr std::string_view kNoDifference =
    gg::tag("{} makes no difference to the error here: {} to {} at every value.");
constexpr std::string_view kFalls = gg::tag("The error falls with {}: from {} at {} to {} at {}.");
constexpr std::string_view kStays =
    gg::tag("The error does not fall with {}: {} at {}, and {} at {}{}.");
constexpr std::string_view kRises =
    gg::tag("The error does not fall with {}: {} at {}, and it has risen to {} at {}{}.");
constexpr std::string_view kStaysBeyond =
    gg::tag("The error does not fall beyond {} {}: from {} at {} to {} there; {} at {}{}.");
constexpr std::string_view kHardlyBeyond =
    gg::tag("The error hardly falls beyond {} {}: from {} at {} to {} there; {} at {}{}.");
constexpr std::string_view kRisesBeyond = gg::tag(
    "The error does not fall beyond {} {}: from {} at {} to {} there; it has risen to {} at {}{}.");
constexpr std::string_view kOnTheWay = gg::tag("On the way it rises from {} at {} to {} at {}.");

/// Finds a sentence and what stands in its places, none of which has a space in it.
std::regex patternOf(const std::string& sentence) {
  std::string pattern;
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    if (sentence[i] != '{') {
      pattern += sentence[i] == '.' ? "\\." : std::string(1, sentence[i]);
      continue;
    }
    const bool share = i > 0 && sentence[i - 1] == '}';
    pattern += share ? "( \\([^ ]+%\\))?" : "([^ ]+?)";
    ++i;
  }
  return std::regex(pattern + "(?: |$)");
}

} // namespace

std::string fallText(const std::string& number, const std::vector<std::string>& labels,
                     const std::vector<double>& errors) {
  const std::size_t last = errors.size() - 1;
  const auto [least, most] = std::minmax_element(errors.begin(), errors.end());
  const std::string first = errorText(errors[0]), end = errorText(errors[last]);
  if (last == 0) return fmt::format(kOneValue, number, first, labels[0]);
  if (nearlyEqual(*least, *most))
    return fmt::format(kNoDifference, number, errorText(*least), errorText(*most));
  // The first value from which on nothing is gained that counts.
  std::size_t best = 0;
  while (!nearlyEqual(errors[best], *least)) ++best;
  std::string rises;
  for (std::size_t i = 1; i <= best; ++i)
    if (errors[i] > errors[i - 1] && !nearlyEqual(errors[i], errors[i - 1]))
      rises += ' ' + fmt::format(kOnTheWay, errorText(errors[i - 1]), labels[i - 1],
                                 errorText(errors[i]), labels[i]);
  if (best == last) return fmt::format(kFalls, number, first, labels[0], end, labels[last]) + rises;
  // A share of next to nothing says nothing.
  const double change = errors[last] / std::max(errors[best], 1e-12) - 1;
  const std::string share =
      errors[best] > kNearlyAbsolute
          ? fmt::format(" ({:+.{}f}%)", 100 * change, std::abs(change) < 0.1 ? 1 : 0)
          : "";
  const bool risen = !nearlyEqual(errors[best], errors[last]);
  if (best == 0)
    return fmt::format(fmt::runtime(risen ? kRises : kStays), number, first, labels[0], end,
                       labels[last], share);
  const std::string_view beyond = risen ? kRisesBeyond : change < 0 ? kHardlyBeyond : kStaysBeyond;
  return fmt::format(fmt::runtime(beyond), number, labels[best], first, labels[0],
                     errorText(errors[best]), end, labels[last], share) +
         rises;
}

std::string fallInWords(const std::string& fall) {
  if (gg::language() == gg::Language::english) return fall;
  std::string said, rest = fall;
  for (const std::string_view sentence : {kOneValue, kNoDifference, kFalls, kStays, kRises,
                                          kStaysBeyond, kHardlyBeyond, kRisesBeyond, kOnTheWay}) {
    const std::regex pattern = patternOf(std::string(sentence));
    for (std::smatch match;
         std::regex_search(rest, match, pattern, std::regex_constants::match_continuous);) {
      fmt::dynamic_format_arg_store<fmt::format_context> values;
      for (std::size_t i = 1; i < match.size(); ++i) values.push_back(match[i].str());
      said += fmt::vformat(gg::words(sentence), values);
      rest = match.suffix().str();
    }
  }
  return said + std::string(gg::words(rest));
}

std::string errorText(double error) {
  if (error == 0) return "0";
  const double percent = 100 * error;
  if (percent < 1e-3) return fmt::format("{:.1e}", error);
  return fmt::format("{:.{}f}%", percent,
                     percent >= 10 ? 1 : std::min(5, 1 - int(std::floor(std::log10(percent)))));
}

std::string settingText(const nlohmann::json& setting) {
  std::string text;
  for (const auto& [number, value] : setting.items())
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", number, value.dump());
  return text;
}

} // namespace ggrade::tradeoff
