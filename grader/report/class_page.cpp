#include "report/class_page.hpp"

#include "report/attention.hpp"
#include "report/chart.hpp"
#include "report/class_figures.hpp"
#include "report/page.hpp"
#include "report/picture.hpp"
#include "report/templates.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ggrade::report {

using nlohmann::json;

namespace {

constexpr std::size_t kOpenRises = 10; // more are folded away: drops are what one must see
constexpr std::size_t kNameLength = 100, kShownRemarks = 5, kRefusedLength = 120;
constexpr std::size_t kOpenLines = 12; // of what was refused; more are folded away

std::string counted(std::size_t count, const char* word) {
  return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

std::string widthOf(double share) {
  return number(share * 100, 1);
}

// A name as the page shows it, short enough for a cell; never empty.
std::string shownName(const std::string& name) {
  const std::string shown = sanitizeLine(name, kNameLength);
  return shown.empty() ? "(no name)" : shown;
}

// "61.5", or "no score" for what is no number.
std::string scoreText(double score) {
  return std::isfinite(score) ? number(score) : "no score";
}

results::Item asItem(const ClassItem& item) {
  results::Item whole;
  whole.kind = item.kind, whole.points = item.points;
  whole.earned = item.earned, whole.judged = item.judged;
  return whole;
}

// What the overview's words and colours are made of; without picture and link.
Summary summaryOf(const ClassRow& row) {
  Summary summary;
  summary.outcome = row.outcome;
  summary.score = row.score;
  summary.perfect =
      scored(row.outcome) && !row.items.empty() &&
      std::ranges::all_of(row.items, [](const ClassItem& item) {
        return item.kind == results::ItemKind::bonus || standing(asItem(item)) == Standing::full;
      });
  return summary;
}

// The name and the links to the pages, which no folder means none of.
json studentOf(const std::string& folder, const std::string& name) {
  const bool linked = !folder.empty();
  return {{"name", shownName(name)},
          {"link", linked ? encodePath(folder + "/index.html") : ""},
          {"studentLink", linked ? encodePath(folder + "/student.html") : ""}};
}

// "Final scores of 198 students, out of 100: mean 61.2, median 65, quartiles 40 and 85."
std::string figuresText(std::size_t students, const ScoreFigures& figures) {
  const std::size_t without = students - figures.count;
  std::string text;
  if (figures.count > 0)
    text = fmt::format("Final scores of {}, out of {}: mean {}, median {}, quartiles {} and {}.",
                       counted(figures.count, "student"), number(figures.most),
                       number(figures.mean, 1), number(figures.median, 1),
                       number(figures.lowerQuartile, 1), number(figures.upperQuartile, 1));
  if (without > 0)
    text += fmt::format(
        "{}{} not gradable and {} no score: left out of these figures.", text.empty() ? "" : " ",
        without == 1 ? "1 submission is" : fmt::format("{} submissions are", without),
        without == 1 ? "has" : "have");
  return text;
}

json changeOf(const ScoreChange& change) {
  const double difference = change.after - change.before;
  json data = studentOf(change.folder, change.name);
  data["before"] = scoreText(change.before);
  data["after"] = scoreText(change.after);
  data["difference"] = !std::isfinite(difference) ? "–"
                       : difference < 0           ? "−" + number(-difference)
                                                  : "+" + number(difference);
  return data;
}

json changeGroupsOf(const std::vector<ScoreChange>& changes) {
  json drops = json::array(), rises = json::array(), groups = json::array();
  for (const ScoreChange& change : changes) {
    const bool isRise = std::isnan(change.before) || change.after > change.before;
    (isRise ? rises : drops).push_back(changeOf(change));
  }
  const auto add = [&](const json& list, const char* verb, bool open) {
    if (!list.empty())
      groups.push_back({{"changed", counted(list.size(), "score") + " " + verb},
                        {"open", open},
                        {"changes", list}});
  };
  add(drops, "dropped", true);
  add(rises, "rose", rises.size() <= kOpenRises);
  return groups;
}

// The histogram of final scores.

// Pixels from the top. Across, all is in percent of the width, so that text keeps its size.
constexpr double kTop = 22, kBottom = 172, kLabels = 190;

// "40 to 50", "above 100".
std::string rangeText(std::size_t bin, double most) {
  const double width = most / double(kBins);
  if (bin >= kBins) return "above " + number(most);
  return fmt::format("{} to {}", number(double(bin) * width), number(double(bin + 1) * width));
}

std::string drawing(const std::vector<std::size_t>& counts, double most) {
  const double width = 100.0 / double(counts.size());
  const double highest = double(std::max<std::size_t>(1, *std::ranges::max_element(counts)));
  Chart chart({0, 100, kTop, kBottom}, Chart::Across::percent);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    const double left = double(i) * width;
    const double height = double(counts[i]) / highest * (kBottom - kTop);
    chart.box("", left + width * .06, kBottom - height, width * .88, height);
    chart.text("", left + width / 2, kBottom - height - 6, "middle", std::to_string(counts[i]));
  }
  chart.line("axis", 0, 100, kBottom, kBottom);
  for (std::size_t i = 0; i < kBins; ++i)
    chart.text("tick", double(i) * width, kLabels, i == 0 ? "start" : "middle",
               number(double(i) * most / double(kBins)));
  // The last label stands under its bin where it means the whole bin, not its left edge.
  if (counts.size() > kBins)
    chart.text("tick", 100 - width / 2, kLabels, "middle", ">" + number(most));
  else
    chart.text("tick", 100, kLabels, "end", number(most));
  return chart.marks();
}

// False without a score.
json histogramOf(std::span<const ClassRow> rows, const ScoreFigures& figures) {
  if (figures.count == 0 || figures.most <= 0) return false;
  std::vector<std::size_t> counts(kBins);
  for (const ClassRow& row : rows) {
    const auto bin = hasScore(row) ? binOf(row.finalScore, figures.most) : std::nullopt;
    if (!bin) continue;
    counts.resize(std::max(counts.size(), *bin + 1));
    ++counts[*bin];
  }
  json bins = json::array();
  std::vector<std::string> words;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const std::string range = rangeText(i, figures.most);
    if (counts[i] > 0) words.push_back(fmt::format("{} from {}", counts[i], range));
    bins.push_back({{"bin", i}, {"range", range}, {"count", counts[i]}});
  }
  return {
      {"alt", fmt::format("How many students have which final score: {}.", fmt::join(words, ", "))},
      {"drawing", drawing(counts, figures.most)},
      {"bins", std::move(bins)}};
}

