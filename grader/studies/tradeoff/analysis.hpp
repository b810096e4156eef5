#pragma once
/// \file
/// What measured settings say: which are worth having, which one to take, how cost grows. Plain
/// numbers in and out.

#include "tradeoff/cost.hpp"
#include "truth/truth.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace ggrade::tradeoff {

/// Two errors count as nearly equal within this share of the smaller one, ...
inline constexpr double kNearlyShare = 0.02;
/// ... or if they differ by no more than this.
inline constexpr double kNearlyAbsolute = 1e-4;
/// The preset `fast` may have so many times the least error, ...
inline constexpr double kFastFactor = 4;
/// ... and `accurate` so many.
inline constexpr double kAccurateFactor = 1.1;

/// The middle half of a sample.
struct Spread {
  double median = 0, q1 = 0, q3 = 0;
};

/// Quartiles by linear interpolation between the sorted values; all 0 of an empty sample.
Spread spreadOf(std::vector<double> values);

/// One setting, measured.
struct Point {
  nlohmann::json setting; ///< number to value, such as {"mirror_size": 512}
  Cost cost;
  std::vector<truth::Error> errors; ///< at least one; settings are compared by the first
  Image rendered, difference;       ///< small pictures for the page; may be empty

  double error() const { return errors.at(0).value; }
};

/// Indices of the settings worth having, fastest first: from the most accurate on, of those that
/// are clearly faster (`faster`) again the most accurate. Of errors that are nearly equal the
/// fastest, of times that are the same the least error: so noise doesn't choose.
std::vector<std::size_t> paretoFront(const std::vector<Point>& points);

bool nearlyEqual(double a, double b);

/// The setting of least error among those that surely cost at most `ms`; of those that are nearly
/// as good, the fastest.
std::optional<std::size_t> withinBudget(const std::vector<Point>& points, double ms);

/// The fastest setting whose error is at most `limit`; of those of which none is clearly slower,
/// the one of least error.
std::optional<std::size_t> withinError(const std::vector<Point>& points, double limit);

/// A setting with a name.
struct Preset {
  std::string name, rule; ///< "fast", "the fastest with ..."
  std::size_t point = 0;
};

/// `fast`, `balanced`, `accurate`, which are on the front, and `reference`: this setting, if it is
/// among the points. Several may be one setting. `points` must not be empty.
std::vector<Preset> presetsOf(const std::vector<Point>& points, const nlohmann::json& reference);

/// y = factor * x^exponent.
struct Growth {
  double exponent = 0, factor = 0;
  double deviation = 0; ///< mean square of the fit's residuals, root of it, as a factor less 1
};

/// By least squares of the logarithms. Pairs that are not both above 0 are left out; none with
/// fewer than two different x left.
std::optional<Growth> growthOf(const std::vector<double>& x, const std::vector<double>& y);

/// In words, whether the error falls as the number goes from its first value to its last.
/// `labels` and `errors` are as many, at least one.
std::string fallText(const std::string& number, const std::vector<std::string>& labels,
                     const std::vector<double>& errors);

/// What `fallText` said, and a note behind it, in the language that was chosen. Measurements are
/// kept with the English sentences.
std::string fallInWords(const std::string& fall);

/// An error as a person reads it: "1.2%", "0.034%", "3.1e-07".
std::string errorText(double error);
/// "mirror_size 512, mirror_clip 1".
std::string settingText(const nlohmann::json& setting);

} // namespace ggrade::tradeoff
