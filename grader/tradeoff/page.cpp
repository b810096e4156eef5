#include "tradeoff/page.hpp"

#include "report/page.hpp"
#include "report/picture.hpp"
#include "report/templates.hpp"
#include "report/text.hpp"
#include "tradeoff/chart.hpp"

#include <fmt/format.h>

namespace ggrade::tradeoff {

using report::pngDataUri;
using report::sanitizeLine;

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
          {"ms", msText(point.ms.median)},
          {"spread", fmt::format("{} to {}", msText(point.ms.q1), msText(point.ms.q3))},
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

json sweepOf(const Measured& measured, const Findings& findings) {
  const Sweep& sweep = measured.sweep;
  const std::vector<Point>& points = measured.points;
  json front = json::array(), presets = json::array(), advice = json::array(),
       curves = json::array();
  for (const std::size_t index : findings.front) {
    json point = pointOf(points[index]);
    point["number"] = front.size() + 1;
    front.push_back(std::move(point));
  }
  for (const Preset& preset : findings.presets)
    presets.push_back(namedOf(points[preset.point], preset.name, preset.rule));
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
          {"offMs", msText(measured.offMs.median)},
          {"size", fmt::format("{}x{}", size[0].dump(), size[1].dump())},
          {"truthPicture", pngDataUri(measured.truth)},
          {"chart", frontChart(measured, findings, Labels::places)},
          {"front", std::move(front)},
          {"presets", std::move(presets)},
          {"hasAdvice", !findings.advice.empty()},
          {"advice", std::move(advice)},
          {"curves", std::move(curves)}};
}

json growthOf(const GrowthRow& row) {
  std::string costs;
  for (std::size_t i = 0; i < row.values.size(); ++i)
    costs +=
        fmt::format("{}{:.0f}: {}", i == 0 ? "" : ", ", row.values[i], msText(row.ms[i].median));
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
          {"frame", fmt::format("{} of {}", msText(needed.ms.median), msText(against.ms.median))}};
}

json assignmentOf(const PageAssignment& assignment) {
  json sweeps = json::array(), growth = json::array(), saved = json::array();
  for (std::size_t i = 0; i < assignment.measured.size(); ++i)
    sweeps.push_back(sweepOf(assignment.measured[i], assignment.findings[i]));
  for (const GrowthRow& row : assignment.growth) growth.push_back(growthOf(row));
  for (const SavedRow& row : assignment.saved) saved.push_back(savedOf(row));
  std::string machine;
  for (const auto& [name, value] : assignment.machine)
    machine += fmt::format("{}{} {}", machine.empty() ? "" : ", ", name, value);
  const Effort& effort = assignment.effort;
  return {{"assignmentTitle", sanitizeLine(assignment.title)},
          {"assignmentId", sanitizeLine(assignment.id)},
          {"incomplete", !assignment.complete},
          {"sweeps", std::move(sweeps)},
          {"hasGrowth", !growth.empty()},
          {"growth", std::move(growth)},
          {"hasSaved", !saved.empty()},
          {"saved", std::move(saved)},
          {"machine", sanitizeLine(machine)},
          {"effort", fmt::format("{} rounds of {} frames", effort.rounds, effort.frames)}};
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
                             {"nearlyShare", fmt::format("{:.0f}%", 100 * kNearlyShare)},
                             {"nearlyAbsolute", fmt::format("{:g}", kNearlyAbsolute)}},
                            "Time against error");
}

} // namespace ggrade::tradeoff
