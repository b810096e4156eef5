#include "gradebook/worksheet_parts.hpp"

#include "assignment/usage_error.hpp"
#include "gradebook/cells.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ggrade::gradebook {
namespace {

using Names = std::vector<std::string>;

// In lower case, as in Moodle's language packs (mod_assign, assignfeedback_comments) of English and
// of Japanese, whose words have changed: 評定 and 評点 are both "grade".
const Names kIdentifier = {"identifier", "識別子", "id"};
const Names kGrade = {"grade", "評定", "評点", "成績"};
const Names kMax = {"maximum grade", "最大評点", "最大評定", "最高評点"};
const Names kFeedback = {"feedback comments", "フィードバックコメント"};
const Names kChangeable = {"grade can be changed", "評点変更可", "評定変更可"};
const Names kScale = {"scale", "評価尺度"};
// Moodle's Japanese pack has kept "No".
const Names kNo = {"no", "いいえ", "不可"};

struct MoodleColumns {
  std::size_t identifier, grade, feedback, max, changeable; // kNoColumn: there is no such column
};

bool isIn(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// A column by the header that the caller has named, else by the known ones.
std::size_t place(const Csv& csv, const std::string& fileName, const std::string& role,
                  const std::string& named, const Names& known) {
  const Names wanted = named.empty() ? known : Names{foldedHeader(named)};
  std::size_t found = kNoColumn;
  for (std::size_t column = 0; column < csv.columns(0); ++column) {
    if (!isIn(wanted, foldedHeader(csv.cell(0, column)))) continue;
    if (found != kNoColumn)
      throw UsageError(fmt::format("{}: both \"{}\" and \"{}\" could be the column {}: name one "
                                   "with --columns {}=HEADER, or "
                                   "rename the other",
                                   fileName, report::sanitizeLine(csv.cell(0, found)),
                                   report::sanitizeLine(csv.cell(0, column)), role, role));
    found = column;
  }
  if (found == kNoColumn && !named.empty())
    throw UsageError(fmt::format("{}: --columns {}={}: there is no such column; there are {}",
                                 fileName, role, named, headers(csv, 0)));
  return found;
}

std::size_t needed(const Csv& csv, const std::string& fileName, const std::string& role,
                   const std::string& named, const Names& known) {
  const std::size_t found = place(csv, fileName, role, named, known);
  if (found == kNoColumn)
    throw UsageError(fmt::format("{}: no column is called {}: name it with --columns {}=HEADER; "
                                 "there are {}",
                                 fileName, fmt::join(known, ", "), role, headers(csv, 0)));
  return found;
}

MoodleColumns places(const Csv& csv, const std::string& fileName, const Columns& columns) {
  if (csv.rows() == 0)
    throw UsageError(fileName + ": the worksheet is empty: export it from Moodle again");
  if (columns.max.empty() && place(csv, fileName, "scale", "", kScale) != kNoColumn)
    throw UsageError(fileName + ": the assignment is graded on a scale of words: let Moodle grade "
                                "it with points, and export the worksheet again");
  return {needed(csv, fileName, "identifier", columns.identifier, kIdentifier),
          needed(csv, fileName, "grade", columns.grade, kGrade),
          place(csv, fileName, "feedback", columns.feedback, kFeedback),
          needed(csv, fileName, "max", columns.max, kMax),
          place(csv, fileName, "changeable", "", kChangeable)};
}

std::vector<StudentRow> studentRows(const Csv& csv, const MoodleColumns& at,
                                    std::vector<std::string>& remarks) {
  std::vector<StudentRow> rows;
  for (std::size_t row = 1; row < csv.rows(); ++row) {
    if (csv.isBlank(row)) continue;
    const std::size_t cells = csv.columns(row);
    const std::size_t feedback = at.feedback == kNoColumn ? 0 : at.feedback;
    if (cells <= std::max({at.identifier, at.grade, at.max, feedback})) {
      remarks.push_back(fmt::format("line {}: only {} of {} cells, left as it is", csv.line(row),
                                    cells, csv.columns(0)));
      continue;
    }
    const std::string identifier = csv.cell(row, at.identifier);
    if (plainIdentifier(identifier).empty())
      remarks.push_back(fmt::format("line {}: no identifier, left as it is", csv.line(row)));
    else
      rows.push_back({row, shownRow(csv, row, identifier), {plainIdentifier(identifier)}});
  }
  return rows;
}

bool isLocked(const Csv& csv, std::size_t row, const MoodleColumns& at) {
  return at.changeable < csv.columns(row) && isIn(kNo, foldedHeader(csv.cell(row, at.changeable)));
}

void fillRow(Csv& csv, const StudentRow& row, const Entry& entry, const MoodleColumns& at,
             std::vector<std::string>& remarks) {
  const auto left = [&](const std::string& why) {
    remarks.push_back(fmt::format("{}: {}, left as it is", row.shown, why));
  };
  if (!entry.score) return left("not gradable");
  if (isLocked(csv, row.row, at)) return left("the grade can't be changed");
  const std::string cell = csv.cell(row.row, at.max);
  const auto max = readMarkedNumber(cell, defaultMark(csv));
  if (!max || max->value <= 0)
    return left(
        fmt::format("the maximum grade is \"{}\", no number above 0", report::sanitizeLine(cell)));

  const double share = *finalScore(entry) / entry.maxScore;
  if (share > 1)
    remarks.push_back(fmt::format("{}: {} of {} points are written as the maximum", row.shown,
                                  writeNumber(*finalScore(entry)), writeNumber(entry.maxScore)));
  writeGrade(csv, row, at.grade, std::min(share, 1.0) * max->value, *max, remarks);
  if (entry.feedback.empty() || at.feedback == kNoColumn) return;
  const std::string feedback = feedbackCell(entry.feedback);
  const std::string before = csv.cell(row.row, at.feedback);
  if (!trimmed(before).empty() && before != feedback)
    remarks.push_back(row.shown + ": the feedback that was there is replaced");
  csv.set(row.row, at.feedback, feedback);
}

} // namespace

Columns readColumns(std::string_view text) {
  Columns columns;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::string_view one = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(one.size() + 1, rest.size()));
    const std::size_t equals = one.find('=');
    const std::string_view role = trimmed(one.substr(0, equals));
    const std::string_view header = equals == one.npos ? "" : trimmed(one.substr(equals + 1));
    std::string* column = role == "identifier" ? &columns.identifier
                          : role == "grade"    ? &columns.grade
                          : role == "feedback" ? &columns.feedback
                          : role == "max"      ? &columns.max
                                               : nullptr;
    if (!column || header.empty() || !column->empty())
      throw UsageError(fmt::format("--columns {}: \"{}\" is none of identifier=HEADER, "
                                   "grade=HEADER, feedback=HEADER, max=HEADER, each once, with "
                                   "commas between",
                                   text, one));
    *column = header;
  }
  return columns;
}

Filled fillMoodle(std::string_view bytes, const std::string& fileName,
                  const std::vector<Entry>& entries, const Columns& columns) {
  checkNumbers(entries);
  Csv csv(bytes, fileName);
  const MoodleColumns at = places(csv, fileName, columns);
  Filled filled;
  const std::vector<StudentRow> rows = studentRows(csv, at, filled.remarks);
  const std::vector<const Entry*> uploads = uploadsOf(rows, entries, fileName, filled.remarks);
  if (at.feedback == kNoColumn &&
      std::any_of(entries.begin(), entries.end(),
                  [](const Entry& entry) { return !entry.feedback.empty(); }))
    filled.remarks.push_back("the worksheet has no column for feedback, so that none is written: "
                             "switch \"Feedback comments\" on in Moodle, or name it with "
                             "--columns feedback=HEADER");
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (uploads[i]) fillRow(csv, rows[i], *uploads[i], at, filled.remarks);
  filled.bytes = csv.bytes();
  return filled;
}

} // namespace ggrade::gradebook
