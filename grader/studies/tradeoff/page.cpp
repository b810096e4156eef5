#include "tradeoff/page.hpp"

#include "report/chart.hpp"
#include "report/page.hpp"
#include "report/picture.hpp"
#include "report/templates.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace ggrade::tradeoff {

using report::Axis;
using report::Chart;
using report::pngDataUri;
using report::sanitizeLine;

namespace {

// English, as pages are; handouts have it translated, see chartInWords.
constexpr std::string_view kTimeAxis = gg::tag("milliseconds of a frame");

std::string timeTick(double value) {
  return fmt::format("{:.3g}", value);
}

std::string errorTick(double value) {
  return value < 1e-5 ? fmt::format("{:.0e}", value) : fmt::format("{:.3g}%", 100 * value);
}

std::string about(const Point& point) {
  return fmt::format("{}: {} of a frame of {}, {} {}", settingText(point.setting),
                     costText(point.cost), msText(point.cost.whole), point.errors[0].name,
                     errorText(point.error()));
}

/// "fast, balanced": the presets that are this point.
std::string presetsAt(const Findings& findings, std::size_t point) {
  std::string names;
  for (const Preset& preset : findings.presets)
    if (preset.point == point) names += (names.empty() ? "" : ", ") + preset.name;
  return names;
}

/// Names the presets that are not on the front: mostly the reference.
void labelOthers(Chart& chart, const Measured& measured, const Findings& findings, const Axis& x,
                 const Axis& y) {
  for (const Preset& preset : findings.presets) {
    if (std::ranges::find(findings.front, preset.point) != findings.front.end()) continue;
    const Point& point = measured.points[preset.point];
    chart.text("label", x.at(point.cost.value()), y.at(point.error()) - 11, "middle", preset.name);
  }
}

} // namespace

std::string frontChart(const Measured& measured, const Findings& findings, Labels labels) {
  constexpr Chart::Area kArea{76, 1016, 26, 400};
  std::vector<double> times, errors;
  for (const Point& point : measured.points) {
    times.push_back(point.cost.value());
    errors.push_back(point.error());
  }
  const Sweep& sweep = measured.sweep;
  const std::string& error = measured.points.at(0).errors.at(0).name;
  const Axis x = Axis::logarithmic(times, kArea.left + 14, kArea.right - 14);
  const Axis y = Axis::logarithmic(errors, kArea.bottom - 14, kArea.top + 14);
  Chart chart(kArea);
  chart.gridAlong(x, timeTick);
  chart.gridUp(y, errorTick);
  chart.text("axis", kArea.right, kArea.bottom + 42, "end", kTimeAxis);
  chart.text("axis", 8, 14, "", error);
  for (const Point& point : measured.points)
    chart.dot("other", x.at(point.cost.value()), y.at(point.error()), 4, about(point));
  std::vector<std::pair<double, double>> front;
  for (const std::size_t index : findings.front)
    front.emplace_back(x.at(times[index]), y.at(errors[index]));
  chart.path("front", front);
  std::string description = "The front, fastest first.";
  for (std::size_t i = 0; i < front.size(); ++i) {
    const Point& point = measured.points[findings.front[i]];
    const std::string text = about(point);
    const auto [u, v] = front[i];
    chart.line("spread", std::max(x.at(point.cost.low), kArea.left),
               std::min(x.at(point.cost.high), kArea.right), v, v);
    chart.dot("best", u, v, 5.5, text);
    // By turns above and below, so that neighbours' labels don't meet.
    chart.text("label", u, i % 2 == 0 ? v - 11 : v + 21, "middle",
               labels == Labels::places ? std::to_string(i + 1)
                                        : presetsAt(findings, findings.front[i]));
    description += fmt::format(" {}: {}.", i + 1, text);
  }
  if (labels == Labels::presets) labelOthers(chart, measured, findings, x, y);
  const std::string kind = labels == Labels::places ? "chart-" : "trade-";
  return chart.svg("chart", 1040, 460, kind + sweep.part + '-' + sweep.name,
                   fmt::format("{}, {}: time against {}", sweep.part, sweep.name, error),
                   description);
}

