#pragma once
/// \file
/// What a class did as a whole, in numbers: for the class page.

#include "report/class_page.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ggrade::report {

/// Whether the row's final score counts: a submission that was not gradable has one only where an
/// instructor decided on its total.
bool hasScore(const ClassRow& row);

/// Final scores of those who have one. Quartiles lie between neighbours by linear interpolation
/// (type 7 of Hyndman and Fan 1996, as spreadsheets do); all are 0 when `count` is.
struct ScoreFigures {
  std::size_t count = 0;
  double most = 0; ///< largest maximum score in the class
  double mean = 0, median = 0, lowerQuartile = 0, upperQuartile = 0;
};
ScoreFigures scoreFigures(std::span<const ClassRow> rows);

inline constexpr std::size_t kBins = 10;

/// The tenth of `most` that `score` lies in, 0 to 9, upper ends excluded but the last; `kBins` for
/// what lies above `most`. None if either is no number or `most` is not above 0.
std::optional<std::size_t> binOf(double score, double most);

/// Rows that have something in common.
struct ClassGroup {
  std::string id, text;
  std::vector<std::size_t> rows; ///< indices, each once
};

/// By diagnosis, most frequent first; then the unknown ones under an empty ID, if there are any.
std::vector<ClassGroup> groupByDiagnosis(std::span<const ClassRow> rows);
/// By outcome, in the outcomes' order; `id` is the contract's name.
std::vector<ClassGroup> groupByOutcome(std::span<const ClassRow> rows);

/// One item over the class.
struct ItemFigures {
  std::string id, title;
  results::ItemKind kind = results::ItemKind::gain;
  double share = 0; ///< mean of points earned (keep: kept) over points, where it was judged, 0 to 1
  std::size_t judged = 0, lost = 0; ///< submissions
};
/// Hardest first; items that were never judged last.
std::vector<ItemFigures> itemFigures(std::span<const ClassRow> rows);

} // namespace ggrade::report
