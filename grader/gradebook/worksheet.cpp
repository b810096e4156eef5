#include "gradebook/worksheet_parts.hpp"

#include "assignment/usage_error.hpp"
#include "gradebook/cells.hpp"
#include "gradebook/look_alike.hpp"
#include "report/text.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <set>

namespace ggrade::gradebook {
namespace {

std::map<std::string, std::size_t> rowsByKey(const std::vector<StudentRow>& rows, std::size_t key,
                                             const std::string& fileName) {
  std::map<std::string, std::size_t> found;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (key >= rows[i].keys.size() || rows[i].keys[key].empty()) continue;
    const auto [place, isNew] = found.emplace(rows[i].keys[key], i);
    if (!isNew)
      throw UsageError(fmt::format("{}: {} and {} have the same identifier \"{}\": export the "
                                   "worksheet again, or take one of the rows out",
                                   fileName, rows[place->second].shown, rows[i].shown,
                                   report::sanitizeLine(place->first)));
  }
  return found;
}

std::string shownName(const Entry& entry) {
  const std::string student = entry.given.empty() ? entry.student : visible(entry.given);
  const bool named = !entry.name.empty() && entry.name != entry.student;
  return report::sanitizeLine(named ? student + " (" + entry.name + ")" : student);
}

} // namespace

std::string shownRow(const Csv& csv, std::size_t row, std::string_view identifier) {
  return fmt::format("line {}, {}", csv.line(row), report::sanitizeLine(identifier, 100));
}

std::string headers(const Csv& csv, std::size_t row) {
  std::vector<std::string> all;
  for (std::size_t column = 0; column < csv.columns(row); ++column)
    all.push_back("\"" + report::sanitizeLine(csv.cell(row, column), 60) + "\"");
  return fmt::format("{}", fmt::join(all, ", "));
}

char defaultMark(const Csv& csv) {
  return csv.delimiter() == ';' ? ',' : '.';
}

std::vector<const Entry*> uploadsOf(const std::vector<StudentRow>& rows,
                                    const std::vector<Entry>& entries, const std::string& fileName,
                                    std::vector<std::string>& remarks) {
  std::size_t keys = 0;
  for (const StudentRow& row : rows) keys = std::max(keys, row.keys.size());
  std::vector<std::map<std::string, std::size_t>> byKey;
  for (std::size_t key = 0; key < keys; ++key) byKey.push_back(rowsByKey(rows, key, fileName));

  std::map<std::string, std::set<std::size_t>> rowsLike;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const std::string& key : rows[i].keys)
      if (!key.empty()) rowsLike[skeleton(key)].insert(i);

  const auto others = lookAlikes(studentsOf(entries));
  std::vector<std::set<std::size_t>> claims(rows.size()); // places of entries
  std::vector<std::string> strangers;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    std::set<std::size_t> found;
    for (const auto& known : byKey) {
      const auto row = known.find(plainIdentifier(entries[i].student));
      if (row != known.end()) found.insert(row->second);
    }
    // One that looks like another upload may be meant as the row that it only looks like.
    const auto like = rowsLike.find(skeleton(entries[i].student));
    if (found.empty() && !others[i].empty() && like != rowsLike.end()) found = like->second;
    if (found.size() == 1) {
      claims[*found.begin()].insert(i);
      claims[*found.begin()].insert(others[i].begin(), others[i].end());
    } else if (found.empty()) {
      strangers.push_back(shownName(entries[i]) + ": the upload has no row in the worksheet");
    } else {
      std::vector<std::string> shown;
      for (const std::size_t row : found) shown.push_back(rows[row].shown);
      strangers.push_back(fmt::format("{}: the upload could belong to {}; no grade is written",
                                      shownName(entries[i]), fmt::join(shown, " or to ")));
    }
  }

  std::vector<const Entry*> uploads;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    uploads.push_back(claims[i].size() == 1 ? &entries[*claims[i].begin()] : nullptr);
    if (claims[i].empty()) remarks.push_back(rows[i].shown + ": no upload");
    if (claims[i].size() < 2) continue;
    std::vector<std::string> names;
    for (const std::size_t entry : claims[i]) names.push_back(shownName(entries[entry]));
    remarks.push_back(fmt::format("{}: {} uploads claim this row, no grade is written: {}",
                                  rows[i].shown, names.size(), fmt::join(names, ", ")));
  }
  remarks.insert(remarks.end(), strangers.begin(), strangers.end());
  return uploads;
}

void writeGrade(Csv& csv, const StudentRow& row, std::size_t column, double score,
                const MarkedNumber& max, std::vector<std::string>& remarks) {
  const std::string grade = writeNumber(score, max.mark);
  const std::string before(trimmed(csv.cell(row.row, column)));
  const auto old = readMarkedNumber(before, max.mark);
  if (old && writeNumber(old->value, max.mark) == grade) return;
  csv.set(row.row, column, grade);
  // Moodle writes "-" and Canvas nothing where there is no grade.
  if (!before.empty() && before != "-")
    remarks.push_back(fmt::format("{}: {} replaces the grade {}", row.shown, grade,
                                  report::sanitizeLine(before, 60)));
}

} // namespace ggrade::gradebook
