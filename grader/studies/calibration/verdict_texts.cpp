#include "calibration/subject.hpp"
#include "calibration/verdicts.hpp"

#include "report/text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace ggrade::calibration {

using nlohmann::json;

json toJson(const Verdicts& verdicts, const std::vector<Measured>& all) {
  json programs = json::array();
  for (std::size_t i = 0; i < verdicts.rows.size(); ++i) {
    const Row& row = verdicts.rows[i];
    json scores = json::array();
    for (const Score& score : all.at(i).scores) scores.push_back(toJson(score));
    json one = {{"name", row.name},         {"kind", name(row.kind)},   {"title", row.title},
                {"gradings", row.gradings}, {"accepted", row.accepted}, {"failures", row.failures},
                {"scores", scores}};
    if (row.gradings) {
      one["lowest"] = row.lowest;
      one["mean"] = row.mean;
      one["highest"] = row.highest;
      if (std::isfinite(row.margin)) one["margin"] = row.margin;
    }
    if (!row.item.empty()) {
      one["item"] = row.item;
      one["item_loss"] = row.itemLoss;
    }
    programs.push_back(std::move(one));
  }
  const auto& confusion = verdicts.confusion;
  json result = {{"part", verdicts.part},
                 {"seeds", verdicts.seeds},
                 {"limits",
                  {{"right_score", kRightScore},
                   {"spread", kSpread},
                   {"item_loss", kItemLoss},
                   {"keep_loss", kKeepLoss},
                   {"required_cost", kRequiredCost}}},
                 {"confusion",
                  {{"right_accepted", confusion[0][0]},
                   {"right_rejected", confusion[0][1]},
                   {"wrong_accepted", confusion[1][0]},
                   {"wrong_rejected", confusion[1][1]}}},
                 {"pairs", verdicts.pairs},
                 {"programs", programs}};
  if (std::isfinite(verdicts.lowestRight)) result["lowest_right"] = verdicts.lowestRight;
  if (std::isfinite(verdicts.highestWrong)) result["highest_wrong"] = verdicts.highestWrong;
  return result;
}

std::string tableOf(const Verdicts& verdicts) {
  std::size_t width = 7, gradings = 0;
  for (const Row& row : verdicts.rows) {
    width = std::max(width, row.name.size());
    gradings += row.gradings;
  }
  std::string text = fmt::format("{}: {} programs, seeds {}, {} gradings\n\n", verdicts.part,
                                 verdicts.rows.size(), fmt::join(verdicts.seeds, ", "), gradings);
  text += fmt::format("{:<{}}  {:<9}  {:>6}  {:>6}  {:>7}  {:>9}  {:>6}\n", "program", width,
                      "kind", "lowest", "mean", "highest", "item lost", "margin");
  for (const Row& row : verdicts.rows) {
    text += fmt::format("{:<{}}  {:<9}", row.name, width, name(row.kind));
    if (row.gradings == 0) {
      text += "  not graded  FAILS\n";
      continue;
    }
    text +=
        fmt::format("  {:>6.1f}  {:>6.1f}  {:>7.1f}  {:>9}  {:>6}  {}\n", row.lowest, row.mean,
                    row.highest, row.itemLoss < 0 ? "" : fmt::format("{:.0f}%", 100 * row.itemLoss),
                    std::isfinite(row.margin) ? fmt::format("{:.1f}", row.margin) : "",
                    row.failures.empty() ? "ok" : "FAILS");
  }
  text += '\n';
  if (std::isfinite(verdicts.lowestRight))
    text += fmt::format("Right answers score {} or more (what they may lose given back).\n",
                        report::number(verdicts.lowestRight));
  if (std::isfinite(verdicts.highestWrong))
    text += fmt::format("Wrong ones in what is required score {} or less.\n",
                        report::number(verdicts.highestWrong));
  const auto& confusion = verdicts.confusion;
  text += fmt::format("Right answers taken for wrong: {} of {}. Wrong ones taken for right: {} of "
                      "{}. Pairs of mistakes: {}.\n",
                      confusion[0][1], confusion[0][0] + confusion[0][1], confusion[1][0],
                      confusion[1][0] + confusion[1][1], verdicts.pairs);
  if (verdicts.seconds > 0)
    text +=
        fmt::format("Rendering and judging took {:.2f} s a grading (median).\n", verdicts.seconds);
  return text;
}

} // namespace ggrade::calibration
