#include "tradeoff/chart.hpp"

#include "report/text.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ggrade::tradeoff {

using report::escapeXml;

namespace {

// English, as pages are; handouts have it translated, see chartInWords.
constexpr std::string_view kTimeAxis = gg::tag("milliseconds of a frame");

/// One axis of logarithms, from a power of ten (or 2 or 5 times one) to another. What is 0 or less
/// (noise, or no error at all) stands at the axis' beginning.
class Axis {
public:
  Axis(const std::vector<double>& values, double from, double to) : from_(from), to_(to) {
    double least = 0, most = 0;
    for (double value : values) {
      if (value <= 0) continue;
      least = least == 0 ? value : std::min(least, value);
      most = std::max(most, value);
    }
    if (most == 0) least = most = 1;
    low_ = std::max(roundDown(least), roundDown(most) * 1e-6);
    high_ = low_;
    while (high_ < most) high_ = nextTick(high_);
    if (high_ == low_) high_ = nextTick(high_);
  }

  double at(double value) const {
    const double share = std::log(std::clamp(value, low_, high_) / low_) / std::log(high_ / low_);
    return from_ + share * (to_ - from_);
  }

  /// 1, 2 and 5 times powers of ten; of a long axis the powers alone.
  std::vector<double> ticks() const {
    const bool wide = high_ / low_ > 1000;
    std::vector<double> all;
    for (double tick = low_; tick <= high_ * 1.001; tick = nextTick(tick))
      if (!wide || leadOf(tick) == 1) all.push_back(tick);
    return all;
  }

private:
  static int leadOf(double value) {
    return int(std::lround(value / std::pow(10, std::floor(std::log10(value) + 1e-9))));
  }
  static double roundDown(double value) {
    const double power = std::pow(10, std::floor(std::log10(value) + 1e-9));
    const double lead = value / power + 1e-9;
    return power * (lead >= 5 ? 5 : lead >= 2 ? 2 : 1);
  }
  static double nextTick(double value) { return value * (leadOf(value) == 2 ? 2.5 : 2); }

  double from_, to_, low_ = 1, high_ = 10;
};

std::string tickText(double value, bool error) {
  if (!error) return fmt::format("{:.3g}", value);
  return value < 1e-5 ? fmt::format("{:.0e}", value) : fmt::format("{:.3g}%", 100 * value);
}

/// A line and its text at every tick of an upright axis; errors as shares, times as they are.
std::string linesAcross(const Axis& y, double left, double right, bool error) {
  std::string lines;
  for (double tick : y.ticks())
    lines += fmt::format(
        "<line class=\"grid\" x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/><text "
        "class=\"tick\" x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>",
        left, right, y.at(tick), left - 8, y.at(tick) + 4, tickText(tick, error));
  return lines;
}

std::string gridOf(const Axis& x, const Axis& y, double left, double right, double top,
                   double bottom) {
  std::string grid;
  for (double tick : x.ticks())
    grid += fmt::format(
        "<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\"/><text "
        "class=\"tick\" x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4}</text>",
        x.at(tick), top, bottom, bottom + 18, tickText(tick, false));
  return grid + linesAcross(y, left, right, true);
}

std::string about(const Point& point) {
  return escapeXml(fmt::format("{}: {}, {} {}", settingText(point.setting), msText(point.ms.median),
                               point.errors[0].name, errorText(point.error())));
}

/// "fast, balanced": the presets that are this point.
std::string presetsAt(const Findings& findings, std::size_t point) {
  std::string names;
  for (const Preset& preset : findings.presets)
    if (preset.point == point) names += (names.empty() ? "" : ", ") + preset.name;
  return names;
}

/// Opens an image that a screen reader can name and describe; IDs are the page's own.
std::string openSvg(double width, double height, const std::string& id, const std::string& title,
                    const std::string& description, const char* kind) {
  return fmt::format("<svg class=\"{5}\" viewBox=\"0 0 {0} {1}\" role=\"img\" "
                     "aria-labelledby=\"{2}-title {2}-desc\"><title id=\"{2}-title\">{3}</title>"
                     "<desc id=\"{2}-desc\">{4}</desc>",
                     width, height, id, escapeXml(title), escapeXml(description), kind);
}

} // namespace

