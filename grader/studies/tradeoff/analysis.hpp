#pragma once
/// \file
/// What measured settings say: which are worth having, which one to take, how cost grows. Plain
/// numbers in and out.

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
/// Times within this share of the quicker one are the same time: what a rerun moves a median by.
inline constexpr double kSameTime = 0.05;
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
  Spread ms;              ///< milliseconds of a frame that the part costs; may be below 0 by noise
  std::vector<truth::Error> errors; ///< at least one; settings are compared by the first
  Image rendered, difference;       ///< small pictures for the page; may be empty

  double error() const { return errors.at(0).value; }
};

/// Indices of the points that no other one beats in both time and error, fastest first.
std::vector<std::size_t> paretoFront(const std::vector<Point>& points);

bool nearlyEqual(double a, double b);

/// The setting of least error among those of at most `ms`; of those that are nearly as good, the
/// fastest.
std::optional<std::size_t> withinBudget(const std::vector<Point>& points, double ms);

/// The fastest setting whose error is at most `limit`; of those that are as fast (kSameTime), the
/// one of least error.
std::optional<std::size_t> withinError(const std::vector<Point>& points, double limit);

/// A setting with a name.
struct Preset {
  std::string name, rule; ///< "fast", "the fastest with ..."
  std::size_t point = 0;
};

/// `fast`, `balanced`, `accurate`, and `reference`: this setting, if it is among the points. Noise
/// shall not choose: where a rule asks for the fastest, those whose lower quartile is below its
/// median may be as fast, and the one of least error stands for all.
/// `points` must not be empty.
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
/// Milliseconds: "12.3 ms", "0.41 ms".
std::string msText(double ms);
/// "mirror_size 512, mirror_clip 1".
std::string settingText(const nlohmann::json& setting);

} // namespace ggrade::tradeoff
