#pragma once
/// \file
/// Grading one submission, from the upload to a result that the reports are written from.

#include "grading/reference_pictures.hpp"
#include "grading/references.hpp"
#include "grading/submitted.hpp"
#include "report/results.hpp"

#include <memory>
#include <optional>

namespace ggrade::grading {

/// Judges scenes whose folders are all filled in; `work` is for its files. `problem` says why items
/// stay unjudged. `again` names the items that are judged once more, by first frames alone, in the
/// scenes that have a student's folder; empty: all items.
using Judging = std::function<std::vector<report::Item>(
    const std::vector<rubric::SceneFolders>& scenes, const std::filesystem::path& work,
    std::string& problem, const std::vector<std::string>& again)>;

/// Adds to a judged submission's result what it finds out.
using Examining = std::function<void(const Submitted&, report::Result&)>;

struct GradeOptions {
  std::filesystem::path upload;
  bool solution =
      false; ///< `upload` is a trusted folder of solutions/, its other files are expected
  Draw draw;
  std::vector<std::string> judgeArguments; ///< GoogleTest's
  bool pictures = true; ///< false for who wants scores only: the result has items but no scenes
  /// Does the public scene run a second time (not with quality `fast`, nor if the program draws the
  /// reference's picture) to see whether the program draws the same again?
  bool twice = true;
  unsigned threads = workers(); ///< scenes rendered at a time; 1: nothing goes on beside another
  bool diagnosis = true;        ///< `grade` looks for the likeliest cause of lost points
  /// For who grades many submissions, one at a time, against the same references; empty: read anew.
  std::shared_ptr<ReferencePictures> referencePictures;
  Judging judging;     ///< empty: a judge's process for this grading alone
  Examining examining; ///< looks closer at what `gradeBuilt` judged, if anything does
  Progress progress;
};

/// A submission that was overlaid and built once, to be graded with one seed or several.
struct Built {
  report::Result result; ///< what every grading of it says, its outcome included
  std::shared_ptr<Program> program;
};

/// Says in a result which scenes it is about.
void nameScenes(const ScenePlan& plan, report::Result& result);

/// The result of a submission of which nothing was built, for the reason `detail`.
report::Result ungraded(const Target& target, report::Outcome outcome, const std::string& detail);

/// Overlays and builds `options.upload`. A program that doesn't build is no error: see the result's
/// outcome. Throws UsageError (no such folder) and Interrupted.
Built buildSubmission(const Target& target, const GradeOptions& options);
/// The same of a program of ours, which may be there already.
Built buildSubmission(const Target& target, std::shared_ptr<Program> program,
                      const GradeOptions& options);

/// Renders and judges what was built, in the scenes of `plan`, of which `references` has the rest.
/// The result's outcome says how that went. Throws Interrupted. Several threads may grade one
/// Built.
report::Result gradeBuilt(const Target& target, const ScenePlan& plan, const References& references,
                          const Built& built, const GradeOptions& options);

/// Looks for the likeliest cause of lost points of submissions that are all graded with one plan;
/// that, its references and `target` must outlive it.
Examining diagnosing(const Target& target, const std::filesystem::path& solutionFolder,
                     const Progress& progress);

/// The score and the bonus that `result.items` add up to.
void addUp(report::Result& result);

/// Grades one upload once, in the scenes of `options.draw`. Faults of the instructor's side (no
/// such folder, a broken reference) are UsageErrors. Throws Interrupted.
report::Result grade(const Target& target, const std::filesystem::path& solutionFolder,
                     const GradeOptions& options);

} // namespace ggrade::grading
