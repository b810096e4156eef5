#include "calibration/trade.hpp"

#include "gradebook/csv.hpp"
#include "report/chart.hpp"
#include "report/text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ggrade::calibration {

using gradebook::csvCell;
using nlohmann::json;
using report::number;

namespace {

json jsonOf(const Errors& errors) {
  return {{"right", errors.right},
          {"right_taken_for_wrong", errors.rightRejected},
          {"right_taken_for_wrong_at_most", upperBound(errors.rightRejected, errors.right)},
          {"wrong", errors.wrong},
          {"wrong_taken_for_right", errors.wrongAccepted},
          {"wrong_taken_for_right_at_most", upperBound(errors.wrongAccepted, errors.wrong)}};
}

std::string csvOf(const Errors& errors) {
  return fmt::format("{},{},{},{}", errors.right, errors.rightRejected, errors.wrong,
                     errors.wrongAccepted);
}

/// A score of a margin, or nothing where there is none.
std::string scoreText(double score, const std::string& none) {
  return std::isfinite(score) ? fmt::format("{:.1f}", score) : none;
}

std::string shareText(std::size_t found, std::size_t count) {
  if (count == 0) return "–";
  return fmt::format("{} of {} ({:.1f}%)", found, count, 100 * upperBound(found, count));
}

constexpr const char* kRightColumn = "right taken for wrong (at most)";
constexpr const char* kWrongColumn = "wrong taken for right (at most)";

Section tableOf(const Trade& trade, const std::string& sweep, const std::string& title,
                const std::string& text) {
  Section section{title, text, {}, {}, {}};
  section.columns = {sweep,          "seconds (middle half)", kRightColumn, kWrongColumn,
                     "lowest right", "highest wrong",         "margin"};
  for (const TradeRow& row : trade.rows) {
    if (row.sweep != sweep) continue;
    section.rows.push_back({row.name,
                            fmt::format("{:.2f} ({:.2f} to {:.2f})", row.seconds.median,
                                        row.seconds.q1, row.seconds.q3),
                            shareText(row.errors.rightRejected, row.errors.right),
                            shareText(row.errors.wrongAccepted, row.errors.wrong),
                            scoreText(row.lowestRight, "–"), scoreText(row.highestWrong, "–"),
                            scoreText(row.margin(), "–")});
  }
  return section;
}

Section measuresOf(const Trade& trade) {
  Section section;
  section.title = "Would one number for a picture do?";
  section.text = fmt::format(
      "The pictures of the balanced gradings, by what people compare pictures with: the worst one "
      "of the hidden scenes counts, against the reference's. A program of which a picture is "
      "missing counts as worse than all others. For each measure a threshold was chosen on one "
      "half of the catalogue (by a hash of the names; where the shares of both errors have the "
      "least sum) and its errors counted on the other half, and the other way round. The area "
      "under "
      "the ROC curve says how often a wrong answer looks worse than a right one: 1 always, 0.5 is "
      "guessing. PSNR orders pictures as RMSE does. Pixels that differ are those off by more than "
      "the tolerance; wrong pixels are those that the rubric calls so, which may move by a pixel; "
      "the densest window is where most of them are. Last the rubric: by the points that it takes "
      "away, with thresholds chosen like the others, and by the limits of this page, which nobody "
      "chose here. Milliseconds are processor time for a picture, the rubric's by the clock.{}",
      trade.leftOut.empty()
          ? std::string()
          : fmt::format(" Left out: right answers that may lose what is beyond the lecture, and "
                        "whose pictures differ for that ({}).",
                        fmt::join(trade.leftOut, ", ")));
  section.columns = {"measure", "thresholds", kRightColumn, kWrongColumn, "ROC area", "ms"};
  for (const MeasureRow& row : trade.measures)
    section.rows.push_back(
        {row.name,
         row.thresholds ? fmt::format("{:.3g}, {:.3g}", (*row.thresholds)[0], (*row.thresholds)[1])
                        : std::string("fixed"),
         shareText(row.errors.rightRejected, row.errors.right),
         shareText(row.errors.wrongAccepted, row.errors.wrong),
         row.area ? fmt::format("{:.4f}", *row.area) : std::string("–"),
         fmt::format("{:.2f}", row.ms)});
  return section;
}

/// How a sweep is drawn: its class in the sheet, and where its labels stand beside their dots.
struct Line {
  const char *sweep, *style;
  double x, y;
};

constexpr Line kLines[] = {
    {"quality", "one", 0, -12}, {"window size", "two", 0, 22}, {"hidden scenes", "three", -14, 22}};

} // namespace

