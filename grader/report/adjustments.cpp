#include "report/class_page.hpp"

#include "report/class_figures.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace ggrade::report {
namespace {

// In templates/result.mustache. Text from outside is escaped, so it can never hold these.
constexpr std::string_view kOpen = "<!--adjustments-->", kClose = "<!--/adjustments-->";

// "the grader gave 3 of 20, your instructor gave 10"
std::string scores(const Adjustment& adjustment, results::ItemKind kind, const std::string& machine,
                   const std::string& most) {
  if (kind == results::ItemKind::keep)
    return fmt::format("the grader took off {}{}, your instructor took off {}",
                       number(-adjustment.machine), most, number(-adjustment.points));
  return fmt::format("the grader gave {}{}, your instructor gave {}", machine, most,
                     number(adjustment.points));
}

} // namespace

std::string decisionText(const ClassRow& row, const Adjustment& adjustment) {
  const auto item = std::ranges::find(row.items, adjustment.item, &ClassItem::id);
  const std::string machine = number(adjustment.machine);
  std::string text;
  if (adjustment.item.empty()) {
    const bool ungraded = row.outcome == results::Outcome::notGradable;
    text = "Total: " + scores(adjustment, results::ItemKind::gain, ungraded ? "no score" : machine,
                              ungraded ? "" : " of " + number(row.maxScore));
  } else if (item == row.items.end()) {
    text = sanitizeLine(adjustment.item) + ": " +
           scores(adjustment, results::ItemKind::gain, machine, "");
  } else {
    text = sanitizeLine(item->title.empty() ? item->id : item->title) + ": " +
           scores(adjustment, item->kind, machine, " of " + number(item->points));
  }
  const std::string reason = sanitizeLine(adjustment.reason), who = sanitizeLine(adjustment.who);
  if (!reason.empty()) text += ": " + reason;
  if (!who.empty()) text += fmt::format(" ({})", who);
  return text;
}

namespace {

std::string section(const ClassRow& row, const std::string& lateRule) {
  std::string lines;
  for (const Adjustment& adjustment : row.adjustments)
    lines += fmt::format("<li>{}</li>\n", escapeXml(decisionText(row, adjustment)));
  if (row.penalty > 0) {
    const std::string rule = sanitizeLine(lateRule);
    lines += fmt::format("<li>Handed in late: {} point{} off{}</li>\n", number(row.penalty),
                         row.penalty == 1 ? "" : "s",
                         rule.empty() ? "" : fmt::format(" ({})", escapeXml(rule)));
  }
  if (lines.empty()) return "";
  const std::string score =
      hasScore(row)
          ? fmt::format("Final score: {} of {}", number(row.finalScore), number(row.maxScore))
          : "No final score: the submission could not be graded";
  return fmt::format("\n<section class=\"adjusted\" aria-label=\"Final score\">\n<p>{}</p>\n"
                     "<ul>\n{}</ul>\n</section>\n",
                     score, lines);
}

} // namespace

std::string withAdjustments(std::string page, const ClassRow& row, const std::string& lateRule) {
  const auto open = page.find(kOpen);
  if (open == std::string::npos) return page;
  const auto from = open + kOpen.size(), to = page.find(kClose, from);
  if (to == std::string::npos) return page;
  return page.replace(from, to - from, section(row, lateRule));
}

} // namespace ggrade::report
