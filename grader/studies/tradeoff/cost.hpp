#pragma once
/// \file
/// What a part costs, and how surely that is known. Plain numbers in and out; all times are
/// milliseconds of a frame.

#include <string>
#include <vector>

namespace ggrade::tradeoff {

/// A cost is known well enough if its interval is narrower than this share of the whole frame, ...
inline constexpr double kNarrow = 0.1;
/// ... and, unless it reaches down to 0, than this share of the cost: two runs then agree to within
/// half of it.
inline constexpr double kNarrowOfCost = 0.1;
/// Of fewer pairs no interval holds the median with 95%: the whole sample holds it with
/// 1 - 2 / 2^pairs.
inline constexpr unsigned kLeastPairs = 6;
/// Times within this share of the quicker one are the same time, however surely they differ.
inline constexpr double kSameTime = 0.05;

/// Where the median of what a sample was drawn from lies with 95%.
struct Interval {
  double median = 0, low = 0, high = 0;
};

/// By order statistics: the k-th value from below and from above, with the largest k for which the
/// median lies outside with 5% at most. The number of values below it has a binomial distribution
/// (Conover, Practical Nonparametric Statistics, 3rd edition, 3.2); nothing is supposed of how the
/// values are distributed. Of less than kLeastPairs values the whole sample; all 0 of none.
Interval medianInterval(std::vector<double> values);

/// Runs with and without a part, by turns: with[i] and without[i] are neighbours in time.
struct Pairs {
  std::vector<double> with, without; ///< of each run, its least frame
};

/// The median of the pairs' differences, and its interval. A part takes no time back: what noise
/// puts below 0 is 0.
struct Cost {
  double median = 0, low = 0, high = 0;
  double whole = 0;    ///< of the whole frame with the part (median)
  bool narrow = false; ///< see kNarrow, kNarrowOfCost

  /// The interval holds 0: it is known only that the cost is not above `high`.
  bool hidden() const { return low <= 0; }
  /// What charts and rules take for the cost: of a hidden one, the most that it can be.
  double value() const { return hidden() ? high : median; }
};

Cost costOf(const Pairs& pairs);

/// Whether another round is needed: there are too few pairs, or the interval is too wide.
bool needsMore(const Pairs& pairs);

/// Their intervals lie apart, and by more than kSameTime.
bool faster(const Cost& a, const Cost& b);

double medianOf(std::vector<double> values); ///< 0 of none

/// Milliseconds: "12.3 ms", "0.41 ms".
std::string msText(double ms);
/// The same; of a hidden cost "below 0.42 ms" in the language that was chosen, rounded up; "none"
/// where even the upper end is 0.
std::string costText(const Cost& cost);

} // namespace ggrade::tradeoff
