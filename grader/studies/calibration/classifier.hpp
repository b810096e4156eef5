#pragma once
/// \file
/// How well one number tells right answers from wrong ones.

#include <cstddef>
#include <optional>
#include <vector>

namespace ggrade::calibration {

/// Errors of both kinds, of so many answers.
struct Errors {
  std::size_t right = 0, rightRejected = 0; ///< right answers; those that were taken for wrong
  std::size_t wrong = 0, wrongAccepted = 0; ///< wrong answers; those that were taken for right

  Errors& operator+=(const Errors& other);
  bool operator==(const Errors&) const = default;
};

/// Upper end of the 95% interval of a share of which `found` of `count` were seen: what the share
/// may be although it was seen less often. 1 without any. Wilson: "Probable Inference, the Law of
/// Succession, and Statistical Inference", JASA 22 (1927).
double upperBound(std::size_t found, std::size_t count);

/// One answer as a measure sees it.
struct Rated {
  bool right = false;
  int half = 0;     ///< of the catalogue: 0 or 1
  double value = 0; ///< more is worse; infinite where there was nothing to measure. Not NaN.
};

/// Area under the ROC curve: how often a wrong answer has the greater value of the two, if a right
/// one and a wrong one are drawn; equal values count half. 1 tells all of them apart, 0.5 is
/// guessing. None without answers of both kinds.
std::optional<double> areaUnderRoc(const std::vector<Rated>& all);

/// The largest value that counts as right, chosen on one half: where the shares of right answers
/// that are rejected and of wrong ones that are accepted have the least sum (Youden 1950), in the
/// middle between two values that were found; the strictest if there are several. 0 where that half
/// has no answer.
double chooseThreshold(const std::vector<Rated>& all, int half);

/// What a threshold gets wrong on one half.
Errors errorsOf(const std::vector<Rated>& all, int half, double threshold);

} // namespace ggrade::calibration
