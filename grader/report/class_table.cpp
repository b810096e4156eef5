#include "report/class_parts.hpp"

#include "report/page_parts.hpp"
#include "report/picture.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace ggrade::report {
namespace {

constexpr std::size_t kNameLength = 100, kShownRemarks = 5;

Item asItem(const ClassItem& item) {
  Item whole;
  whole.kind = item.kind, whole.points = item.points;
  whole.earned = item.earned, whole.judged = item.judged;
  return whole;
}

// What the script sorts a number by.
Data valueOf(double value) {
  return std::isfinite(value) ? Data(number(value, 6)) : Data(false);
}

std::string dataUri(const std::string& png) {
  if (png.empty()) return "";
  return "data:image/png;base64," +
         base64({reinterpret_cast<const unsigned char*>(png.data()), png.size()});
}

// "Shading: 10 instead of 3: drawn at half the size (teacher)".
std::string adjustmentText(const ClassRow& row, const Adjustment& adjustment) {
  const auto item = std::ranges::find(row.items, adjustment.item, &ClassItem::id);
  const bool hasTitle = item != row.items.end() && !item->title.empty();
  return fmt::format("{}: {} instead of {}: {} ({})",
                     adjustment.item.empty() ? "Total"
                     : hasTitle              ? item->title
                                             : adjustment.item,
                     number(adjustment.points), scoreText(adjustment.machine), adjustment.reason,
                     adjustment.who);
}

std::vector<std::string> shownRemarks(std::vector<std::string> remarks) {
  if (remarks.size() <= kShownRemarks) return remarks;
  const std::size_t more = remarks.size() - kShownRemarks;
  remarks.resize(kShownRemarks);
  remarks.push_back(fmt::format("and {} more", more));
  return remarks;
}

void setScores(Data& data, const ClassRow& row, const ScoreFigures& figures) {
  const bool isScored = row.outcome != Outcome::notGradable && std::isfinite(row.score);
  const double share = isScored && row.maxScore > 0 ? row.score / row.maxScore : 0;
  const auto bin = hasScore(row) ? binOf(row.finalScore, figures.most) : std::nullopt;
  data["hasScore"] = Data(isScored);
  data["score"] = Data(number(row.score));
  data["scoreValue"] = isScored ? valueOf(row.score) : Data(false);
  data["maxScore"] = Data(number(row.maxScore));
  data["bonus"] = row.bonus > 0 ? Data(number(row.bonus)) : Data(false);
  data["share"] = Data(number(std::clamp(share, 0.0, 1.0) * 100, 1));
  data["penalty"] = row.penalty > 0 ? Data(number(row.penalty)) : Data(false);
  data["final"] = Data(hasScore(row) ? number(row.finalScore) : "no score");
  data["finalValue"] = hasScore(row) ? valueOf(row.finalScore) : Data(false);
  data["bin"] = bin ? Data(std::to_string(*bin)) : Data(false);
}

void setAdjustments(Data& data, const ClassRow& row) {
  std::vector<std::string> lines;
  double sum = 0;
  for (const Adjustment& adjustment : row.adjustments) {
    lines.push_back(adjustmentText(row, adjustment));
    sum += adjustment.points - adjustment.machine;
  }
  data["isAdjusted"] = Data(!lines.empty());
  data["adjustments"] = linesOf(lines);
  data["adjustedValue"] = lines.empty() ? Data(false) : valueOf(sum);
}

// "2026-11-20T23:59+09:00" as two pieces between which a line may end.
void setSubmitted(Data& data, const ClassRow& row) {
  const std::string whole = sanitizeLine(row.submitted, 40);
  const bool isSplit = whole.size() > 10 && whole[10] == 'T';
  data["submitted"] = optional(whole);
  data["submittedDay"] = Data(isSplit ? whole.substr(0, 10) : whole);
  data["submittedTime"] = isSplit ? Data(whole.substr(11)) : Data(false);
}

Data rowOf(const ClassRow& row, const ScoreFigures& figures) {
  const std::string headline = sanitizeLine(row.headline), reason = sanitizeLine(row.reason);
  const std::string uri = dataUri(row.thumbnail);
  Data data;
  setStudent(data, row.folder, row.name.empty() ? row.student : row.name);
  setScores(data, row, figures);
  setAdjustments(data, row);
  data["student"] = row.student == row.name || row.name.empty()
                        ? Data(false)
                        : optional(sanitizeLine(row.student, kNameLength));
  data["state"] = Data(std::string(stateOf(summaryOf(row))));
  data["outcome"] = Data(std::string(name(row.outcome)));
  data["outcomeWords"] = Data(words(name(row.outcome)));
  data["thumbnail"] = optional(uri);
  data["headline"] = optional(headline);
  data["reason"] = reason == headline ? Data(false) : optional(reason);
  data["hasRemarks"] = Data(!row.remarks.empty());
  data["remarks"] = linesOf(shownRemarks(row.remarks));
  setSubmitted(data, row);
  data["seconds"] = std::isfinite(row.seconds) ? Data(number(row.seconds, 1)) : Data(false);
  return data;
}

} // namespace

std::string shownName(const std::string& name) {
  const std::string shown = sanitizeLine(name, kNameLength);
  return shown.empty() ? "(no name)" : shown;
}

std::string scoreText(double score) {
  return std::isfinite(score) ? number(score) : "no score";
}

Summary summaryOf(const ClassRow& row) {
  Summary summary;
  summary.outcome = row.outcome;
  summary.score = row.score;
  summary.perfect =
      scored(row.outcome) && !row.items.empty() &&
      std::ranges::all_of(row.items, [](const ClassItem& item) {
        return item.kind == ItemKind::bonus || standing(asItem(item)) == Standing::full;
      });
  return summary;
}

void setStudent(Data& data, const std::string& folder, const std::string& name) {
  data["name"] = Data(shownName(name));
  data["link"] = folder.empty() ? Data(false) : Data(encodePath(folder + "/index.html"));
  data["studentLink"] = folder.empty() ? Data(false) : Data(encodePath(folder + "/student.html"));
}

void setTable(Data& data, const ClassPage& page, const ScoreFigures& figures) {
  const auto any = [&](auto holds) { return Data(std::ranges::any_of(page.rows, holds)); };
  data["hasPictures"] = any([](const ClassRow& row) { return !row.thumbnail.empty(); });
  data["hasAdjustments"] = any([](const ClassRow& row) { return !row.adjustments.empty(); });
  data["hasPenalty"] = any([](const ClassRow& row) { return row.penalty > 0; });
  data["hasFinal"] = any([](const ClassRow& row) {
    return !row.adjustments.empty() || row.penalty > 0 || row.bonus > 0;
  });
  data["hasSubmitted"] = any([](const ClassRow& row) { return !row.submitted.empty(); });
  Data rows = makeList(), outcomes = makeList();
  for (const ClassRow& row : page.rows) rows << rowOf(row, figures);
  for (const ClassGroup& group : groupByOutcome(page.rows)) {
    Data outcome;
    outcome["outcome"] = Data(group.id);
    outcome["outcomeWords"] = Data(words(group.id));
    outcome["count"] = Data(std::to_string(group.rows.size()));
    outcomes << outcome;
  }
  data["rows"] = std::move(rows);
  data["outcomes"] = std::move(outcomes);
}

} // namespace ggrade::report
