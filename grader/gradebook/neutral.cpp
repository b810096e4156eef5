#include "gradebook/neutral.hpp"

#include "gradebook/cells.hpp"
#include "gradebook/csv.hpp"
#include "gradebook/numbers.hpp"
#include "report/text.hpp"

#include <fmt/format.h>

namespace ggrade::gradebook {
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
  for (const Entry& entry : entries) {
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