std::string curveChart(const Measured& measured, const Curve& curve, bool cost) {
  constexpr Chart::Area kArea{66, 486, 26, 176};
  const auto& indices = curve.table.points;
  const std::string& number = curve.number.name;
  std::vector<double> values;
  for (const std::size_t index : indices)
    values.push_back(cost ? measured.points[index].cost.value() : measured.points[index].error());
  const Axis y = Axis::logarithmic(values, kArea.bottom - 8, kArea.top + 8);
  std::vector<std::pair<double, double>> line;
  for (std::size_t i = 0; i < values.size(); ++i)
    line.emplace_back(kArea.left +
                          (kArea.right - kArea.left) * (double(i) + 0.5) / double(values.size()),
                      y.at(values[i]));
  const std::string what = cost ? std::string(kTimeAxis) : measured.points.at(0).errors.at(0).name;
  Chart chart(kArea);
  chart.text("axis", 8, 14, "", what);
  chart.text("axis", kArea.right, kArea.bottom + 38, "end", number);
  chart.path("front", line);
  chart.gridUp(y, cost ? timeTick : errorTick);
  std::string description;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Point& point = measured.points[indices[i]];
    const auto [u, v] = line[i];
    const std::string value = point.setting.at(number).dump();
    if (cost) chart.line("spread", u, u, y.at(point.cost.low), y.at(point.cost.high));
    chart.dot("best", u, v, 4.5, about(point));
    chart.text("tick", u, kArea.bottom + 18, "middle", value);
    description += fmt::format("{}{}: {}.", i == 0 ? "" : " ", value,
                               cost ? costText(point.cost) : errorText(values[i]));
  }
  return chart.svg("curve", 500, 220, fmt::format("curve-{}-{}", number, cost ? "time" : "error"),
                   fmt::format("{} by {}", what, number), description);
}

