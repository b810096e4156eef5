#pragma once
/// \file
/// The page about a whole class: one HTML file that links to each student's.

#include "results/results.hpp"

#include <string>
#include <utility>
#include <vector>

namespace ggrade::report {

/// An instructor's decision about one student, beside the machine's.
struct Adjustment {
  std::string item;   ///< ID of the item; empty: the total
  double machine = 0; ///< points that the machine gave
  double points = 0;  ///< points that stand instead
  std::string reason, who;
  std::string beyond{}; ///< why the points can hardly be meant, as in gradebook::Change; or empty
};

/// How one item went for one student. Points as in Item.
struct ClassItem {
  std::string id, title;
  results::ItemKind kind = results::ItemKind::gain;
  double earned = 0, points = 0;
  bool judged = false;
};

/// What a student is told of the likeliest cause.
struct ClassDiagnosis {
  std::string id; ///< equal for equal mistakes; empty: unknown
  std::string text;
};

/// One student.
struct ClassRow {
  std::string folder;  ///< of the result, relative to the page; a safe name
  std::string student; ///< key in gradebooks
  std::string name;    ///< for people
  results::Outcome outcome = results::Outcome::notGradable;
  std::string headline; ///< how it ended, one sentence
  std::string reason;   ///< the diagnosis, what lost most, or the evidence; may be empty
  double score = 0, bonus = 0, maxScore = 0; ///< the machine's
  double penalty = 0;                        ///< points off for lateness
  /// After adjustments, bonus and penalty. Of what was not gradable it counts only if one of the
  /// adjustments is of the total.
  double finalScore = 0;
  std::vector<Adjustment> adjustments;
  std::vector<ClassItem> items;
  std::vector<ClassDiagnosis> diagnoses;
  std::string submitted;            ///< ISO 8601, or empty
  std::vector<std::string> remarks; ///< on the upload: attempts
  std::vector<std::string> refused; ///< "name: why", what of the upload was not taken
  std::string given; ///< the identifier as it was found, all characters kept; empty: `student`
  /// Other uploads of the class whose identifiers look like this one's, and this one as it was
  /// found: in quotes, with what can't be seen by its number. Empty where there are none.
  std::vector<std::string> lookAlikes;
  std::string quoted;
  std::string thumbnail; ///< a PNG's bytes; may be empty
  double seconds = 0;    ///< that grading took
};

/// A score that is another one than in the run before.
struct ScoreChange {
  std::string name, folder;
  double before = 0, after = 0;
};

struct ClassPage {
  std::string title;                ///< the part's or assignment's
  std::string intro;                ///< one or two sentences; may be empty
  std::vector<ClassRow> rows;       ///< by name
  std::vector<ScoreChange> changes; ///< drops first
  std::vector<std::string> refused; ///< of the folder of uploads, "name: why"
  /// What kept programs away from the machine, the first one being the sandbox's name.
  std::vector<std::pair<std::string, std::string>> protections;
  bool selfTested = false;          ///< was the sandbox tried before this run?
  std::size_t unprotected = 0;      ///< submissions that ran without a sandbox
  std::vector<std::string> remarks; ///< on the run: what was passed over, shards
  std::vector<std::pair<std::string, std::string>> facts; ///< seed, tool, late rule, ...
};

/// The whole page.
std::string classPage(const ClassPage& page);

/// What an instructor decided, for the student: "Shading: the grader gave 3 of 20, your instructor
/// gave 10: drawn at half the size (teacher)".
std::string decisionText(const ClassRow& row, const Adjustment& adjustment);

/// `page`, a student's or instructor's page of one result, with what an instructor decided and what
/// lateness costs in the place that the page keeps for it; what stood there before is replaced.
/// `finalScore` is shown if anything was changed. A page without that place is returned as it is.
std::string withAdjustments(std::string page, const ClassRow& row, const std::string& lateRule);

} // namespace ggrade::report
