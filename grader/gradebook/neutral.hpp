#pragma once
/// \file
/// nbgrader's gradebook, which any spreadsheet and many tools read.

#include "gradebook/entry.hpp"

namespace ggrade::gradebook {

/// One row an entry under the header `assignment,duedate,timestamp,student_id,last_name,first_name,
/// email,raw_score,late_submission_penalty,score,max_score`; lines end in LF.
///
/// A student who was not gradable has a row with empty `raw_score`, `late_submission_penalty` and
/// `score`: that is not 0 points. The whole name stands in `last_name`, since nothing says where to
/// split it. All text is neutralized.
/// \param due ISO 8601, or empty
/// Throws std::invalid_argument for numbers that are none (checkNumbers).
std::string neutralCsv(const std::string& assignment, const std::string& due,
                       const std::vector<Entry>& entries);

} // namespace ggrade::gradebook