namespace {

std::string megabytes(std::uint64_t bytes) {
  return fmt::format("{:.1f} MiB", double(bytes) / (1 << 20));
}

/// The figures and the pictures of a point.
json pointOf(const Point& point) {
  json others = json::array();
  for (std::size_t i = 1; i < point.errors.size(); ++i)
    others.push_back({{"otherName", sanitizeLine(point.errors[i].name)},
                      {"otherValue", errorText(point.errors[i].value)}});
  return {{"setting", sanitizeLine(settingText(point.setting))},
          {"ms", costText(point.cost)},
          {"spread", point.cost.hidden() ? ""
                                         : fmt::format("{} to {}", msText(point.cost.low),
                                                       msText(point.cost.high))},
          {"wide", !point.cost.narrow},
          {"whole", msText(point.cost.whole)},
          {"error", errorText(point.error())},
          {"others", std::move(others)},
          {"rendered", pngDataUri(point.rendered)},
          {"difference", pngDataUri(point.difference)},
          {"paste", pasteOf(point.setting).dump()}};
}

json namedOf(const Point& point, const std::string& name, const std::string& rule) {
  json data = pointOf(point);
  data["name"] = sanitizeLine(name);
  data["rule"] = sanitizeLine(rule);
  data["found"] = true;
  return data;
}

json curveOf(const Measured& measured, const Curve& curve) {
  return {{"curveName", sanitizeLine(curve.number.name)},
          {"fall", curve.fall},
          {"exponent", curve.growth
                           ? fmt::format("Its cost grows with the power {:.2f} of the number; the "
                                         "fit is within {:.0f}%.",
                                         curve.growth->exponent, 100 * curve.growth->deviation)
                           : ""},
          {"errorCurve", curveChart(measured, curve, false)},
          {"timeCurve", curveChart(measured, curve, true)}};
}

json sweepOf(const Measured& measured, const Findings& findings, const Effort& effort) {
  const Sweep& sweep = measured.sweep;
  const std::vector<Point>& points = measured.points;
  json front = json::array(), compared = json::array(), presets = json::array(),
       advice = json::array(), curves = json::array();
  for (const std::size_t index : findings.front) {
    json point = pointOf(points[index]);
    point["place"] = front.size() + 1;
    front.push_back(std::move(point));
  }
  for (const Compared& one : findings.compared) {
    json point = pointOf(points[one.point]);
    point["place"] = sanitizeLine(one.name);
    compared.push_back(std::move(point));
  }
  json pointTables = json::array();
  if (!compared.empty())
    pointTables.push_back(
        {{"heading", "Side by side"}, {"placeHead", "Name"}, {"rows", std::move(compared)}});
  pointTables.push_back(
      {{"heading", "The front"}, {"placeHead", "No."}, {"rows", std::move(front)}});
  for (const PresetRow& row : presetRows(points, findings.presets)) {
    std::string rules;
    std::size_t index = 0;
    for (const Preset& preset : findings.presets)
      if (points[preset.point].setting == row.setting) {
        rules += (rules.empty() ? "" : "; ") + preset.rule;
        index = preset.point;
      }
    presets.push_back(namedOf(points[index], row.name(), rules));
  }
  for (const Advice& answer : findings.advice)
    advice.push_back(answer.point ? namedOf(points[*answer.point], answer.wish, "")
                                  : json{{"name", sanitizeLine(answer.wish)}, {"found", false}});
  for (const Curve& curve : findings.curves) curves.push_back(curveOf(measured, curve));
  const auto size = sweep.scene.at("size");
  return {{"sweepId", sweep.part + '-' + sweep.name},
          {"part", sanitizeLine(sweep.part)},
          {"sweepName", sanitizeLine(sweep.name)},
          {"about", sanitizeLine(sweep.about)},
          {"errorName", sanitizeLine(points.at(0).errors.at(0).name)},
          {"count", points.size()},
          {"offMs", msText(measured.offMs)},
          {"size", fmt::format("{}x{}", size[0].dump(), size[1].dump())},
          {"truthPicture", pngDataUri(measured.truth)},
          {"chart", frontChart(measured, findings, Labels::places)},
          {"roundsNote", roundsText(points, effort)},
          {"pointTables", std::move(pointTables)},
          {"presets", std::move(presets)},
          {"hasAdvice", !findings.advice.empty()},
          {"advice", std::move(advice)},
          {"curves", std::move(curves)}};
}

json growthOf(const GrowthRow& row) {
  std::string costs;
  for (std::size_t i = 0; i < row.values.size(); ++i)
    costs += fmt::format("{}{:.0f}: {}", i == 0 ? "" : ", ", row.values[i], costText(row.costs[i]));
  return {{"growthPart", sanitizeLine(row.part)},
          {"series", sanitizeLine(row.series)},
          {"costs", sanitizeLine(costs)},
          {"power", row.growth ? fmt::format("{:.2f}", row.growth->exponent) : "–"},
          {"deviation", row.growth ? fmt::format("{:.0f}%", 100 * row.growth->deviation) : "–"}};
}

json savedOf(const SavedRow& row) {
  const auto &needed = row.needed, &against = row.against;
  return {{"savedName", sanitizeLine(row.name)},
          {"passes", fmt::format("{} of {}", needed.passes, against.passes)},
          {"memory", fmt::format("{} of {}", megabytes(needed.bytes), megabytes(against.bytes))},
          {"frame", fmt::format("{} of {}", msText(needed.ms), msText(against.ms))},
          {"saved", costText(row.saved)}};
}

/// A part's sentence and chart: those of its first scene, which is the handout's.
json tradesOf(const PageAssignment& assignment) {
  json trades = json::array();
  std::string last;
  for (std::size_t i = 0; i < assignment.measured.size(); ++i) {
    const Measured& measured = assignment.measured[i];
    const Findings& findings = assignment.findings[i];
    if (measured.sweep.part == last) continue;
    last = measured.sweep.part;
    trades.push_back(
        {{"tradePart", sanitizeLine(last)},
         {"trade", sanitizeLine(tradeText(presetRows(measured.points, findings.presets)))},
         {"tradeRounds", roundsText(measured.points, assignment.effort)},
         {"tradeChart", frontChart(measured, findings, Labels::presets)}});
  }
  return trades;
}

json assignmentOf(const PageAssignment& assignment) {
  json sweeps = json::array(), growth = json::array(), saved = json::array();
  for (std::size_t i = 0; i < assignment.measured.size(); ++i)
    sweeps.push_back(sweepOf(assignment.measured[i], assignment.findings[i], assignment.effort));
  for (const GrowthRow& row : assignment.growth) growth.push_back(growthOf(row));
  for (const SavedRow& row : assignment.saved) saved.push_back(savedOf(row));
  std::string machine;
  for (const auto& [name, value] : assignment.machine)
    machine += fmt::format("{}{} {}", machine.empty() ? "" : ", ", name, value);
  const Effort& effort = assignment.effort;
  return {{"assignmentTitle", sanitizeLine(assignment.title)},
          {"assignmentId", sanitizeLine(assignment.id)},
          {"incomplete", !assignment.complete},
          {"trades", tradesOf(assignment)},
          {"sweeps", std::move(sweeps)},
          {"hasGrowth", !growth.empty()},
          {"growth", std::move(growth)},
          {"hasSaved", !saved.empty()},
          {"saved", std::move(saved)},
          {"machine", sanitizeLine(machine)},
          {"effort", fmt::format("{} to {} pairs of runs a setting, {} frames a run", kLeastPairs,
                                 effort.rounds, effort.frames)}};
}

} // namespace

std::string tradeoffPage(const std::vector<PageAssignment>& assignments) {
  json list = json::array();
  for (const PageAssignment& assignment : assignments) list.push_back(assignmentOf(assignment));
  return report::renderPage({report::templates::k_tradeoff_mustache, report::templates::k_page_js,
                             report::templates::k_page_js_sha256,
                             report::templates::k_tradeoff_css},
                            {{"assignments", std::move(list)},
                             {"warmUp", kWarmUp},
                             {"narrow", fmt::format("{:.0f}%", 100 * kNarrow)},
                             {"narrowOfCost", fmt::format("{:.0f}%", 100 * kNarrowOfCost)},
                             {"sameTime", fmt::format("{:.0f}%", 100 * kSameTime)},
                             {"nearlyShare", fmt::format("{:.0f}%", 100 * kNearlyShare)},
                             {"nearlyAbsolute", fmt::format("{:g}", kNearlyAbsolute)}},
                            "Time against error");
}

} // namespace ggrade::tradeoff
