#include "tradeoff/chart.hpp"

#include "report/chart.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

namespace ggrade::tradeoff {

using report::Axis;
using report::Chart;

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
  return fmt::format("{}: {}, {} {}", settingText(point.setting), msText(point.ms.median),
                     point.errors[0].name, errorText(point.error()));
}

/// "fast, balanced": the presets that are this point.
std::string presetsAt(const Findings& findings, std::size_t point) {
  std::string names;
  for (const Preset& preset : findings.presets)
    if (preset.point == point) names += (names.empty() ? "" : ", ") + preset.name;
  return names;
}

} // namespace

std::string frontChart(const Measured& measured, const Findings& findings, Labels labels) {
  constexpr Chart::Area kArea{76, 1016, 26, 400};
  std::vector<double> times, errors;
  for (const Point& point : measured.points) {
    times.push_back(point.ms.median);
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
    chart.dot("other", x.at(point.ms.median), y.at(point.error()), 4, about(point));
  std::vector<std::pair<double, double>> front;
  for (const std::size_t index : findings.front)
    front.emplace_back(x.at(times[index]), y.at(errors[index]));
  chart.path("front", front);
  std::string description = "The front, fastest first.";
  for (std::size_t i = 0; i < front.size(); ++i) {
    const std::string text = about(measured.points[findings.front[i]]);
    const auto [u, v] = front[i];
    chart.dot("best", u, v, 5.5, text);
    // By turns above and below, so that neighbours' labels don't meet.
    chart.text("label", u, i % 2 == 0 ? v - 11 : v + 21, "middle",
               labels == Labels::places ? std::to_string(i + 1)
                                        : presetsAt(findings, findings.front[i]));
    description += fmt::format(" {}: {}.", i + 1, text);
  }
  return chart.svg("chart", 1040, 460, "chart-" + sweep.part + '-' + sweep.name,
                   fmt::format("{}, {}: time against {}", sweep.part, sweep.name, error),
                   description);
}

std::string curveChart(const Measured& measured, const Curve& curve, bool cost) {
  constexpr Chart::Area kArea{66, 486, 26, 176};
  const auto& indices = curve.table.points;
  const std::string& number = curve.number.name;
  std::vector<double> values;
  for (const std::size_t index : indices)
    values.push_back(cost ? measured.points[index].ms.median : measured.points[index].error());
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
    if (cost) chart.line("spread", u, u, y.at(point.ms.q1), y.at(point.ms.q3));
    chart.dot("best", u, v, 4.5, about(point));
    chart.text("tick", u, kArea.bottom + 18, "middle", value);
    description += fmt::format("{}{}: {}.", i == 0 ? "" : " ", value,
                               cost ? msText(values[i]) : errorText(values[i]));
  }
  return chart.svg("curve", 500, 220, fmt::format("curve-{}-{}", number, cost ? "time" : "error"),
                   fmt::format("{} by {}", what, number), description);
}

} // namespace ggrade::tradeoff
