#include "tradeoff/page.hpp"

#include "report/page_parts.hpp"
#include "report/picture.hpp"
#include "report/templates.hpp"
#include "tradeoff/chart.hpp"

#include <fmt/format.h>

namespace ggrade::tradeoff {

using report::Data;
using report::line;
using report::makeList;
using report::optional;

namespace {

std::string megabytes(std::uint64_t bytes) {
  return fmt::format("{:.1f} MiB", double(bytes) / (1 << 20));
}

/// The figures and the pictures of a point; `number` is its place on the front.
Data pointOf(const Point& point, const std::string& number) {
  Data data, others = makeList();
  data["number"] = line(number);
  data["setting"] = line(settingText(point.setting));
  data["ms"] = Data(msText(point.ms.median));
  data["spread"] = Data(fmt::format("{} to {}", msText(point.ms.q1), msText(point.ms.q3)));
  data["error"] = Data(errorText(point.error()));
  for (std::size_t i = 1; i < point.errors.size(); ++i) {
    Data other;
    other["otherName"] = line(point.errors[i].name);
    other["otherValue"] = Data(errorText(point.errors[i].value));
    others << other;
  }
  data["others"] = std::move(others);
  data["rendered"] = optional(report::pngDataUri(point.rendered));
  data["difference"] = optional(report::pngDataUri(point.difference));
  data["paste"] = optional(pasteOf(point.setting).dump());
  return data;
}

Data namedOf(const Point& point, const std::string& name, const std::string& rule) {
  Data data = pointOf(point, "");
  data["name"] = line(name);
  data["rule"] = line(rule);
  data["found"] = Data(true);
  return data;
}

Data curveOf(const Measured& measured, const Curve& curve) {
  Data data;
  data["curveName"] = line(curve.number.name);
  data["fall"] = optional(curve.fall);
  data["exponent"] =
      curve.growth ? line(fmt::format("Its cost grows with the power {:.2f} of the number; the fit "
                                      "is within {:.0f}%.",
                                      curve.growth->exponent, 100 * curve.growth->deviation))
                   : Data(false);
  data["errorCurve"] = Data(curveChart(measured, curve, false));
  data["timeCurve"] = Data(curveChart(measured, curve, true));
  return data;
}

Data sweepOf(const Measured& measured, const Findings& findings) {
  const Sweep& sweep = measured.sweep;
  Data data, front = makeList(), presets = makeList(), advice = makeList(), curves = makeList();
  data["sweepId"] = Data(sweep.part + '-' + sweep.name);
  data["part"] = line(sweep.part);
  data["sweepName"] = line(sweep.name);
  data["about"] = line(sweep.about);
  data["errorName"] = line(measured.points.at(0).errors.at(0).name);
  data["count"] = Data(std::to_string(measured.points.size()));
  data["offMs"] = Data(msText(measured.offMs.median));
  const auto size = sweep.scene.at("size");
  data["size"] = Data(fmt::format("{}x{}", size[0].dump(), size[1].dump()));
  data["truthPicture"] = optional(report::pngDataUri(measured.truth));
  data["chart"] = Data(frontChart(measured, findings, Labels::places));
  for (std::size_t i = 0; i < findings.front.size(); ++i)
    front << pointOf(measured.points[findings.front[i]], std::to_string(i + 1));
  for (const Preset& preset : findings.presets)
    presets << namedOf(measured.points[preset.point], preset.name, preset.rule);
  for (const Advice& answer : findings.advice) {
    if (answer.point) {
      advice << namedOf(measured.points[*answer.point], answer.wish, "");
      continue;
    }
    Data none;
    none["name"] = line(answer.wish);
    none["found"] = Data(false);
    advice << none;
  }
  for (const Curve& curve : findings.curves) curves << curveOf(measured, curve);
  data["front"] = std::move(front);
  data["presets"] = std::move(presets);
  data["hasAdvice"] = Data(!findings.advice.empty());
  data["advice"] = std::move(advice);
  data["curves"] = std::move(curves);
  return data;
}

Data growthOf(const GrowthRow& row) {
  Data data;
  std::string costs;
  for (std::size_t i = 0; i < row.values.size(); ++i)
    costs +=
        fmt::format("{}{:.0f}: {}", i == 0 ? "" : ", ", row.values[i], msText(row.ms[i].median));
  data["growthPart"] = line(row.part);
  data["series"] = line(row.series);
  data["costs"] = line(costs);
  data["power"] = row.growth ? Data(fmt::format("{:.2f}", row.growth->exponent)) : Data("–");
  data["deviation"] =
      row.growth ? Data(fmt::format("{:.0f}%", 100 * row.growth->deviation)) : Data("–");
  return data;
}

Data savedOf(const SavedRow& row) {
  Data data;
  data["savedName"] = line(row.name);
  data["passes"] = Data(fmt::format("{} of {}", row.needed.passes, row.against.passes));
  data["memory"] =
      Data(fmt::format("{} of {}", megabytes(row.needed.bytes), megabytes(row.against.bytes)));
  data["frame"] =
      Data(fmt::format("{} of {}", msText(row.needed.ms.median), msText(row.against.ms.median)));
  return data;
}

Data assignmentOf(const PageAssignment& assignment) {
  Data data, sweeps = makeList(), growth = makeList(), saved = makeList();
  for (std::size_t i = 0; i < assignment.measured.size(); ++i)
    sweeps << sweepOf(assignment.measured[i], assignment.findings[i]);
  for (const GrowthRow& row : assignment.growth) growth << growthOf(row);
  for (const SavedRow& row : assignment.saved) saved << savedOf(row);
  std::string machine;
  for (const auto& [name, value] : assignment.machine)
    machine += fmt::format("{}{} {}", machine.empty() ? "" : ", ", name, value);
  data["assignmentTitle"] = line(assignment.title);
  data["assignmentId"] = line(assignment.id);
  data["incomplete"] = Data(!assignment.complete);
  data["sweeps"] = std::move(sweeps);
  data["hasGrowth"] = Data(!assignment.growth.empty());
  data["growth"] = std::move(growth);
  data["hasSaved"] = Data(!assignment.saved.empty());
  data["saved"] = std::move(saved);
  data["machine"] = line(machine);
  data["effort"] = Data(
      fmt::format("{} rounds of {} frames", assignment.effort.rounds, assignment.effort.frames));
  return data;
}

} // namespace

std::string tradeoffPage(const std::vector<PageAssignment>& assignments) {
  Data data, list = makeList();
  for (const PageAssignment& assignment : assignments) list << assignmentOf(assignment);
  data["assignments"] = std::move(list);
  data["warmUp"] = Data(std::to_string(kWarmUp));
  data["nearlyShare"] = Data(fmt::format("{:.0f}%", 100 * kNearlyShare));
  data["nearlyAbsolute"] = Data(fmt::format("{:g}", kNearlyAbsolute));
  return report::renderPage({report::templates::k_tradeoff_mustache, report::templates::k_page_js,
                             report::templates::k_page_js_sha256,
                             report::templates::k_tradeoff_css},
                            data, "Time against error");
}

} // namespace ggrade::tradeoff
