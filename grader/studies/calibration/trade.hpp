#pragma once
/// \file
/// The grader's own trade: what looking closer costs, and how much less it errs. And whether one
/// number for a picture would do instead of a rubric.

#include "calibration/classifier.hpp"
#include "calibration/measure.hpp"
#include "calibration/page.hpp"
#include "tradeoff/analysis.hpp"

namespace ggrade::calibration {

/// One row: the catalogue graded with one look.
struct TradeSetting {
  std::string sweep; ///< "quality", "window size" or "hidden scenes"
  std::string name;  ///< "fast", "1/4", "2 of 5"
  std::size_t look;  ///< into TradePlan::looks; rows that are the same share one
};

struct TradePlan {
  std::vector<Look> looks; ///< the first is balanced, with measures
  std::vector<TradeSetting> settings;
};

/// The three qualities; balanced with windows of 1/4, 1/2, 3/4 and the whole of their sides;
/// balanced with 0, 1, 2, 4 and all of `hidden` hidden scenes.
TradePlan tradePlan(std::size_t hidden);

struct TradeRow {
  std::string sweep, name;
  tradeoff::Spread seconds; ///< of a grading that came to an end
  Errors errors;            ///< as Verdicts::confusion has them
  double lowestRight = 0, highestWrong = 0;
  std::vector<std::string> failures; ///< sentences

  double margin() const { return lowestRight - highestWrong; } ///< points; may not be finite
};

/// One number as a classifier of right against wrong.
struct MeasureRow {
  std::string name;
  std::optional<std::array<double, 2>> thresholds; ///< chosen on either half; none: fixed limits
  Errors errors;                                   ///< of each threshold on the other half
  std::optional<double> area;                      ///< under the ROC curve
  double ms = 0;                                   ///< for a picture (median)
};

struct Trade {
  std::string part;
  std::vector<std::uint64_t> seeds;
  std::vector<std::string> hiddenScenes; ///< names, in their order
  std::vector<TradeRow> rows;
  std::vector<MeasureRow> measures; ///< the rubric's two lines last
  std::vector<std::string> leftOut; ///< right answers that may lose points: not in `measures`
};

/// `measured` by look of `plan`; `items` are the part's.
Trade tradeOf(const std::string& part, const std::vector<ItemDeclaration>& items,
              const TradePlan& plan, const std::vector<std::vector<Measured>>& measured);

struct TradeOptions {
  std::vector<std::uint64_t> seeds;
  unsigned jobs = grading::workers(); ///< gradings at a time
  grading::Progress progress;
};

/// Grades the mistakes, the right answers, the reference and the stub among `programs` with every
/// look. Throws like `measure`, and UsageError if there are none among them.
Trade measureTrade(const Target& target, const std::filesystem::path& solutionFolder,
                   std::vector<KnownAnswer> programs, const TradeOptions& options);

nlohmann::json toJson(const Trade& trade);
/// RFC 4180, a line for each row of each part; what a row doesn't have is empty.
std::string csvOf(const std::vector<Trade>& all);
/// A table for each sweep, the chart with the first, and one for the measures.
std::vector<Section> sectionsOf(const Trade& trade);
/// The tables for a terminal.
std::string textOf(const Trade& trade);
/// Margin against seconds as an inline SVG; empty where there is no margin.
std::string chartOf(const Trade& trade);

} // namespace ggrade::calibration
