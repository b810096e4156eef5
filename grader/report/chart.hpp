#pragma once
/// \file
/// Charts as inline SVG. Colours and widths come from the page's sheet, by class; the page scales a
/// chart to its own width.

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ggrade::report {

/// One direction of a chart: where a value lies between `from` and `to`, and which values get a
/// tick.
class Axis {
public:
  /// At least from `least` to `most`, in about `steps` steps of 1, 2 or 5 times a power of ten.
  static Axis linear(double least, double most, double from, double to, int steps = 6);
  /// From one of 1, 2 or 5 times a power of ten to another, with a tick at each; of a long axis at
  /// the powers alone. What is 0 or less (noise, or no error at all) lies at the axis' beginning.
  static Axis logarithmic(const std::vector<double>& values, double from, double to);

  double at(double value) const;
  const std::vector<double>& ticks() const { return ticks_; }

private:
  Axis(double from, double to) : from_(from), to_(to) {}

  double from_, to_, low_ = 0, high_ = 1;
  bool isLogarithmic_ = false;
  std::vector<double> ticks_;
};

/// What is drawn, in that order. Coordinates are rounded to a tenth; texts are escaped here.
///
///     Chart chart({70, 1010, 24, 320});
///     chart.gridAlong(x, label), chart.dot("best", x.at(5), y.at(2), 4, "5 s: 2%");
///     page["chart"] = chart.svg("plot", 1040, 380, "Error against time");
class Chart {
public:
  struct Area {
    double left, right, top, bottom;
  };
  enum class Across { units, percent }; ///< of x: the drawing's, or of its width as the page has it
  using Label = std::function<std::string(double)>;

  /// `area` is what the grid covers.
  explicit Chart(Area area, Across across = Across::units) : area_(area), across_(across) {}

  /// An upright line at each tick of `x` with its label below; a level one at each of `y` with its
  /// label on the left. Classes `grid` and `tick`.
  void gridAlong(const Axis& x, const Label& label);
  void gridUp(const Axis& y, const Label& label);

  void line(std::string_view style, double x1, double x2, double y1, double y2);
  void path(std::string_view style, const std::vector<std::pair<double, double>>& points);
  /// \param title what a pointer on it shows; empty: nothing
  void dot(std::string_view style, double x, double y, double radius, std::string_view title = "");
  void box(std::string_view style, double x, double y, double width, double height);
  /// \param anchor "start", "middle" or "end"; empty: as the sheet has it
  void text(std::string_view style, double x, double y, std::string_view anchor,
            std::string_view text);

  /// Without an `<svg>` around it.
  const std::string& marks() const { return marks_; }
  /// \param label what a screen reader says in place of the chart
  std::string svg(std::string_view style, double width, double height,
                  std::string_view label) const;
  /// With a title and a description for a screen reader. \param id unique in the page
  std::string svg(std::string_view style, double width, double height, std::string_view id,
                  std::string_view title, std::string_view description) const;

private:
  std::string acrossText(double x) const;

  Area area_;
  Across across_;
  std::string marks_;
};

} // namespace ggrade::report
