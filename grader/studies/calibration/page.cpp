#include "calibration/page.hpp"

#include "image/compare.hpp"
#include "report/chart.hpp"
#include "report/page.hpp"
#include "report/templates.hpp"
#include "report/text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace ggrade::calibration {

using nlohmann::json;
using report::number;
using report::sanitizeLine;

namespace {

// Scores by kind: a dot for each program and seed, and the bounds.

constexpr double kLeft = 190, kRight = 1010, kTop = 26, kBand = 46, kDot = 3.4;
constexpr double kWidth = 1040;

/// Dots of one score would hide each other: spread over the band, the same way every time.
double spreadOf(std::size_t index) {
  const double golden = 0.6180339887498949 * double(index + 1);
  return (golden - double(std::size_t(golden)) - 0.5) * (kBand - 16);
}

struct Band {
  Kind kind;
  const char* label;
  const char* state; ///< class that colours it
};

constexpr Band kBands[] = {
    {Kind::reference, "reference", "full"}, {Kind::variant, "right answers", "full"},
    {Kind::mistake, "mistakes", "none"},    {Kind::pair, "pairs of mistakes", "none"},
    {Kind::pictures, "no program", "none"}, {Kind::stub, "as handed out", "none"}};

std::string plotOf(const Verdicts& verdicts, const std::vector<Measured>& measured) {
  using Dots = std::vector<std::pair<const Row*, const Score*>>;
  std::vector<std::pair<Band, Dots>> bands;
  for (const Band& band : kBands) {
    Dots dots;
    for (std::size_t i = 0; i < verdicts.rows.size(); ++i)
      if (verdicts.rows[i].kind == band.kind)
        for (const Score& score : measured.at(i).scores)
          dots.emplace_back(&verdicts.rows[i], &score);
    if (!dots.empty()) bands.emplace_back(band, dots);
  }
  const double bottom = kTop + kBand * double(bands.size());
  const report::Axis x = report::Axis::linear(0, 100, kLeft, kRight, 10);
  report::Chart chart({kLeft, kRight, kTop, bottom});
  double y = kTop;
  for (const auto& [band, dots] : bands) {
    chart.box("band", kLeft - 8, y + 2, kRight - kLeft + 16, kBand - 4);
    chart.text("", kLeft - 18, y + kBand / 2 + 5, "end", band.label);
    y += kBand;
  }
  chart.gridAlong(x, [](double score) { return number(score); });
  const auto bound = [&](double score, const std::string& label) {
    chart.line("bound", x.at(score), x.at(score), kTop - 6, bottom);
    chart.text("bound", x.at(score) - 4, kTop - 10, "end", label);
  };
  bound(100 - kRequiredCost, fmt::format("{} points lost", number(kRequiredCost)));
  bound(kRightScore, number(kRightScore));
  y = kTop;
  for (const auto& [band, dots] : bands) {
    std::size_t index = 0;
    for (const auto& [row, score] : dots)
      chart.dot(std::string(band.state) + (row->failures.empty() ? "" : " fails"),
                x.at(score->score), y + kBand / 2 + spreadOf(index++), kDot,
                fmt::format("{}, seed {}: {}", row->name, score->seed, number(score->score)));
    y += kBand;
  }
  return chart.svg("plot", kWidth, bottom + 28,
                   fmt::format("Scores of {} by kind of answer", verdicts.part));
}

json sectionOf(const Section& section) {
  json rows = json::array();
  for (const auto& cells : section.rows) rows.push_back({{"cells", report::linesOf(cells)}});
  return {{"sectionTitle", sanitizeLine(section.title)}, {"sectionText", section.text},
          {"columns", report::linesOf(section.columns)}, {"sectionRows", std::move(rows)},
          {"hasTable", !section.columns.empty()},        {"chart", section.chart}};
}

json rowOf(const Row& row) {
  const bool graded = row.gradings > 0, holds = row.failures.empty();
  return {{"name", sanitizeLine(row.name)},
          {"kind", name(row.kind)},
          {"about", sanitizeLine(row.title)},
          {"graded", graded},
          {"lowest", number(row.lowest, 1)},
          {"mean", number(row.mean, 1)},
          {"highest", number(row.highest, 1)},
          {"item", sanitizeLine(row.item)},
          {"itemLoss", row.itemLoss < 0 ? "" : fmt::format("{:.0f}%", 100 * row.itemLoss)},
          {"margin", graded && std::isfinite(row.margin) ? number(row.margin, 1) : ""},
          {"state", holds ? "full" : "none"},
          {"verdict", holds ? "holds" : "fails"},
          {"failures", row.failures}};
}

json partOf(const PagePart& part) {
  const Verdicts& verdicts = part.verdicts;
  const auto& confusion = verdicts.confusion;
  json rows = json::array(), sections = json::array();
  std::size_t gradings = 0;
  for (const Row& row : verdicts.rows) {
    rows.push_back(rowOf(row));
    gradings += row.gradings;
  }
  for (const Section& section : part.sections) sections.push_back(sectionOf(section));
  const std::size_t broken = verdicts.failures().size(), seeds = verdicts.seeds.size();
  return {
      {"id", sanitizeLine(verdicts.part)},
      {"partTitle", sanitizeLine(part.title)},
      {"measured", !verdicts.rows.empty()},
      {"partState", broken == 0 ? "full" : "none"},
      {"partVerdict", verdicts.rows.empty() ? sanitizeLine(part.alone + " alone")
                      : broken == 0         ? "all of it holds"
                                            : fmt::format("{} of it doesn't hold", broken)},
      {"summary",
       fmt::format("{} programs and sets of pictures, graded with {} seed{} each: {} gradings.{}",
                   verdicts.rows.size(), seeds, seeds == 1 ? "" : "s", gradings,
                   verdicts.pairs ? fmt::format(" {} of the programs have two mistakes at once.",
                                                verdicts.pairs)
                                  : std::string())},
      {"hasBoth", std::isfinite(verdicts.lowestRight) && std::isfinite(verdicts.highestWrong)},
      {"lowestRight", number(verdicts.lowestRight, 1)},
      {"highestWrong", number(verdicts.highestWrong, 1)},
      {"rightAccepted", confusion[0][0]},
      {"rightRejected", confusion[0][1]},
      {"wrongAccepted", confusion[1][0]},
      {"wrongRejected", confusion[1][1]},
      {"falseRight", confusion[0][1] ? "none" : "full"},
      {"falseWrong", confusion[1][0] ? "none" : "full"},
      {"plot", plotOf(verdicts, part.measured)},
      {"seedList", fmt::format("{}", fmt::join(verdicts.seeds, ", "))},
      {"rows", std::move(rows)},
      {"sections", std::move(sections)}};
}

} // namespace

