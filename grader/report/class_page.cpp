#include "report/class_page.hpp"

#include "report/class_parts.hpp"
#include "report/page_parts.hpp"
#include "report/templates.hpp"
#include "report/text.hpp"

#include <cmath>
#include <fmt/format.h>

namespace ggrade::report {
namespace {

constexpr std::size_t kOpenRises = 10; // more are folded away: drops are what one must see

std::string counted(std::size_t count, const char* word) {
  return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

std::string widthOf(double share) {
  return number(share * 100, 1);
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

Data changeOf(const ScoreChange& change) {
  Data data;
  const double difference = change.after - change.before;
  setStudent(data, change.folder, change.name);
  data["before"] = Data(scoreText(change.before));
  data["after"] = Data(scoreText(change.after));
  data["difference"] = Data(!std::isfinite(difference) ? "–"
                            : difference < 0           ? "−" + number(-difference)
                                                       : "+" + number(difference));
  return data;
}

void setChanges(Data& data, const std::vector<ScoreChange>& changes) {
  Data drops = makeList(), rises = makeList();
  std::size_t dropCount = 0, riseCount = 0;
  for (const ScoreChange& change : changes) {
    const bool isRise = std::isnan(change.before) || change.after > change.before;
    (isRise ? rises : drops) << changeOf(change);
    ++(isRise ? riseCount : dropCount);
  }
  Data groups = makeList();
  const auto add = [&](std::size_t count, const char* verb, Data& list, bool open) {
    if (count == 0) return;
    Data group;
    group["changed"] = Data(counted(count, "score") + " " + verb);
    group["open"] = Data(open);
    group["changes"] = std::move(list);
    groups << group;
  };
  add(dropCount, "dropped", drops, true);
  add(riseCount, "rose", rises, riseCount <= kOpenRises);
  data["hasChanges"] = Data(!changes.empty());
  data["changeGroups"] = std::move(groups);
}

Data groupOf(const ClassGroup& group, std::span<const ClassRow> rows, const std::string& words,
             const std::string& sub) {
  Data data, students = makeList();
  for (const std::size_t i : group.rows) {
    Data student;
    setStudent(student, rows[i].folder, rows[i].name.empty() ? rows[i].student : rows[i].name);
    students << student;
  }
  const double share = double(group.rows.size()) / double(rows.size());
  data["words"] = Data(words);
  data["sub"] = optional(sub);
  data["count"] = Data(counted(group.rows.size(), "student"));
  data["share"] = Data(percent(share));
  data["width"] = Data(widthOf(share));
  data["students"] = std::move(students);
  return data;
}

// Mistakes and outcomes: lists of groups of students.
void setGroupings(Data& data, std::span<const ClassRow> rows) {
  Data groupings = makeList();
  const auto add = [&](const char* anchor, const char* heading, const char* column,
                       const char* note, Data groups) {
    if (!groups.is_non_empty_list()) return;
    Data grouping;
    grouping["anchor"] = Data(anchor);
    grouping["heading"] = Data(heading);
    grouping["column"] = Data(column);
    grouping["note"] = Data(note);
    grouping["groups"] = std::move(groups);
    groupings << grouping;
  };
  Data mistakes = makeList(), outcomes = makeList();
  for (const ClassGroup& group : groupByDiagnosis(rows))
    mistakes << (group.id.empty()
                     ? groupOf(group, rows, "Unknown: no known mistake explains what is wrong.", "")
                     : groupOf(group, rows, sanitizeLine(group.text, 800), sanitizeLine(group.id)));
  for (const ClassGroup& group : groupByOutcome(rows))
    outcomes << groupOf(group, rows, group.text, words(group.id));
  add("mistakes", "Most common mistakes", "Likeliest cause",
      "What the students were told. Shares are of all students; one can have several mistakes.",
      std::move(mistakes));
  add("outcomes", "Outcomes", "How it ended", "Shares are of all students.", std::move(outcomes));
  data["groupings"] = std::move(groupings);
}

Data itemOf(const ItemFigures& figures) {
  Data data;
  data["title"] = Data(sanitizeLine(figures.title.empty() ? figures.id : figures.title));
  data["id"] = figures.title.empty() ? Data(false) : line(figures.id);
  data["keep"] = Data(figures.kind == ItemKind::keep);
  data["wasJudged"] = Data(figures.judged > 0);
  data["share"] = Data(percent(figures.share));
  data["width"] = Data(widthOf(figures.share));
  data["lostCount"] = Data(std::to_string(figures.lost));
  data["judged"] = Data(std::to_string(figures.judged));
  return data;
}

void setItems(Data& data, std::span<const ClassRow> rows) {
  Data required = makeList(), bonus = makeList(), tables = makeList();
  for (const ItemFigures& figures : itemFigures(rows))
    (figures.kind == ItemKind::bonus ? bonus : required) << itemOf(figures);
  const auto add = [&](const char* heading, const char* shareHeading, const char* lostHeading,
                       Data items) {
    if (!items.is_non_empty_list()) return;
    Data table;
    table["heading"] = Data(heading);
    table["shareHeading"] = Data(shareHeading);
    table["lostHeading"] = Data(lostHeading);
    table["items"] = std::move(items);
    tables << table;
  };
  add("Required", "Mean share of points", "Lost points", std::move(required));
  add("Bonus", "Mean share of bonus", "Not the full bonus", std::move(bonus));
  data["hasItems"] = Data(tables.is_non_empty_list());
  data["itemTables"] = std::move(tables);
}

void setFacts(Data& data, const ClassPage& page) {
  Data facts = makeList();
  for (const auto& [key, value] : page.facts) {
    Data fact;
    fact["key"] = Data(sanitizeLine(key));
    fact["text"] = Data(sanitizeLine(value));
    facts << fact;
  }
  data["hasFacts"] = Data(!page.facts.empty());
  data["facts"] = std::move(facts);
}

} // namespace

std::string classPage(const ClassPage& page) {
  const ScoreFigures figures = scoreFigures(page.rows);
  std::vector<Summary> summaries;
  for (const ClassRow& row : page.rows) summaries.push_back(summaryOf(row));
  Data data;
  data["title"] = Data(shownName(page.title));
  data["intro"] = text(page.intro);
  data["tally"] = tallyOf(summaries);
  data["figures"] = optional(figuresText(page.rows.size(), figures));
  data["hasRemarks"] = Data(!page.remarks.empty());
  data["remarks"] = linesOf(page.remarks);
  data["hasRows"] = Data(!page.rows.empty());
  data["students"] = Data(counted(page.rows.size(), "student"));
  setChanges(data, page.changes);
  setHistogram(data, page.rows, figures);
  setGroupings(data, page.rows);
  setItems(data, page.rows);
  setTable(data, page, figures);
  setFacts(data, page);
  return renderPage(
      {templates::k_class_mustache, templates::k_class_js, templates::k_class_js_sha256,
       templates::k_class_css},
      std::move(data),
      fmt::format("{} · {}", shownName(page.title), counted(page.rows.size(), "student")));
}

} // namespace ggrade::report