std::string chartOf(const Trade& trade) {
  constexpr report::Chart::Area kArea{70, 1010, 24, 320};
  double slowest = 0, least = 0, most = 0;
  for (const TradeRow& row : trade.rows) {
    if (!std::isfinite(row.margin())) return {};
    slowest = std::max(slowest, row.seconds.median);
    least = std::min(least, row.margin());
    most = std::max(most, row.margin());
  }
  const auto label = [](double value) { return number(value); };
  const auto x = report::Axis::linear(0, slowest, kArea.left, kArea.right);
  const auto y = report::Axis::linear(least, most, kArea.bottom, kArea.top);
  report::Chart chart(kArea);
  chart.gridAlong(x, label);
  chart.gridUp(y, label);
  std::set<std::pair<double, double>> known;
  for (const Line& line : kLines) {
    std::vector<const TradeRow*> rows;
    std::vector<std::pair<double, double>> points;
    for (const TradeRow& row : trade.rows) {
      if (row.sweep != line.sweep) continue;
      rows.push_back(&row);
      points.emplace_back(x.at(row.seconds.median), y.at(row.margin()));
    }
    chart.path(line.style, points);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const TradeRow& row = *rows[i];
      const auto [u, v] = points[i];
      const bool errs = row.errors.rightRejected + row.errors.wrongAccepted > 0;
      chart.dot(std::string(line.style) + (errs ? " errs" : ""), u, v, 5,
                fmt::format("{}: {}, {} s, margin {}, {} right and {} wrong answers misjudged",
                            row.sweep, row.name, number(row.seconds.median),
                            number(row.margin(), 1), row.errors.rightRejected,
                            row.errors.wrongAccepted));
      // What stands in several sweeps has one name.
      const bool named = !known.insert(points[i]).second;
      chart.text("tick", u + line.x, v + line.y, line.x < 0 ? "end" : "middle",
                 named ? "" : row.name);
    }
  }
  double at = kArea.left + 10;
  for (const Line& line : kLines) {
    chart.dot(line.style, at, kArea.bottom + 42, 5);
    chart.text("", at + 12, kArea.bottom + 46, "", line.sweep);
    at += 130;
  }
  chart.text("tick", kArea.right, kArea.bottom + 46, "end", "seconds of a grading");
  chart.text("tick", 8, 14, "", "margin, points (rings: answers were misjudged)");
  return chart.svg("plot", 1040, 380,
                   trade.part + ", margin in points against seconds of a grading");
}

json toJson(const Trade& trade) {
  json rows = json::array(), measures = json::array();
  for (const TradeRow& row : trade.rows) {
    json one = jsonOf(row.errors);
    one["sweep"] = row.sweep;
    one["setting"] = row.name;
    one["seconds"] = {
        {"median", row.seconds.median}, {"q1", row.seconds.q1}, {"q3", row.seconds.q3}};
    if (std::isfinite(row.lowestRight)) one["lowest_right"] = row.lowestRight;
    if (std::isfinite(row.highestWrong)) one["highest_wrong"] = row.highestWrong;
    if (std::isfinite(row.margin())) one["margin"] = row.margin();
    one["failures"] = row.failures;
    rows.push_back(std::move(one));
  }
  for (const MeasureRow& row : trade.measures) {
    json one = jsonOf(row.errors);
    one["measure"] = row.name;
    if (row.thresholds) one["thresholds"] = *row.thresholds;
    if (row.area) one["roc_area"] = *row.area;
    one["ms"] = row.ms;
    measures.push_back(std::move(one));
  }
  return {{"part", trade.part}, {"seeds", trade.seeds}, {"hidden_scenes", trade.hiddenScenes},
          {"rows", rows},       {"measures", measures}, {"left_out_of_measures", trade.leftOut}};
}

