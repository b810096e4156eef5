#include "report/class_parts.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vector>

namespace ggrade::report {
namespace {

// Pixels from the top. Across, all is in percent of the width, so that text keeps its size.
constexpr double kTop = 22, kBottom = 172, kLabels = 190;

// "40 to 50", "above 100".
std::string rangeText(std::size_t bin, double most) {
  const double width = most / double(kBins);
  if (bin >= kBins) return "above " + number(most);
  return fmt::format("{} to {}", number(double(bin) * width), number(double(bin + 1) * width));
}

std::string labelAt(double percent, const char* anchor, const std::string& label) {
  return fmt::format("<text class=\"tick\" x=\"{:.2f}%\" y=\"{}\" text-anchor=\"{}\">{}</text>",
                     percent, kLabels, anchor, label);
}

std::string drawing(const std::vector<std::size_t>& counts, double most) {
  const double width = 100.0 / double(counts.size());
  const double highest = double(std::max<std::size_t>(1, *std::ranges::max_element(counts)));
  std::string bars, ticks;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double left = double(i) * width;
    const double height = double(counts[i]) / highest * (kBottom - kTop);
    if (counts[i] > 0)
      bars += fmt::format("<rect x=\"{:.2f}%\" y=\"{:.1f}\" width=\"{:.2f}%\" height=\"{:.1f}\"/>"
                          "<text x=\"{:.2f}%\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>",
                          left + width * .06, kBottom - height, width * .88, height,
                          left + width / 2, kBottom - height - 6, counts[i]);
    if (i < kBins)
      ticks += labelAt(left, i == 0 ? "start" : "middle", number(double(i) * most / double(kBins)));
  }
  // The last label stands under its bin where it means the whole bin, not its left edge.
  ticks += counts.size() > kBins ? labelAt(100 - width / 2, "middle", "&gt;" + number(most))
                                 : labelAt(100, "end", number(most));
  return fmt::format("{}<line class=\"axis\" x1=\"0\" x2=\"100%\" y1=\"{}\" y2=\"{}\"/>{}", bars,
                     kBottom, kBottom, ticks);
}

} // namespace

void setHistogram(Data& data, std::span<const ClassRow> rows, const ScoreFigures& figures) {
  std::vector<std::size_t> counts(kBins);
  for (const ClassRow& row : rows) {
    const auto bin = hasScore(row) ? binOf(row.finalScore, figures.most) : std::nullopt;
    if (!bin) continue;
    counts.resize(std::max(counts.size(), *bin + 1));
    ++counts[*bin];
  }
  if (figures.count == 0 || figures.most <= 0) {
    data["histogram"] = Data(false);
    return;
  }
  Data histogram, bins = makeList();
  std::vector<std::string> words;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const std::string range = rangeText(i, figures.most);
    if (counts[i] > 0) words.push_back(fmt::format("{} from {}", counts[i], range));
    Data bin;
    bin["bin"] = Data(std::to_string(i));
    bin["range"] = Data(range);
    bin["count"] = Data(std::to_string(counts[i]));
    bins << bin;
  }
  histogram["alt"] =
      Data(fmt::format("How many students have which final score: {}.", fmt::join(words, ", ")));
  histogram["drawing"] = Data(drawing(counts, figures.most));
  histogram["bins"] = std::move(bins);
  data["histogram"] = std::move(histogram);
}

} // namespace ggrade::report