// Mistakes, outcomes and items.

json groupOf(const ClassGroup& group, std::span<const ClassRow> rows, const std::string& words,
             const std::string& sub) {
  json students = json::array();
  for (const std::size_t i : group.rows)
    students.push_back(
        studentOf(rows[i].folder, rows[i].name.empty() ? rows[i].student : rows[i].name));
  const double share = double(group.rows.size()) / double(rows.size());
  return {{"words", words},
          {"sub", sub},
          {"count", counted(group.rows.size(), "student")},
          {"share", percent(share)},
          {"width", widthOf(share)},
          {"students", std::move(students)}};
}

// Lists of groups of students.
json groupingsOf(std::span<const ClassRow> rows) {
  json groupings = json::array(), mistakes = json::array(), outcomes = json::array();
  const auto add = [&](const char* anchor, const char* heading, const char* column,
                       const char* note, const json& groups) {
    if (!groups.empty())
      groupings.push_back({{"anchor", anchor},
                           {"heading", heading},
                           {"column", column},
                           {"note", note},
                           {"groups", groups}});
  };
  for (const ClassGroup& group : groupByDiagnosis(rows))
    mistakes.push_back(
        group.id.empty()
            ? groupOf(group, rows, "Unknown: no known mistake explains what is wrong.", "")
            : groupOf(group, rows, sanitizeLine(group.text, 800), sanitizeLine(group.id)));
  for (const ClassGroup& group : groupByOutcome(rows))
    outcomes.push_back(groupOf(group, rows, group.text, spaced(group.id)));
  add("mistakes", "Most common mistakes", "Likeliest cause",
      "What the students were told. Shares are of all students; one can have several mistakes.",
      mistakes);
  add("outcomes", "Outcomes", "How it ended", "Shares are of all students.", outcomes);
  return groupings;
}

json itemOf(const ItemFigures& figures) {
  return {{"title", sanitizeLine(figures.title.empty() ? figures.id : figures.title)},
          {"id", figures.title.empty() ? "" : sanitizeLine(figures.id)},
          {"keep", figures.kind == results::ItemKind::keep},
          {"wasJudged", figures.judged > 0},
          {"share", percent(figures.share)},
          {"width", widthOf(figures.share)},
          {"lostCount", figures.lost},
          {"judged", figures.judged}};
}

json itemTablesOf(std::span<const ClassRow> rows) {
  json required = json::array(), bonus = json::array(), tables = json::array();
  for (const ItemFigures& figures : itemFigures(rows))
    (figures.kind == results::ItemKind::bonus ? bonus : required).push_back(itemOf(figures));
  const auto add = [&](const char* heading, const char* shareHeading, const char* lostHeading,
                       const json& items) {
    if (!items.empty())
      tables.push_back({{"heading", heading},
                        {"shareHeading", shareHeading},
                        {"lostHeading", lostHeading},
                        {"items", items}});
  };
  add("Required", "Mean share of points", "Lost points", required);
  add("Bonus", "Mean share of bonus", "Not the full bonus", bonus);
  return tables;
}

