#pragma once
/// \file
/// What is kept of one graded submission beside its pages: all that the class page, the gradebooks,
/// a later run and a merge ask for.

#include "batch/job.hpp"
#include "report/class_page.hpp"
#include "report/reveal.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace ggrade::batch {

/// `record.json` in a result's folder, with `thumbnail.png` beside it.
struct Record {
  /// The machine's share of it: no penalty; adjustments are written for who reads the file, and
  /// made anew for every page.
  report::ClassRow row;
  std::string target; ///< ID of what was graded
  std::uint64_t seed = 0;
  std::string upload;      ///< hash of what was handed in
  std::string grader;      ///< hash of tool, rubrics, points, reference and scenes
  std::string sandbox;     ///< "bubblewrap 0.8.0" or "none"
  std::string machine;     ///< what drew it: processor, renderer, GL's version, context
  std::string feedback;    ///< for a gradebook: plain UTF-8
  unsigned run = 0;        ///< of this class; counts regradings
  bool isAdjusted = false; ///< does the file name adjustments?
};

/// What a record keeps of `result`; the feedback says what a student may know. The rest of the row
/// (folder, student, name, submitted, remarks) is the caller's.
Record recordOf(const results::Result& result, report::Reveal reveal);

/// Writes `record.json` and `thumbnail.png` into `folder`, which must exist.
void saveRecord(const std::filesystem::path& folder, const Record& record);

/// Nothing where there is none. One that makes no sense is none, either: its submission will be
/// graded again. The thumbnail is read, too. Throws std::system_error if the machine can't read
/// now what is there.
std::optional<Record> loadRecord(const std::filesystem::path& folder);

/// Every record in the folders of `out`, by folder name. `damaged` gets the names of folders that
/// hold a result whose record can't be read.
std::vector<Record> loadRecords(const std::filesystem::path& out,
                                std::vector<std::string>* damaged = nullptr);

/// Where a result becomes a folder.
struct Destination {
  std::filesystem::path out; ///< of the class
  report::Reveal reveal = report::Reveal::names;
  std::string grader; ///< as in Record
  unsigned run = 1;
};

/// Writes pages and record of `job` aside and moves them to their folder in one step; what stood
/// there is replaced. Throws with the remedy if that can't be done, and leaves nothing.
void publish(results::Result result, const Job& job, const Destination& destination);

} // namespace ggrade::batch
