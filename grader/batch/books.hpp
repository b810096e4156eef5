#pragma once
/// \file
/// What instructors read and hand on: the class page and the gradebooks, made from the records in
/// the class' folder and from what the instructor decided.

#include "batch/record.hpp"
#include "gradebook/lateness.hpp"
#include "gradebook/overrides.hpp"
#include "gradebook/worksheet.hpp"

namespace ggrade::batch {

struct BookOptions {
  std::filesystem::path overrides; ///< empty: `overrides.csv` in the class' folder, if it is there
  std::filesystem::path submitted; ///< when who handed in; empty: nobody is late
  std::string due, late;           ///< needed with `submitted`
  std::vector<std::string> gradebooks; ///< "moodle=FILE", "canvas=FILE"
  std::string columns;                 ///< of Moodle's, see gradebook::readColumns
  std::string canvasColumn;            ///< the assignment's name in Canvas; empty: the title
};

/// What stands on the page besides the records.
struct PageNotes {
  std::string title, intro;
  std::vector<report::ScoreChange> changes;
  std::vector<std::string> refused; ///< of the folder of uploads
  std::string selfTest;             ///< of the sandbox, in words
  std::vector<std::string> remarks;
  std::vector<std::string> missing; ///< results that have no row; Books::write finds them
  std::vector<std::pair<std::string, std::string>> facts;
  /// As in ClassPage; made of the records by Books::write.
  std::vector<std::pair<std::string, std::string>> protections;
  std::size_t unprotected = 0;
};

class Books {
public:
  /// Reads everything that the instructor gave, so that a mistake there shows before hours of
  /// grading. Throws UsageError.
  Books(BookOptions options, const std::filesystem::path& out);

  /// Writes `index.html`, `gradebook.csv`, `moodle.csv` and `canvas.csv` of the folder `out`, each
  /// whole or not at all, and puts decisions into the students' pages. No machine score is changed.
  /// Returns the rows of the page, by name, and in `notes` what could not be filled in and what the
  /// records say of the sandbox.
  std::vector<report::ClassRow> write(const std::filesystem::path& out, PageNotes& notes) const;

private:
  struct Worksheet {
    std::string kind, file, bytes;
  };
  void adjust(std::vector<Record>& records, PageNotes& notes) const;

  BookOptions options_;
  std::string overridesFile_;
  std::vector<gradebook::Override> overrides_;
  std::optional<gradebook::LateRule> rule_;
  std::vector<gradebook::Submission> submissions_;
  std::vector<Worksheet> worksheets_;
  gradebook::Columns columns_;
};

} // namespace ggrade::batch