// The table of all students.

// What the script sorts a number by.
std::string valueOf(double value) {
  return std::isfinite(value) ? number(value, 6) : "";
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

void setScores(json& data, const ClassRow& row, const ScoreFigures& figures) {
  const bool isScored = row.outcome != results::Outcome::notGradable && std::isfinite(row.score);
  const double share = isScored && row.maxScore > 0 ? row.score / row.maxScore : 0;
  const auto bin = hasScore(row) ? binOf(row.finalScore, figures.most) : std::nullopt;
  data["hasScore"] = isScored;
  data["score"] = row.score;
  data["scoreValue"] = isScored ? valueOf(row.score) : "";
  data["maxScore"] = row.maxScore;
  data["bonus"] = row.bonus > 0 ? number(row.bonus) : "";
  data["share"] = number(std::clamp(share, 0.0, 1.0) * 100, 1);
  data["penalty"] = row.penalty > 0 ? number(row.penalty) : "";
  data["final"] = hasScore(row) ? number(row.finalScore) : "no score";
  data["finalValue"] = hasScore(row) ? valueOf(row.finalScore) : "";
  data["bin"] = bin ? json(*bin) : json(false);
}

void setAdjustments(json& data, const ClassRow& row) {
  json lines = json::array();
  double sum = 0;
  for (const Adjustment& adjustment : row.adjustments) {
    lines.push_back({{"text", sanitizeLine(adjustmentText(row, adjustment))},
                     {"beyond", sanitizeLine(adjustment.beyond)}});
    sum += adjustment.points - adjustment.machine;
  }
  data["isAdjusted"] = !lines.empty();
  data["adjustedValue"] = lines.empty() ? "" : valueOf(sum);
  data["adjustments"] = std::move(lines);
}

// "2026-11-20T23:59+09:00" as two pieces between which a line may end.
void setSubmitted(json& data, const ClassRow& row) {
  const std::string whole = sanitizeLine(row.submitted, 40);
  const bool isSplit = whole.size() > 10 && whole[10] == 'T';
  data["submitted"] = whole;
  data["submittedDay"] = isSplit ? whole.substr(0, 10) : whole;
  data["submittedTime"] = isSplit ? whole.substr(11) : "";
}

json rowOf(const ClassRow& row, const ScoreFigures& figures) {
  const std::string headline = sanitizeLine(row.headline), reason = sanitizeLine(row.reason);
  const bool named = row.student != row.name && !row.name.empty();
  json data = studentOf(row.folder, row.name.empty() ? row.student : row.name);
  setScores(data, row, figures);
  setAdjustments(data, row);
  setSubmitted(data, row);
  data["student"] = named ? sanitizeLine(row.student, kNameLength) : "";
  data["state"] = stateOf(summaryOf(row));
  data["outcome"] = name(row.outcome);
  data["outcomeWords"] = spaced(name(row.outcome));
  data["thumbnail"] = dataUri(row.thumbnail);
  data["headline"] = headline;
  data["reason"] = reason == headline ? "" : reason;
  data["quoted"] = sanitizeLine(row.quoted, kNameLength);
  data["alike"] = row.lookAlikes.empty()
                      ? ""
                      : "looks like " + (row.lookAlikes.size() == 1
                                             ? "another"
                                             : std::to_string(row.lookAlikes.size()) + " others");
  data["hasRemarks"] = !row.remarks.empty();
  data["remarks"] = linesOf(shownRemarks(row.remarks));
  data["seconds"] = std::isfinite(row.seconds) ? number(row.seconds, 1) : "";
  return data;
}

// The columns that only some classes have, and the rows.
void setTable(json& data, const ClassPage& page, const ScoreFigures& figures) {
  const auto any = [&](auto holds) { return std::ranges::any_of(page.rows, holds); };
  data["hasPictures"] = any([](const ClassRow& row) { return !row.thumbnail.empty(); });
  data["hasAdjustments"] = any([](const ClassRow& row) { return !row.adjustments.empty(); });
  data["hasPenalty"] = any([](const ClassRow& row) { return row.penalty > 0; });
  data["hasFinal"] = any([](const ClassRow& row) {
    return !row.adjustments.empty() || row.penalty > 0 || row.bonus > 0;
  });
  data["hasSubmitted"] = any([](const ClassRow& row) { return !row.submitted.empty(); });
  json &rows = data["rows"] = json::array(), &outcomes = data["outcomes"] = json::array();
  for (const ClassRow& row : page.rows) {
    rows.push_back(rowOf(row, figures));
    rows.back()["place"] = rows.size();
  }
  for (const ClassGroup& group : groupByOutcome(page.rows))
    outcomes.push_back(
        {{"outcome", group.id}, {"outcomeWords", spaced(group.id)}, {"count", group.rows.size()}});
}

// The first lines: who needs a person, what was refused, what kept programs from the machine.

// As the row is to be told from others.
std::string whoIs(const ClassRow& row) {
  return shownName(!row.quoted.empty() ? row.quoted : row.name.empty() ? row.student : row.name);
}

json needsOf(std::span<const ClassRow> rows) {
  json needs = json::array();
  for (const Attention& one : needingAPerson(rows))
    needs.push_back({{"place", one.row + 1},
                     {"name", whoIs(rows[one.row])},
                     {"reasons", linesOf(one.reasons)}});
  return needs;
}

json refusedOf(const ClassPage& page) {
  json lines = linesOf(page.refused);
  for (const ClassRow& row : page.rows)
    for (const std::string& line : shownRemarks(row.refused))
      lines.push_back(whoIs(row) + ": " + sanitizeLine(line, kRefusedLength));
  return lines;
}

std::size_t refusedCount(const ClassPage& page) {
  std::size_t count = page.refused.size();
  for (const ClassRow& row : page.rows) count += row.refused.size();
  return count;
}

void setFirstLines(json& data, const ClassPage& page) {
  json needs = needsOf(page.rows), refused = refusedOf(page), protections = json::array();
  for (const auto& [key, value] : page.protections)
    protections.push_back({{"key", sanitizeLine(key)}, {"text", sanitizeLine(value)}});
  data["needing"] = needs.empty() ? "Nobody needs a person"
                                  : fmt::format("{} of {} need{} a person", needs.size(),
                                                counted(page.rows.size(), "student"),
                                                needs.size() == 1 ? "s" : "");
  data["hasNeeds"] = !needs.empty();
  data["hasAlike"] =
      std::ranges::any_of(page.rows, [](const ClassRow& row) { return !row.lookAlikes.empty(); });
  data["needs"] = std::move(needs);
  data["refusedCount"] = refused.empty() ? "Nothing was refused"
                         : refusedCount(page) == 1
                             ? "1 file or upload refused"
                             : fmt::format("{} files or uploads refused", refusedCount(page));
  data["hasRefused"] = !refused.empty();
  data["refusedOpen"] = refused.size() <= kOpenLines;
  data["refused"] = std::move(refused);
  data["protectedBy"] = page.protections.empty() ? "" : sanitizeLine(page.protections[0].second);
  data["protections"] = std::move(protections);
  data["tested"] = page.selfTested ? "self-test passed" : "no self-test in this run";
  data["unprotected"] =
      page.unprotected == 0
          ? ""
          : fmt::format("No sandbox: {} ran as the user who graded, with that user's files and "
                        "network (--sandbox none).",
                        page.unprotected == page.rows.size()
                            ? "every program"
                            : fmt::format("the programs of {} of {}", page.unprotected,
                                          counted(page.rows.size(), "student")));
}

} // namespace