std::string frontChart(const Measured& measured, const Findings& findings, Labels labels) {
  constexpr double kWidth = 1040, kHeight = 460, kLeft = 76, kRight = 1016, kTop = 26,
                   kBottom = 400;
  const std::vector<Point>& points = measured.points;
  std::vector<double> times, errors;
  for (const Point& point : points) {
    times.push_back(point.ms.median);
    errors.push_back(point.error());
  }
  const Axis x(times, kLeft + 14, kRight - 14), y(errors, kBottom - 14, kTop + 14);
  std::string dots, line, front, description;
  for (const Point& point : points)
    dots += fmt::format("<circle class=\"other\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\"><title>{}"
                        "</title></circle>",
                        x.at(point.ms.median), y.at(point.error()), about(point));
  for (std::size_t i = 0; i < findings.front.size(); ++i) {
    const Point& point = points[findings.front[i]];
    const double u = x.at(point.ms.median), v = y.at(point.error());
    line += fmt::format("{}{:.1f},{:.1f}", i == 0 ? "" : " ", u, v);
    const std::string label =
        labels == Labels::places ? std::to_string(i + 1) : presetsAt(findings, findings.front[i]);
    // By turns above and below, so that neighbours' labels don't meet.
    front += fmt::format("<circle class=\"best\" cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"5.5\"><title>{2}"
                         "</title></circle><text class=\"label\" x=\"{0:.1f}\" y=\"{3:.1f}\" "
                         "text-anchor=\"middle\">{4}</text>",
                         u, v, about(point), i % 2 == 0 ? v - 11 : v + 21, label);
    description += fmt::format("{}{}: {}.", i == 0 ? "" : " ", i + 1, about(point));
  }
  const Sweep& sweep = measured.sweep;
  const std::string& error = points.at(0).errors.at(0).name;
  return openSvg(kWidth, kHeight, "chart-" + sweep.part + '-' + sweep.name,
                 fmt::format("{}, {}: time against {}", sweep.part, sweep.name, error),
                 "The front, fastest first. " + description, "chart") +
         gridOf(x, y, kLeft, kRight, kTop, kBottom) +
         fmt::format("<text class=\"axis\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>"
                     "<text class=\"axis\" x=\"{}\" y=\"14\">{}</text>",
                     kRight, kBottom + 42, kTimeAxis, 8, escapeXml(error)) +
         dots + "<polyline class=\"front\" points=\"" + line + "\"/>" + front + "</svg>";
}

std::string curveChart(const Measured& measured, const Curve& curve, bool cost) {
  constexpr double kWidth = 500, kHeight = 220, kLeft = 66, kRight = 486, kTop = 26, kBottom = 176;
  const auto& indices = curve.table.points;
  std::vector<double> values;
  for (std::size_t index : indices)
    values.push_back(cost ? measured.points[index].ms.median : measured.points[index].error());
  const Axis y(values, kBottom - 8, kTop + 8);
  std::string marks = linesAcross(y, kLeft, kRight, !cost), line, description;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const Point& point = measured.points[indices[i]];
    const double u = kLeft + (kRight - kLeft) * (double(i) + 0.5) / double(indices.size());
    const double v = y.at(values[i]);
    const std::string value = point.setting.at(curve.number.name).dump();
    const std::string text = cost ? msText(values[i]) : errorText(values[i]);
    line += fmt::format("{}{:.1f},{:.1f}", i == 0 ? "" : " ", u, v);
    if (cost)
      marks += fmt::format("<line class=\"spread\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" "
                           "y2=\"{2:.1f}\"/>",
                           u, y.at(point.ms.q1), y.at(point.ms.q3));
    marks += fmt::format("<circle class=\"best\" cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"4.5\"><title>{2}"
                         "</title></circle><text class=\"tick\" x=\"{0:.1f}\" y=\"{3}\" "
                         "text-anchor=\"middle\">{4}</text>",
                         u, v, about(point), kBottom + 18, value);
    description += fmt::format("{}{}: {}.", i == 0 ? "" : " ", value, text);
  }
  const std::string what = cost ? std::string(kTimeAxis) : measured.points.at(0).errors.at(0).name;
  return openSvg(kWidth, kHeight,
                 fmt::format("curve-{}-{}", curve.number.name, cost ? "time" : "error"),
                 fmt::format("{} by {}", what, curve.number.name), description, "curve") +
         fmt::format("<text class=\"axis\" x=\"8\" y=\"14\">{}</text><text class=\"axis\" "
                     "x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>",
                     escapeXml(what), kRight, kBottom + 38, escapeXml(curve.number.name)) +
         "<polyline class=\"front\" points=\"" + line + "\"/>" + marks + "</svg>";
}

} // namespace ggrade::tradeoff
