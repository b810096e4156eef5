#include "calibration/trade.hpp"

#include "calibration/tolerances.hpp"
#include "calibration/whole_image.hpp"

#include <fmt/format.h>

#include <limits>

namespace ggrade::calibration {

using grading::Quality;

TradePlan tradePlan(std::size_t hidden) {
  TradePlan plan;
  plan.looks = {{Quality::balanced, 1, {}, true, true}};
  const auto add = [&](const Look& look) {
    plan.looks.push_back(look);
    return plan.looks.size() - 1;
  };
  // First the fewer scenes, which need no other reference's pictures.
  std::vector<TradeSetting> scenes;
  for (std::size_t count : {0, 1, 2, 4})
    if (count < hidden)
      scenes.push_back({"hidden scenes", fmt::format("{} of {}", count, hidden),
                        add({Quality::balanced, 1, count, true, false})});
  scenes.push_back({"hidden scenes", fmt::format("all {}", hidden), 0});
  plan.settings = {{"quality", "fast", add({Quality::fast, 1, {}, true, false})},
                   {"quality", "balanced", 0},
                   {"quality", "thorough", add({Quality::thorough, 1, {}, true, false})}};
  const std::pair<const char*, double> scales[] = {{"1/4", 0.25}, {"1/2", 0.5}, {"3/4", 0.75}};
  for (const auto& [name, scale] : scales)
    plan.settings.push_back(
        {"window size", name, add({Quality::balanced, scale, {}, true, false})});
  plan.settings.push_back({"window size", "whole", 0});
  plan.settings.insert(plan.settings.end(), scenes.begin(), scenes.end());
  return plan;
}

namespace {

Errors errorsOf(const Verdicts& verdicts) {
  const auto& [right, wrong] = verdicts.confusion;
  return {right[0] + right[1], right[1], wrong[0] + wrong[1], wrong[0]};
}

TradeRow rowOf(const TradeSetting& setting, const Verdicts& verdicts,
               const std::vector<Measured>& measured) {
  std::vector<double> seconds;
  for (const Measured& one : measured)
    for (const Score& score : one.scores)
      if (score.outcome == results::Outcome::graded) seconds.push_back(score.seconds);
  return {setting.sweep,      setting.name,         tradeoff::spreadOf(seconds),
          errorsOf(verdicts), verdicts.lowestRight, verdicts.highestWrong,
          verdicts.failures()};
}

/// A program that must crash need not do so where the scene in which it does is left out: then its
/// points decide alone.
std::vector<Measured> withoutTheirEnd(std::vector<Measured> measured) {
  for (Measured& one : measured)
    for (Score& score : one.scores)
      if (score.outcome == results::Outcome::graded) score.outcome = one.program.outcome;
  return measured;
}

/// What a value of one grading says of all programs; infinite where pictures are missing.
template <class Value>
std::vector<Rated> rate(const std::vector<Measured>& measured, const Value& value) {
  std::vector<Rated> all;
  for (const Measured& one : measured)
    for (const Score& score : one.scores)
      all.push_back(
          {isRight(one.program.kind), halfOf(one.program.name),
           score.measures.empty() ? std::numeric_limits<double>::infinity() : value(score)});
  return all;
}

template <class Value> double median(const std::vector<Measured>& measured, const Value& value) {
  std::vector<double> all;
  for (const Measured& one : measured)
    for (const Score& score : one.scores)
      if (!score.measures.empty()) all.push_back(value(score));
  return tradeoff::spreadOf(all).median;
}

/// Each half's threshold counts on the other.
MeasureRow classify(const std::string& name, const std::vector<Rated>& rated, double ms) {
  MeasureRow row{name,
                 std::array{chooseThreshold(rated, 0), chooseThreshold(rated, 1)},
                 {},
                 areaUnderRoc(rated),
                 ms};
  for (int half : {0, 1}) row.errors += errorsOf(rated, 1 - half, (*row.thresholds)[half]);
  return row;
}

std::vector<MeasureRow> measureRows(const std::string& part,
                                    const std::vector<ItemDeclaration>& items,
                                    const std::vector<Measured>& measured) {
  std::vector<MeasureRow> rows;
  for (const WholeImage& one : wholeImages())
    rows.push_back(classify(
        one.name,
        rate(measured, [&](const Score& score) { return score.measures.at(one.name).worst; }),
        median(measured, [&](const Score& score) { return score.measures.at(one.name).ms; })));
  double full = 0;
  for (const ItemDeclaration& item : items)
    if (item.kind != results::ItemKind::keep) full += item.points;
  const double ms = median(measured, [](const Score& score) { return score.judgeMs; });
  rows.push_back(classify(
      "rubric: points lost",
      rate(measured, [&](const Score& score) { return full - score.score - score.bonus; }), ms));
  rows.push_back({"rubric: the limits above", {}, errorsOf(judge(part, items, measured)), {}, ms});
  return rows;
}

} // namespace

Trade tradeOf(const std::string& part, const std::vector<ItemDeclaration>& items,
              const TradePlan& plan, const std::vector<std::vector<Measured>>& measured) {
  Trade trade;
  trade.part = part;
  for (const TradeSetting& setting : plan.settings) {
    const std::vector<Measured>& graded = measured.at(setting.look);
    const bool fewer = plan.looks[setting.look].hidden.has_value();
    const Verdicts verdicts = judge(part, items, fewer ? withoutTheirEnd(graded) : graded);
    trade.seeds = verdicts.seeds;
    trade.rows.push_back(rowOf(setting, verdicts, graded));
  }
  std::vector<Measured> compared;
  for (const Measured& one : measured.at(0)) {
    if (one.program.loses.empty())
      compared.push_back(one);
    else
      trade.leftOut.push_back(one.program.name);
  }
  trade.measures = measureRows(part, items, compared);
  return trade;
}

Trade measureTrade(const Target& target, const std::filesystem::path& solutionFolder,
                   std::vector<KnownAnswer> programs, const TradeOptions& options) {
  std::erase_if(programs, [](const KnownAnswer& program) {
    return program.kind == Kind::pair || program.kind == Kind::pictures;
  });
  if (programs.empty())
    throw UsageError("--trade is about mistakes, variants, the reference and the stub: --only "
                     "names none of them");
  std::vector<std::string> hidden;
  for (const grading::SceneCase& scene : grading::drawScenes(target, solutionFolder).scenes)
    if (!scene.isPublic) hidden.push_back(scene.name);
  const TradePlan plan = tradePlan(hidden.size());
  Trade trade = tradeOf(target.id, target.items(), plan,
                        measure(target, solutionFolder, programs,
                                {options.seeds, plan.looks, options.jobs, options.progress}));
  trade.hiddenScenes = std::move(hidden);
  return trade;
}

} // namespace ggrade::calibration