std::string classPage(const ClassPage& page) {
  const ScoreFigures figures = scoreFigures(page.rows);
  const std::string students = counted(page.rows.size(), "student");
  std::vector<Summary> summaries;
  for (const ClassRow& row : page.rows) summaries.push_back(summaryOf(row));
  json facts = json::array(), tables = itemTablesOf(page.rows);
  for (const auto& [key, value] : page.facts)
    facts.push_back({{"key", sanitizeLine(key)}, {"text", sanitizeLine(value)}});
  json data = {{"title", shownName(page.title)},
               {"intro", page.intro},
               {"tally", tallyOf(summaries)},
               {"figures", figuresText(page.rows.size(), figures)},
               {"hasRemarks", !page.remarks.empty()},
               {"remarks", linesOf(page.remarks)},
               {"hasRows", !page.rows.empty()},
               {"students", students},
               {"hasChanges", !page.changes.empty()},
               {"changeGroups", changeGroupsOf(page.changes)},
               {"histogram", histogramOf(page.rows, figures)},
               {"groupings", groupingsOf(page.rows)},
               {"hasItems", !tables.empty()},
               {"itemTables", std::move(tables)},
               {"hasFacts", !page.facts.empty()},
               {"facts", std::move(facts)}};
  setTable(data, page, figures);
  setFirstLines(data, page);
  return renderPage({templates::k_class_mustache, templates::k_class_js,
                     templates::k_class_js_sha256, templates::k_class_css},
                    std::move(data), fmt::format("{} · {}", shownName(page.title), students));
}

} // namespace ggrade::report
