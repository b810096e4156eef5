#include "batch/books.hpp"

#include "assignment/assignment.hpp"
#include "gradebook/cells.hpp"
#include "gradebook/entry.hpp"
#include "gradebook/look_alike.hpp"
#include "report/text.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace ggrade::batch {

namespace fs = std::filesystem;
using report::ClassRow;

namespace {

gradebook::MachineScore machineScore(const ClassRow& row) {
  gradebook::MachineScore machine;
  machine.student = row.student;
  if (row.outcome != results::Outcome::notGradable) machine.score = row.score + row.bonus;
  machine.most = row.maxScore;
  for (const report::ClassItem& item : row.items) {
    const bool keep = item.kind == results::ItemKind::keep;
    machine.items.push_back(
        {item.id, item.earned, keep ? -item.points : 0, keep ? 0 : item.points});
    if (item.kind == results::ItemKind::bonus) machine.most += item.points;
  }
  return machine;
}

std::string feedback(const Record& record, const std::string& lateRule) {
  std::string text;
  for (const report::Adjustment& one : record.row.adjustments)
    text += report::decisionText(record.row, one) + "\n";
  if (record.row.penalty > 0)
    text += fmt::format("Handed in late: {} points off. {}\n", report::number(record.row.penalty),
                        lateRule);
  return text + record.feedback;
}

std::vector<gradebook::Entry> entriesOf(const std::vector<Record>& records,
                                        const std::string& lateRule) {
  std::vector<gradebook::Entry> entries;
  for (const Record& record : records) {
    const ClassRow& row = record.row;
    gradebook::Entry entry;
    entry.student = row.student;
    entry.name = row.name;
    if (row.outcome != results::Outcome::notGradable || !row.adjustments.empty())
      entry.score = row.finalScore + row.penalty;
    entry.maxScore = row.maxScore;
    entry.penalty = row.penalty;
    entry.feedback = feedback(record, lateRule);
    entry.submitted = row.submitted;
    entry.given = row.given;
    entries.push_back(std::move(entry));
  }
  return entries;
}

/// Pages are written once, by who has the pictures; only what people decided is put in later.
void adjustPages(const fs::path& folder, const ClassRow& row, const std::string& lateRule) {
  for (const char* name : {"index.html", "student.html"}) {
    const std::string page = readFile(folder / name);
    const std::string adjusted = report::withAdjustments(page, row, lateRule);
    if (adjusted != page) report::writeFile(folder / name, adjusted);
  }
}

std::vector<std::pair<std::string, std::string>> factsOf(const std::vector<Record>& records) {
  const auto all = [&](const auto& of) {
    std::set<std::string> values;
    for (const Record& record : records) values.insert(of(record));
    std::string text;
    for (const std::string& value : values) text += (text.empty() ? "" : ", ") + value;
    return text;
  };
  return {{"graded", all([](const Record& record) { return record.target; })},
          {"seed", all([](const Record& record) { return std::to_string(record.seed); })},
          {"grader", all([](const Record& record) { return record.grader.substr(0, 12); })}};
}

void markLookAlikes(std::vector<Record>& records) {
  const auto quoted = [](const ClassRow& row) {
    return gradebook::visible(row.given.empty() ? row.student : row.given);
  };
  std::vector<std::string> students;
  for (const Record& record : records) students.push_back(record.row.student);
  const auto others = gradebook::lookAlikes(students);
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (others[i].empty()) continue;
    records[i].row.quoted = quoted(records[i].row);
    for (const std::size_t other : others[i])
      records[i].row.lookAlikes.push_back(quoted(records[other].row));
  }
}

/// By what the records say: each was graded where its sandbox was.
void setProtections(const std::vector<Record>& records, PageNotes& notes) {
  std::set<std::string> sandboxes;
  for (const Record& record : records)
    if (record.sandbox == "none")
      ++notes.unprotected;
    else
      sandboxes.insert(record.sandbox);
  if (sandboxes.empty()) return;
  notes.protections = sandbox::protections();
  notes.protections.insert(notes.protections.begin(),
                           {"sandbox", fmt::format("{}", fmt::join(sandboxes, ", "))});
  notes.protections.emplace_back("self-test",
                                 notes.selfTest.empty() ? "none in this run" : notes.selfTest);
}

} // namespace

Books::Books(BookOptions options, const fs::path& out) : options_(std::move(options)) {
  fs::path overrides = options_.overrides;
  if (overrides.empty() && fs::exists(out / "overrides.csv")) overrides = out / "overrides.csv";
  if (!overrides.empty()) {
    overridesFile_ = overrides.string();
    overrides_ = gradebook::readOverrides(readFile(overrides), overridesFile_);
  }
  const bool dated = !options_.submitted.empty();
  if (dated != !options_.due.empty() || dated != !options_.late.empty())
    throw UsageError("lateness needs all of --submitted FILE, --due TIME and --late RULE");
  if (dated) {
    rule_ = gradebook::readLateRule(options_.late);
    submissions_ =
        gradebook::readSubmitted(readFile(options_.submitted), options_.submitted.string(),
                                 gradebook::readDue(options_.due));
  }
  columns_ = gradebook::readColumns(options_.columns);
  for (const std::string& word : options_.gradebooks) {
    const std::size_t equals = word.find('=');
    const std::string kind = word.substr(0, equals);
    if (equals == word.npos || (kind != "moodle" && kind != "canvas"))
      throw UsageError(fmt::format("--gradebook {}: write moodle=FILE or canvas=FILE", word));
    const std::string file = word.substr(equals + 1);
    worksheets_.push_back({kind, file, readFile(file)});
    // Tried without a student: a column that is missing shows before the grading.
    if (kind == "moodle") gradebook::fillMoodle(worksheets_.back().bytes, file, {}, columns_);
    if (kind == "canvas" && !options_.canvasColumn.empty())
      gradebook::fillCanvas(worksheets_.back().bytes, file, {}, options_.canvasColumn);
  }
}

