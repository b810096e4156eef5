#include "calibration/plot.hpp"

#include "report/text.hpp"

#include <fmt/format.h>

namespace ggrade::calibration {

using report::escapeXml;
using report::number;

namespace {

// All in the SVG's own units; the page scales it to its width.
constexpr double kLeft = 190, kRight = 1010, kTop = 26, kBand = 46, kDot = 3.4;
constexpr double kWidth = 1040;

double xOf(double score) {
  return kLeft + (kRight - kLeft) * score / 100;
}

/// Dots of one score would hide each other: spread over the band, the same way every time.
double spreadOf(std::size_t index) {
  const double golden = 0.6180339887498949 * double(index + 1);
  return (golden - double(std::size_t(golden)) - 0.5) * (kBand - 16);
}

struct Band {
  Kind kind;
  const char* label;
  const char* state; ///< class that colours it
};

constexpr Band kBands[] = {
    {Kind::reference, "reference", "full"}, {Kind::variant, "right answers", "full"},
    {Kind::mistake, "mistakes", "none"},    {Kind::pair, "pairs of mistakes", "none"},
    {Kind::pictures, "no program", "none"}, {Kind::stub, "as handed out", "none"}};

std::string bound(double score, const std::string& label, double bottom, bool toTheLeft) {
  return fmt::format("<line class=\"bound\" x1=\"{0}\" x2=\"{0}\" y1=\"{1}\" y2=\"{2}\"/>"
                     "<text class=\"bound\" x=\"{3}\" y=\"{4}\" text-anchor=\"{5}\">{6}</text>",
                     xOf(score), kTop - 6, bottom, xOf(score) + (toTheLeft ? -4 : 4), kTop - 10,
                     toTheLeft ? "end" : "start", escapeXml(label));
}

} // namespace

std::string plotOf(const Verdicts& verdicts, const std::vector<Measured>& measured) {
  std::string bands, dots;
  double y = kTop;
  for (const Band& band : kBands) {
    std::size_t index = 0;
    std::string inBand;
    for (std::size_t i = 0; i < verdicts.rows.size(); ++i) {
      const Row& row = verdicts.rows[i];
      if (row.kind != band.kind) continue;
      for (const Score& score : measured.at(i).scores)
        inBand += fmt::format(
            "<circle class=\"{}{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" "
            "r=\"{}\"><title>{}</title></circle>",
            band.state, row.failures.empty() ? "" : " fails", xOf(score.score),
            y + kBand / 2 + spreadOf(index++), kDot,
            escapeXml(fmt::format("{}, seed {}: {}", row.name, score.seed, number(score.score))));
    }
    if (inBand.empty()) continue;
    bands += fmt::format("<rect class=\"band\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>"
                         "<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>",
                         kLeft - 8, y + 2, kRight - kLeft + 16, kBand - 4, kLeft - 18,
                         y + kBand / 2 + 5, band.label);
    dots += inBand;
    y += kBand;
  }
  std::string axis;
  for (int score = 0; score <= 100; score += 10)
    axis +=
        fmt::format("<line class=\"grid\" x1=\"{0}\" x2=\"{0}\" y1=\"{1}\" y2=\"{2}\"/>"
                    "<text class=\"tick\" x=\"{0}\" y=\"{3}\" text-anchor=\"middle\">{4}</text>",
                    xOf(score), kTop, y, y + 18, score);
  return fmt::format(
      "<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Scores of "
      "{} by kind of answer\">{}{}{}{}{}</svg>",
      kWidth, y + 28, escapeXml(verdicts.part), bands, axis,
      bound(100 - kRequiredCost, fmt::format("{} points lost", number(kRequiredCost)), y, true),
      bound(kRightScore, number(kRightScore), y, true), dots);
}

} // namespace ggrade::calibration
