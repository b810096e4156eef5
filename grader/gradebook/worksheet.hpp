#pragma once
/// \file
/// Filling in the gradebooks that an instructor has exported from Moodle or Canvas.
///
/// Nothing is guessed. What cannot be filled in for certain stays as it was, and a remark says
/// where and why: students without an upload, uploads without a row, rows that are locked, uploads
/// that claim the same row or look like one another (lookAlikes), students who were not gradable,
/// grades that were there before.
///
/// Scores are scaled to the worksheet's maximum and have two decimals at most. The decimal mark is
/// the one of the maximum ("100,00"); where that has none, it is a comma if cells are separated by
/// `;`, as sites with a decimal comma write it, else a point.

#include "gradebook/entry.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace ggrade::gradebook {

/// A worksheet with grades in it.
struct Filled {
  std::string bytes; ///< all but the cells that were filled in are those of the worksheet
  std::vector<std::string> remarks; ///< for the instructor, one sentence each
};

/// Headers of a Moodle worksheet that is in a language or of a kind that fillMoodle doesn't know.
/// Empty: found by what Moodle calls them in English and Japanese.
struct Columns {
  std::string identifier, grade, feedback, max;
};
/// From "identifier=ID,grade=Note,feedback=Kommentar,max=Bestnote"; any of them may be left out.
/// Throws UsageError with the accepted form.
Columns readColumns(std::string_view text);

/// Fills in the grade and the feedback of Moodle's offline grading worksheet; rows are found by the
/// identifier ("Participant 1234" is the student 1234).
///
/// Left as they are: rows whose grade can't be changed, rows without a valid maximum, and the
/// feedback where no grade is written, as it would wipe the grade. Feedback is HTML, see
/// feedbackCell. Moodle takes no grade above the maximum, so that more points are written as the
/// maximum.
/// Throws UsageError with the file and the remedy where a column is missing or found twice, two
/// rows have the same identifier, or the assignment is graded on a scale of words;
/// std::invalid_argument for numbers that are none (checkNumbers).
Filled fillMoodle(std::string_view bytes, const std::string& fileName,
                  const std::vector<Entry>& entries, const Columns& columns = {});

/// Fills in one assignment of Canvas' gradebook. Rows are found by `ID`, else by `SIS Login ID`;
/// the maximum stands in the row "Points Possible". Canvas takes more points than possible.
///
/// Left as they are: the test student, students who are excused (EX) or don't have the assignment
/// (N/A).
/// \param assignment its name, or the whole header: "Floor" finds "Floor (12345)"
/// Throws like fillMoodle, and where the assignment is not there, there twice or read-only.
Filled fillCanvas(std::string_view bytes, const std::string& fileName,
                  const std::vector<Entry>& entries, const std::string& assignment);

} // namespace ggrade::gradebook
