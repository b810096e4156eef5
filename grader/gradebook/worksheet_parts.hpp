#pragma once
/// \file
/// What filling in any worksheet takes, whoever has exported it.

#include "gradebook/cells.hpp"
#include "gradebook/csv.hpp"
#include "gradebook/worksheet.hpp"

namespace ggrade::gradebook {

/// In place of a column: there is none.
constexpr std::size_t kNoColumn = std::string::npos;

/// A student's row.
struct StudentRow {
  std::size_t row = 0;
  std::string shown;             ///< "line 5, Participant 1234"
  std::vector<std::string> keys; ///< plain identifiers by column; empty: the row has none there
};

/// "line 5, Participant 1234", safe to print.
std::string shownRow(const Csv& csv, std::size_t row, std::string_view identifier);

/// The upload of each row; null where there is none or it isn't certain, and then a remark says so.
/// Throws UsageError naming both lines where two rows share a key.
std::vector<const Entry*> uploadsOf(const std::vector<StudentRow>& rows,
                                    const std::vector<Entry>& entries, const std::string& fileName,
                                    std::vector<std::string>& remarks);

/// Writes the score on the scale of `max` and remarks on the grade that it replaces. A grade of the
/// same value stays as it was written.
void writeGrade(Csv& csv, const StudentRow& row, std::size_t column, double score,
                const MarkedNumber& max, std::vector<std::string>& remarks);

/// All headers of a row, for messages.
std::string headers(const Csv& csv, std::size_t row);

/// The mark of a number that has none of its own.
char defaultMark(const Csv& csv);

} // namespace ggrade::gradebook
