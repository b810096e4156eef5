#include "calibration/trade.hpp"

#include "report/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ggrade::calibration {

using report::escapeXml;
using report::number;

namespace {

// All in the SVG's own units; the page scales it to its width.
constexpr double kWidth = 1040, kHeight = 380, kLeft = 70, kRight = 1010, kTop = 24, kBottom = 320;

/// From the least to the greatest value, in steps of 1, 2 or 5 times a power of ten.
struct Axis {
  double from, to, step;

  Axis(double least, double greatest) {
    const double raw = std::max(greatest - least, 1e-9) / 6;
    const double power = std::pow(10, std::floor(std::log10(raw)));
    const double lead = raw / power;
    step = power * (lead <= 1 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10);
    from = step * std::floor(least / step);
    to = step * std::max(std::ceil(greatest / step), from / step + 1);
  }
  double share(double value) const { return (value - from) / (to - from); }
  int count() const { return int(std::lround((to - from) / step)); }
  double tick(int i) const { return from + i * step; }
};

/// How a sweep is drawn: its class in the sheet, and where its labels stand beside their dots.
struct Line {
  const char *sweep, *style;
  double x, y;
};

constexpr Line kLines[] = {
    {"quality", "one", 0, -12}, {"window size", "two", 0, 22}, {"hidden scenes", "three", -14, 22}};

} // namespace

std::string chartOf(const Trade& trade) {
  double slowest = 0, least = 0, most = 0;
  for (const TradeRow& row : trade.rows) {
    if (!std::isfinite(row.margin())) return {};
    slowest = std::max(slowest, row.seconds.median);
    least = std::min(least, row.margin());
    most = std::max(most, row.margin());
  }
  const Axis x(0, slowest), y(least, most);
  const auto u = [&](double seconds) { return kLeft + (kRight - kLeft) * x.share(seconds); };
  const auto v = [&](double margin) { return kBottom - (kBottom - kTop) * y.share(margin); };
  std::string marks;
  for (int i = 0; i <= x.count(); ++i)
    marks += fmt::format("<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" "
                         "y2=\"{2}\"/><text class=\"tick\" x=\"{0:.1f}\" y=\"{3}\" "
                         "text-anchor=\"middle\">{4}</text>",
                         u(x.tick(i)), kTop, kBottom, kBottom + 18, number(x.tick(i)));
  for (int i = 0; i <= y.count(); ++i)
    marks +=
        fmt::format("<line class=\"grid\" x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" "
                    "y2=\"{2:.1f}\"/><text class=\"tick\" x=\"{3}\" y=\"{4:.1f}\" "
                    "text-anchor=\"end\">{5}</text>",
                    kLeft, kRight, v(y.tick(i)), kLeft - 8, v(y.tick(i)) + 4, number(y.tick(i)));
  std::set<std::pair<double, double>> known;
  for (const Line& line : kLines) {
    std::string path, dots;
    for (const TradeRow& row : trade.rows) {
      if (row.sweep != line.sweep) continue;
      const double a = u(row.seconds.median), b = v(row.margin());
      const bool errs = row.errors.rightRejected + row.errors.wrongAccepted > 0;
      const std::string about = escapeXml(
          fmt::format("{}: {}, {} s, margin {}, {} right and {} wrong answers misjudged", row.sweep,
                      row.name, number(row.seconds.median), number(row.margin(), 1),
                      row.errors.rightRejected, row.errors.wrongAccepted));
      path += fmt::format("{}{:.1f},{:.1f}", path.empty() ? "" : " ", a, b);
      // What stands in several sweeps has one name.
      const bool named = !known.insert({a, b}).second;
      dots += fmt::format("<circle class=\"{}{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\"><title>{}"
                          "</title></circle><text class=\"tick\" x=\"{:.1f}\" y=\"{:.1f}\" "
                          "text-anchor=\"{}\">{}</text>",
                          line.style, errs ? " errs" : "", a, b, about, a + line.x, b + line.y,
                          line.x < 0 ? "end" : "middle", named ? "" : escapeXml(row.name));
    }
    marks += fmt::format("<polyline class=\"{}\" points=\"{}\"/>", line.style, path) + dots;
  }
  std::string legend;
  for (std::size_t i = 0; i < std::size(kLines); ++i)
    legend += fmt::format("<circle class=\"{0}\" cx=\"{1}\" cy=\"{2}\" r=\"5\"/><text x=\"{3}\" "
                          "y=\"{4}\">{5}</text>",
                          kLines[i].style, kLeft + 10 + 130 * double(i), kBottom + 42,
                          kLeft + 22 + 130 * double(i), kBottom + 46, kLines[i].sweep);
  return fmt::format("<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}, "
                     "margin in points against seconds of a grading\">{}{}<text class=\"tick\" "
                     "x=\"{}\" y=\"{}\" text-anchor=\"end\">seconds of a grading</text><text "
                     "class=\"tick\" x=\"8\" y=\"14\">margin, points (rings: answers were "
                     "misjudged)</text></svg>",
                     kWidth, kHeight, escapeXml(trade.part), marks, legend, kRight, kBottom + 46);
}

} // namespace ggrade::calibration
