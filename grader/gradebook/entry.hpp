#pragma once
/// \file
/// What gradebooks need of one student, and the plain gradebook that is made of it.

#include <optional>
#include <string>
#include <vector>

namespace ggrade::gradebook {

struct Entry {
  std::string student; ///< identifier as in the upload's name: "1234"
  std::string name;    ///< empty where marking is blind
  /// Points before `penalty` is taken off; none: not gradable, no grade is written.
  std::optional<double> score{};
  double maxScore = 0;
  double penalty = 0;      ///< points taken off for lateness
  std::string feedback{};  ///< plain UTF-8, lines end in LF
  std::string submitted{}; ///< ISO 8601, or empty
  std::string given{};     ///< the identifier as it was found; empty: `student`
};

/// Of each entry, for lookAlikes.
std::vector<std::string> studentsOf(const std::vector<Entry>& entries);

/// The points that count, never below 0; none where there is no score.
std::optional<double> finalScore(const Entry& entry);

/// Throws std::invalid_argument with the student unless all numbers are finite, the maximum is
/// above 0 and the penalty is not negative.
void checkNumbers(const std::vector<Entry>& entries);

/// nbgrader's gradebook, which any spreadsheet and many tools read: one row an entry under the
/// header `assignment,duedate,timestamp,student_id,last_name,first_name,
/// email,raw_score,late_submission_penalty,score,max_score`; lines end in LF.
///
/// A student who was not gradable has a row with empty `raw_score`, `late_submission_penalty` and
/// `score`: that is not 0 points. Students who look like one another (lookAlikes) have no row, so
/// that nobody has two. The whole name stands in `last_name`, since nothing says where to
/// split it. All text is neutralized.
/// \param due ISO 8601, or empty
/// Throws std::invalid_argument for numbers that are none (checkNumbers).
std::string neutralCsv(const std::string& assignment, const std::string& due,
                       const std::vector<Entry>& entries);

} // namespace ggrade::gradebook
