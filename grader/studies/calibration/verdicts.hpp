#pragma once
/// \file
/// What the gradings of known answers say of the grader: do right and wrong ones separate?

#include "calibration/programs.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <string>
#include <vector>

namespace ggrade::calibration {

/// What must hold on every seed, of items as they are before each fault is counted once, unless
/// said otherwise: whose work the proved cause is decides who pays in the end. What a mistake costs
/// at least is half of what it would if it were as wrong in every scene: an item earns up to (1 +
/// worst) / 2, see results::creditOf.
inline constexpr double kRightScore = 98; ///< of 100: a right answer has at least this
inline constexpr double kSpread = 1;      ///< points that a right answer's score may move by seed
inline constexpr double kKeepLoss = 0.6;  ///< share of the named keep item that a mistake loses
inline constexpr double kItemLoss = kKeepLoss / 2; ///< and of any other
inline constexpr double kRequiredCost = 7.5; ///< points that a mistake in a required item costs
/// And where each fault counts once: more than a right answer may lose.
inline constexpr double kOnceCost = 3;

/// One program over all seeds.
struct Row {
  Kind kind = Kind::mistake;
  std::string name, title;
  std::string item;                         ///< the item that must fail, or empty
  std::size_t gradings = 0;                 ///< 0 if it could not be graded
  double lowest = 0, mean = 0, highest = 0; ///< score, without bonus
  double itemLoss = -1; ///< least share of `item` that was lost, 0 to 1; -1 without an item
  /// Points from the worst grading to the nearest limit; below 0 the limit is broken.
  double margin = 0;
  std::size_t accepted = 0;          ///< gradings that took it for a right answer
  std::vector<std::string> failures; ///< sentences
};

struct Verdicts {
  std::string part;
  std::vector<std::uint64_t> seeds;
  std::vector<Row> rows; ///< as they were measured
  double lowestRight = 0,
         highestWrong = 0; ///< scores; wrong: mistakes in required items, pictures, stub
  /// Gradings: [right answer or not][accepted or not]. A right answer is accepted with kRightScore;
  /// a wrong one is not where it lost what it must lose.
  std::array<std::array<std::size_t, 2>, 2> confusion{};
  std::size_t pairs = 0;
  double seconds = 0; ///< median of the gradings that came to an end

  std::vector<std::string> failures() const; ///< of all rows
};

/// `items` are the part's. A pair is compared with its two mistakes on the same seed, which must be
/// among `all`.
Verdicts judge(const std::string& part, const std::vector<ItemDeclaration>& items,
               const std::vector<Measured>& all);

/// The limits, rows and figures, for machines.
nlohmann::json toJson(const Verdicts& verdicts, const std::vector<Measured>& all);

/// The rows as a table of fixed columns, and the figures below it, for a terminal or a log.
std::string tableOf(const Verdicts& verdicts);

} // namespace ggrade::calibration