std::string csvOf(const std::vector<Trade>& all) {
  std::string text = "part,sweep,setting,right,right_taken_for_wrong,wrong,wrong_taken_for_right,"
                     "seconds,seconds_q1,seconds_q3,lowest_right,highest_wrong,margin,roc_area,"
                     "ms_per_picture\n";
  for (const Trade& trade : all) {
    for (const TradeRow& row : trade.rows)
      text += fmt::format("{},{},{},{},{:.6g},{:.6g},{:.6g},{},{},{},,\n", csvCell(trade.part, ","),
                          csvCell(row.sweep, ","), csvCell(row.name, ","), csvOf(row.errors),
                          row.seconds.median, row.seconds.q1, row.seconds.q3,
                          scoreText(row.lowestRight, ""), scoreText(row.highestWrong, ""),
                          scoreText(row.margin(), ""));
    for (const MeasureRow& row : trade.measures)
      text += fmt::format("{},measure,{},{},,,,,,,{},{:.6g}\n", csvCell(trade.part, ","),
                          csvCell(row.name, ","), csvOf(row.errors),
                          row.area ? fmt::format("{:.6g}", *row.area) : std::string(), row.ms);
  }
  return text;
}

std::vector<Section> sectionsOf(const Trade& trade) {
  std::vector<Section> all = {
      tableOf(trade, "quality", "What does looking closer cost?",
              fmt::format(
                  "Mistakes, right answers and the files as handed out were graded with "
                  "seed {} and each of --quality. Seconds are those that rendering and judging one "
                  "submission took (median and middle half); building it and the report's pictures "
                  "come on top. A grading that the cache had kept has the time that it took then. "
                  "Errors are broken limits of the list above; in brackets what their share may be "
                  "at most (Wilson's 95% interval). The margin is the lowest score of a right "
                  "answer less the highest of a wrong one in what is required.",
                  fmt::join(trade.seeds, ", "))),
      tableOf(
          trade, "window size", "Would smaller windows do?",
          "The same with --quality balanced, and with the sides of the hidden scenes' windows "
          "multiplied. The public scene stays as it is, and so do quality numbers. What can't be "
          "judged at a size is misjudged."),
      tableOf(trade, "hidden scenes", "Would fewer hidden scenes do?",
              fmt::format("The same with --quality balanced, in the public scene and in the first "
                          "hidden ones alone. Their order is: {}. Points for what none of the "
                          "scenes shows are given.",
                          fmt::join(trade.hiddenScenes, "; "))),
      measuresOf(trade)};
  all[0].chart = chartOf(trade);
  return all;
}

std::string textOf(const Trade& trade) {
  std::string text = fmt::format("{}, seeds {}\n", trade.part, fmt::join(trade.seeds, ", "));
  for (const Section& section : sectionsOf(trade)) {
    std::vector<std::vector<std::string>> lines = {section.columns};
    lines.insert(lines.end(), section.rows.begin(), section.rows.end());
    std::vector<std::size_t> widths(section.columns.size());
    for (const auto& line : lines)
      for (std::size_t i = 0; i < line.size(); ++i)
        widths[i] = std::max(widths[i], report::displayWidth(line[i]));
    text += '\n' + section.title + '\n';
    for (const auto& line : lines) {
      for (std::size_t i = 0; i < line.size(); ++i) {
        const std::string gap(widths[i] - report::displayWidth(line[i]), ' ');
        text += i == 0 ? line[i] + gap : "  " + gap + line[i];
      }
      text += '\n';
    }
  }
  return text;
}

} // namespace ggrade::calibration