std::string calibrationPage(const std::vector<PagePart>& parts, const std::string& figures) {
  json list = json::array();
  std::size_t gradings = 0, wrong = 0, broken = 0;
  for (const PagePart& part : parts) {
    list.push_back(partOf(part));
    const auto& confusion = part.verdicts.confusion;
    gradings += confusion[0][0] + confusion[0][1] + confusion[1][0] + confusion[1][1];
    wrong += confusion[0][1] + confusion[1][0];
    broken += part.verdicts.failures().size();
  }
  const std::string verdict =
      gradings == 0
          ? sanitizeLine(fmt::format("Only {} was measured this time.", parts.at(0).alone))
      : broken == 0
          ? fmt::format("None of {} gradings was wrong.", gradings)
          : fmt::format("{} of {} gradings were wrong; {} thing{} below must hold and do{} not.",
                        wrong, gradings, broken, broken == 1 ? "" : "s", broken == 1 ? "es" : "");
  return report::renderPage({report::templates::k_calibration_mustache,
                             report::templates::k_page_js, report::templates::k_page_js_sha256,
                             report::templates::k_calibration_css},
                            {{"parts", std::move(list)},
                             {"state", broken == 0 ? "full" : "none"},
                             {"verdict", verdict},
                             {"figures", sanitizeLine(figures)},
                             {"rightScore", kRightScore},
                             {"spread", kSpread},
                             {"itemLoss", 100 * kItemLoss},
                             {"keepLoss", 100 * kKeepLoss},
                             {"requiredCost", kRequiredCost},
                             {"stillScore", kStillScore},
                             {"tolerance", kTolerance * 255},
                             {"radius", kRadius},
                             {"window", kWindowSide}},
                            "How this grader was measured");
}

} // namespace ggrade::calibration
