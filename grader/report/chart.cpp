#include "report/chart.hpp"

#include "report/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ggrade::report {
namespace {

std::string units(double value) {
  return number(value, 1);
}

std::string classOf(std::string_view style) {
  return style.empty() ? "" : fmt::format(" class=\"{}\"", style);
}

// Of a value of 1, 2 or 5 times a power of ten.
int leadOf(double value) {
  return int(std::lround(value / std::pow(10, std::floor(std::log10(value) + 1e-9))));
}

double nextTick(double value) {
  return value * (leadOf(value) == 2 ? 2.5 : 2);
}

double roundDown(double value) {
  const double power = std::pow(10, std::floor(std::log10(value) + 1e-9));
  const double lead = value / power + 1e-9;
  return power * (lead >= 5 ? 5 : lead >= 2 ? 2 : 1);
}

} // namespace

Axis Axis::linear(double least, double most, double from, double to, int steps) {
  Axis axis(from, to);
  const double raw = std::max(most - least, 1e-9) / steps;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  const double lead = raw / power;
  const double step = power * (lead <= 1 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10);
  axis.low_ = step * std::floor(least / step);
  axis.high_ = step * std::max(std::ceil(most / step), axis.low_ / step + 1);
  const int count = int(std::lround((axis.high_ - axis.low_) / step));
  for (int i = 0; i <= count; ++i) axis.ticks_.push_back(axis.low_ + i * step);
  return axis;
}

Axis Axis::logarithmic(const std::vector<double>& values, double from, double to) {
  Axis axis(from, to);
  axis.isLogarithmic_ = true;
  double least = 0, most = 0;
  for (const double value : values) {
    if (value <= 0) continue;
    least = least == 0 ? value : std::min(least, value);
    most = std::max(most, value);
  }
  if (most == 0) least = most = 1;
  axis.low_ = std::max(roundDown(least), roundDown(most) * 1e-6);
  axis.high_ = axis.low_;
  while (axis.high_ < most) axis.high_ = nextTick(axis.high_);
  if (axis.high_ == axis.low_) axis.high_ = nextTick(axis.high_);
  const bool isLong = axis.high_ / axis.low_ > 1000;
  for (double tick = axis.low_; tick <= axis.high_ * 1.001; tick = nextTick(tick))
    if (!isLong || leadOf(tick) == 1) axis.ticks_.push_back(tick);
  return axis;
}

double Axis::at(double value) const {
  const double share =
      isLogarithmic_ ? std::log(std::clamp(value, low_, high_) / low_) / std::log(high_ / low_)
                     : (value - low_) / (high_ - low_);
  return from_ + share * (to_ - from_);
}

std::string Chart::acrossText(double x) const {
  return across_ == Across::percent ? number(x, 2) + '%' : units(x);
}

void Chart::gridAlong(const Axis& x, const Label& label) {
  for (const double tick : x.ticks()) {
    line("grid", x.at(tick), x.at(tick), area_.top, area_.bottom);
    text("tick", x.at(tick), area_.bottom + 18, "middle", label(tick));
  }
}

void Chart::gridUp(const Axis& y, const Label& label) {
  for (const double tick : y.ticks()) {
    line("grid", area_.left, area_.right, y.at(tick), y.at(tick));
    text("tick", area_.left - 8, y.at(tick) + 4, "end", label(tick));
  }
}

void Chart::line(std::string_view style, double x1, double x2, double y1, double y2) {
  marks_ += fmt::format("<line{} x1=\"{}\" x2=\"{}\" y1=\"{}\" y2=\"{}\"/>", classOf(style),
                        acrossText(x1), acrossText(x2), units(y1), units(y2));
}

void Chart::path(std::string_view style, const std::vector<std::pair<double, double>>& points) {
  std::string text;
  for (const auto& [x, y] : points)
    text += fmt::format("{}{},{}", text.empty() ? "" : " ", units(x), units(y));
  marks_ += fmt::format("<polyline{} points=\"{}\"/>", classOf(style), text);
}

void Chart::dot(std::string_view style, double x, double y, double radius, std::string_view title) {
  marks_ += fmt::format("<circle{} cx=\"{}\" cy=\"{}\" r=\"{}\"", classOf(style), acrossText(x),
                        units(y), units(radius));
  marks_ += title.empty() ? "/>" : fmt::format("><title>{}</title></circle>", escapeXml(title));
}

void Chart::box(std::string_view style, double x, double y, double width, double height) {
  marks_ += fmt::format("<rect{} x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", classOf(style),
                        acrossText(x), units(y), acrossText(width), units(height));
}

void Chart::text(std::string_view style, double x, double y, std::string_view anchor,
                 std::string_view text) {
  marks_ += fmt::format("<text{} x=\"{}\" y=\"{}\"{}>{}</text>", classOf(style), acrossText(x),
                        units(y), anchor.empty() ? "" : fmt::format(" text-anchor=\"{}\"", anchor),
                        escapeXml(text));
}

std::string Chart::svg(std::string_view style, double width, double height,
                       std::string_view label) const {
  return fmt::format(
      "<svg class=\"{}\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">{}</svg>", style,
      units(width), units(height), escapeXml(label), marks_);
}

std::string Chart::svg(std::string_view style, double width, double height, std::string_view id,
                       std::string_view title, std::string_view description) const {
  return fmt::format("<svg class=\"{0}\" viewBox=\"0 0 {1} {2}\" role=\"img\" "
                     "aria-labelledby=\"{3}-title {3}-desc\"><title id=\"{3}-title\">{4}</title>"
                     "<desc id=\"{3}-desc\">{5}</desc>{6}</svg>",
                     style, units(width), units(height), id, escapeXml(title),
                     escapeXml(description), marks_);
}

} // namespace ggrade::report
