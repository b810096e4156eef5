#include "gradebook/entry.hpp"

#include "gradebook/cells.hpp"
#include "gradebook/csv.hpp"
#include "gradebook/look_alike.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace ggrade::gradebook {

std::vector<std::string> studentsOf(const std::vector<Entry>& entries) {
  std::vector<std::string> students;
  for (const Entry& entry : entries) students.push_back(entry.student);
  return students;
}

std::optional<double> finalScore(const Entry& entry) {
  if (!entry.score) return {};
  return std::max(0.0, *entry.score - entry.penalty);
}

void checkNumbers(const std::vector<Entry>& entries) {
  for (const Entry& entry : entries) {
    const bool fine = std::isfinite(entry.score.value_or(0)) && std::isfinite(entry.maxScore) &&
                      entry.maxScore > 0 && std::isfinite(entry.penalty) && entry.penalty >= 0;
    if (!fine)
      throw std::invalid_argument(fmt::format("{}: score {} of {}, penalty {}", entry.student,
                                              entry.score.value_or(0), entry.maxScore,
                                              entry.penalty));
  }
}

namespace {

std::string textCell(const std::string& text) {
  return csvCell(neutralized(report::sanitize(text)));
}

} // namespace

std::string neutralCsv(const std::string& assignment, const std::string& due,
                       const std::vector<Entry>& entries) {
  checkNumbers(entries);
  std::string csv = "assignment,duedate,timestamp,student_id,last_name,first_name,email,raw_score,"
                    "late_submission_penalty,score,max_score\n";
  const auto others = lookAlikes(studentsOf(entries));
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (!others[i].empty()) continue;
    const Entry& entry = entries[i];
    const auto ifScored = [&](double value) {
      return entry.score ? writeNumber(value) : std::string();
    };
    csv += fmt::format("{},{},{},{},{},,,{},{},{},{}\n", textCell(assignment), textCell(due),
                       textCell(entry.submitted), textCell(entry.student), textCell(entry.name),
                       ifScored(entry.score.value_or(0)), ifScored(entry.penalty),
                       ifScored(finalScore(entry).value_or(0)), writeNumber(entry.maxScore));
  }
  return csv;
}

} // namespace ggrade::gradebook