void Books::adjust(std::vector<Record>& records, PageNotes& notes) const {
  std::vector<gradebook::MachineScore> machine;
  for (const Record& record : records) machine.push_back(machineScore(record.row));
  const gradebook::Overrides applied =
      gradebook::applyOverrides(machine, overrides_, overridesFile_);
  notes.remarks.insert(notes.remarks.end(), applied.remarks.begin(), applied.remarks.end());
  std::size_t dated = 0;
  for (std::size_t i = 0; i < records.size(); ++i) {
    ClassRow& row = records[i].row;
    const gradebook::Overridden& one = applied.scores[i];
    bool isTotal = false;
    for (const gradebook::Change& change : one.changes) {
      row.adjustments.push_back({change.item, change.machine.value_or(0), change.points,
                                 report::sanitizeLine(change.reason),
                                 report::sanitizeLine(change.who), change.beyond});
      isTotal |= change.item.empty();
    }
    row.finalScore = one.score.value_or(0);
    if (!rule_) continue;
    const auto found = std::ranges::find(submissions_, gradebook::plainIdentifier(row.student),
                                         [](const gradebook::Submission& submission) {
                                           return gradebook::plainIdentifier(submission.student);
                                         });
    if (found == submissions_.end()) continue;
    ++dated;
    row.submitted = found->submitted;
    // A total that a person has given is the last word.
    if (isTotal || !one.score) continue;
    row.penalty = gradebook::penalty(*rule_, row.finalScore, row.maxScore, found->secondsLate);
    row.finalScore -= row.penalty;
  }
  if (rule_ && dated < records.size())
    notes.remarks.push_back(fmt::format("{} of {} submissions have no time in {}: they count as in "
                                        "time",
                                        records.size() - dated, records.size(),
                                        options_.submitted.string()));
}

std::vector<ClassRow> Books::write(const fs::path& out, PageNotes& notes) const {
  std::vector<std::string> damaged;
  std::vector<Record> records = loadRecords(out, &damaged);
  for (const std::string& name : damaged)
    notes.missing.push_back(
        fmt::format("{} is missing here: its record in {} can't be read; --resume grades it again",
                    report::sanitizeLine(name, 80), (out / name).string()));
  notes.remarks.insert(notes.remarks.end(), notes.missing.begin(), notes.missing.end());
  adjust(records, notes);
  markLookAlikes(records);
  setProtections(records, notes);
  std::ranges::stable_sort(records, {}, [](const Record& record) { return record.row.name; });
  const std::string lateRule = rule_ ? gradebook::describe(*rule_) : std::string();
  for (const Record& record : records) {
    adjustPages(out / record.row.folder, record.row, lateRule);
    if (record.isAdjusted || !record.row.adjustments.empty())
      saveRecord(out / record.row.folder, record);
  }

  const std::vector<gradebook::Entry> entries = entriesOf(records, lateRule);
  const std::string id = records.empty() ? std::string() : records[0].target;
  report::writeFile(out / "gradebook.csv", gradebook::neutralCsv(id, options_.due, entries));
  for (const Worksheet& sheet : worksheets_) {
    const gradebook::Filled filled =
        sheet.kind == "moodle"
            ? gradebook::fillMoodle(sheet.bytes, sheet.file, entries, columns_)
            : gradebook::fillCanvas(sheet.bytes, sheet.file, entries,
                                    options_.canvasColumn.empty() ? notes.title
                                                                  : options_.canvasColumn);
    report::writeFile(out / (sheet.kind + ".csv"), filled.bytes);
    notes.remarks.insert(notes.remarks.end(), filled.remarks.begin(), filled.remarks.end());
  }

  report::ClassPage page;
  page.title = notes.title;
  page.intro = notes.intro;
  page.changes = notes.changes;
  page.refused = notes.refused;
  page.protections = notes.protections;
  page.selfTested = !notes.selfTest.empty();
  page.unprotected = notes.unprotected;
  page.remarks = notes.remarks;
  page.facts = factsOf(records);
  page.facts.insert(page.facts.end(), notes.facts.begin(), notes.facts.end());
  if (rule_) page.facts.emplace_back("lateness", lateRule);
  for (Record& record : records) page.rows.push_back(std::move(record.row));
  report::writeFile(out / "index.html", report::classPage(page));
  for (ClassRow& row : page.rows) row.thumbnail.clear();
  return std::move(page.rows);
}

} // namespace ggrade::batch
