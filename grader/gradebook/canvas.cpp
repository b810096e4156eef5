#include "gradebook/worksheet_parts.hpp"

#include "assignment/usage_error.hpp"
#include "gradebook/cells.hpp"
#include "gradebook/csv.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace ggrade::gradebook {
namespace {

struct CanvasColumns {
  std::size_t id, login, assignment, pointsRow; // login: kNoColumn if there is none
  bool hasLastName;                             // LastName,FirstName in place of Student
};

[[noreturn]] void noGradebook(const std::string& fileName, const std::string& why) {
  throw UsageError(fmt::format("{}: this is no gradebook of Canvas: {}; export it with Grades, "
                               "Export, Export Entire Gradebook",
                               fileName, why));
}

std::size_t columnCalled(const Csv& csv, const std::string& header) {
  for (std::size_t column = 0; column < csv.columns(0); ++column)
    if (foldedHeader(csv.cell(0, column)) == header) return column;
  return kNoColumn;
}

// "Floor" for "Floor (12345)"; the header itself if it has no number.
std::string assignmentName(const std::string& header) {
  const std::size_t open = header.rfind(" (");
  if (open == header.npos || !header.ends_with(')')) return header;
  const std::string number = header.substr(open + 2, header.size() - open - 3);
  const bool isNumber =
      !number.empty() && number.find_first_not_of("0123456789") == std::string::npos;
  return isNumber ? header.substr(0, open) : header;
}

std::size_t assignmentColumn(const Csv& csv, const std::string& fileName,
                             const std::string& assignment) {
  const std::string wanted(trimmed(assignment));
  std::vector<std::size_t> exact, named;
  for (std::size_t column = 0; column < csv.columns(0); ++column) {
    const std::string header(trimmed(csv.cell(0, column)));
    if (header == wanted) exact.push_back(column);
    if (assignmentName(header) == wanted) named.push_back(column);
  }
  const auto& found = exact.size() == 1 ? exact : named;
  if (found.size() == 1) return found.front();
  throw UsageError(fmt::format("{}: {} columns are called \"{}\" or \"{} (NUMBER)\": name one with "
                               "its number; there are {}",
                               fileName, found.empty() ? "no" : std::to_string(found.size()),
                               wanted, wanted, headers(csv, 0)));
}

CanvasColumns places(const Csv& csv, const std::string& fileName, const std::string& assignment) {
  if (csv.rows() == 0) noGradebook(fileName, "it is empty");
  const bool hasLastName = foldedHeader(csv.cell(0, 0)) == "lastname";
  if (!hasLastName && foldedHeader(csv.cell(0, 0)) != "student")
    noGradebook(fileName, "the first column is not \"Student\"");
  const std::size_t id = columnCalled(csv, "id");
  if (id == kNoColumn) noGradebook(fileName, "there is no column \"ID\"");
  for (std::size_t row = 1; row < csv.rows(); ++row)
    if (foldedHeader(csv.cell(row, 0)) == "points possible")
      return {id, columnCalled(csv, "sis login id"), assignmentColumn(csv, fileName, assignment),
              row, hasLastName};
  noGradebook(fileName, "there is no row \"Points Possible\"");
}

MarkedNumber pointsPossible(const Csv& csv, const std::string& fileName, const CanvasColumns& at) {
  const std::string cell = cellOf(csv, at.pointsRow, at.assignment);
  const std::string header = report::sanitizeLine(csv.cell(0, at.assignment));
  if (foldedHeader(cell).find("read only") != std::string::npos)
    throw UsageError(
        fmt::format("{}: Canvas works out the column \"{}\" itself (read only): name an assignment",
                    fileName, header));
  const auto points = readMarkedNumber(cell, defaultMark(csv));
  if (!points || points->value <= 0)
    throw UsageError(fmt::format("{}:{}: the points possible of \"{}\" are \"{}\": give the "
                                 "assignment points in Canvas, and export the gradebook again",
                                 fileName, csv.line(at.pointsRow), header,
                                 report::sanitizeLine(cell)));
  return *points;
}

// A row above the students' says which assignments are posted manually: it names no one.
bool isStudent(const Csv& csv, std::size_t row, const CanvasColumns& at) {
  return row != at.pointsRow && !cellOf(csv, row, 0).empty();
}

bool isTestStudent(const Csv& csv, std::size_t row, const CanvasColumns& at) {
  const std::string name = foldedHeader(cellOf(csv, row, 0));
  if (at.hasLastName) return name == "student" && foldedHeader(cellOf(csv, row, 1)) == "test";
  return name == "student, test" || name == "test student";
}

std::vector<StudentRow> studentRows(const Csv& csv, const CanvasColumns& at,
                                    std::vector<std::string>& remarks) {
  std::vector<StudentRow> rows;
  for (std::size_t row = 1; row < csv.rows(); ++row) {
    if (!isStudent(csv, row, at)) continue;
    const std::string id = plainIdentifier(cellOf(csv, row, at.id));
    const std::string login = plainIdentifier(cellOf(csv, row, at.login));
    const std::string shown =
        shownRow(csv, row, fmt::format("{} (ID {})", cellOf(csv, row, 0), id));
    if (csv.columns(row) <= at.assignment)
      remarks.push_back(fmt::format("{}: only {} of {} cells, left as it is", shown,
                                    csv.columns(row), csv.columns(0)));
    else if (id.empty() && login.empty())
      remarks.push_back(shown + ": neither ID nor SIS Login ID, left as it is");
    else
      rows.push_back({row, shown, {id, login}});
  }
  return rows;
}

void fillRow(Csv& csv, const StudentRow& row, const Entry& entry, const CanvasColumns& at,
             const MarkedNumber& max, std::vector<std::string>& remarks) {
  const auto left = [&](const std::string& why) {
    remarks.push_back(fmt::format("{}: {}, left as it is", row.shown, why));
  };
  if (!entry.score) return left("not gradable");
  const std::string before = foldedHeader(csv.cell(row.row, at.assignment));
  if (before == "ex") return left("excused");
  if (before == "n/a") return left("the student doesn't have the assignment");
  writeGrade(csv, row, at.assignment, *finalScore(entry) / entry.maxScore * max.value, max,
             remarks);
}

} // namespace

Filled fillCanvas(std::string_view bytes, const std::string& fileName,
                  const std::vector<Entry>& entries, const std::string& assignment) {
  checkNumbers(entries);
  Csv csv(bytes, fileName);
  const CanvasColumns at = places(csv, fileName, assignment);
  const MarkedNumber max = pointsPossible(csv, fileName, at);
  Filled filled;
  std::vector<StudentRow> rows = studentRows(csv, at, filled.remarks);
  std::erase_if(rows, [&](const StudentRow& row) { return isTestStudent(csv, row.row, at); });
  const std::vector<const Entry*> uploads = uploadsOf(rows, entries, fileName, filled.remarks);
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (uploads[i]) fillRow(csv, rows[i], *uploads[i], at, max, filled.remarks);
  filled.bytes = csv.bytes();
  return filled;
}

} // namespace ggrade::gradebook
