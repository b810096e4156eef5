#pragma once
/// \file
/// Submissions, graded in this process or by the real tool, which runs as a user runs it.

#include "../unit/framework_temporary_folder.hpp"

#include "calibration/programs.hpp"
#include "grading/grade.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

namespace tool {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;
/// Variables that are set besides the ones of the test itself.
using Environment = std::vector<std::pair<std::string, std::string>>;

/// The root of the source tree, and of this build.
inline const fs::path kSource = GGRADE_SOURCE_DIR, kBuild = GGRADE_BUILD_DIR;

/// How a command ended.
struct Ended {
  int exitCode = -1; ///< -1 if a signal ended it
  int signal = 0;    ///< that signal
  bool late = false; ///< it was killed because it took too long
  std::string out, errors;
};

/// A command that is still running, in a process group of its own as a shell gives it. Ended by
/// force when this goes.
class Running {
public:
  /// Starts `words[0]`, an absolute path, in `folder`.
  explicit Running(const Arguments& words, const Environment& environment = {},
                   const fs::path& folder = "/");
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  pid_t pid() const { return pid_; }
  /// What it has written so far.
  std::string out() const;
  std::string errors() const;
  /// Does stderr hold `text` within `seconds`?
  bool says(const std::string& text, double seconds) const;
  /// Sends a signal to the whole group, as Ctrl-C in a terminal does.
  void signalGroup(int signal) const;
  /// Waits for the end, `seconds` at most.
  Ended wait(double seconds);

private:
  TemporaryFolder files_;
  pid_t pid_ = -1;
};

/// Runs `ggrade` with `arguments` to its end.
Ended runTool(const Arguments& arguments, const Environment& environment = {},
              double seconds = 100);
/// The words that start `ggrade` with `arguments`.
Arguments words(const Arguments& arguments);

/// A folder of files as a student hands it in; removed at the end of the scope.
class Submission {
public:
  /// The files that students edit, as the solution has them.
  static Submission solution();
  /// As they are handed out.
  static Submission stub();
  /// The solution with a patch of `examples/`.
  static Submission example(const std::string& name);
  /// The solution with a patch of `mistakes/`.
  static Submission mistake(const std::string& name);
  /// The solution with a patch of `variants/`.
  static Submission variant(const std::string& name);
  /// With the first `count` TODOs of a part filled in.
  static Submission firstSteps(int count, const std::string& part = "mirror");
  /// Only floor.cpp, with this text.
  static Submission program(const std::string& text);

  /// Replaces `from`, which must stand in `file` exactly once.
  Submission& replace(const std::string& file, const std::string& from, const std::string& to);
  /// Writes a whole file.
  Submission& write(const std::string& file, const std::string& text);
  fs::path path() const { return folder_->path() / "submission"; }

private:
  Submission();
  std::unique_ptr<TemporaryFolder> folder_;
};

/// One graded submission.
struct Graded {
  Ended ended;                      ///< of the tool, where it graded
  nlohmann::json results;           ///< results.json; null if there is none
  ggrade::results::Result result{}; ///< where it was graded in this process

  std::string outcome() const;
  std::string detail() const;
  double score() const; ///< without the bonus
  double bonus() const;
  double earned(const std::string& item) const;
  std::string message(const std::string& item) const;
  /// Rubric items that cost points (gain and keep), by ID.
  std::vector<std::string> lost() const;
  std::string text() const; ///< "graded, 78.6 + 0", for messages
};

/// How a submission is graded.
struct How {
  bool solution = false; ///< a trusted folder of solutions/
  /// With the report's scenes and frames, and the second run that tells whether a program draws the
  /// same again.
  bool pictures = false;
  bool diagnosis = false; ///< what of it is about the public scene needs the pictures, too
  bool repair = false;    ///< is each fault counted once? Else the rubric's word alone
  ggrade::grading::Draw draw{};
};

/// Everything that the gradings of one target have in common, in this process: its scenes, the
/// reference's pictures and a judge that stays. What a class is graded with, and as the tool does.
class Grader {
public:
  /// The one of an assignment or part. Only the last few are kept: each has a judge's memory.
  static Grader& of(const std::string& id, const ggrade::grading::Draw& draw = {});

  Grader(const std::string& id, const ggrade::grading::Draw& draw);

  const ggrade::Target& target() const { return target_; }
  const ggrade::grading::ScenePlan& plan() const { return plan_; }
  const ggrade::grading::References& references() const { return references_; }
  ggrade::grading::Built build(const fs::path& folder, const How& how = {});
  /// Builds and grades, once for the same files.
  const Graded& grade(const fs::path& folder, const How& how = {},
                      std::size_t scenes = std::size_t(-1));
  /// \param scenes only the first so many of the plan; what none of them shows is given
  Graded grade(const ggrade::grading::Built& built, const How& how = {},
               std::size_t scenes = std::size_t(-1));

private:
  ggrade::grading::Grader& grader(const How& how);

  ggrade::Target target_;
  fs::path solutions_;
  ggrade::grading::ScenePlan plan_;
  ggrade::grading::References references_;
  std::map<std::pair<bool, bool>, std::unique_ptr<ggrade::grading::Grader>> graders_;
  std::map<std::string, Graded> graded_; ///< by files and how
};

/// Grades for part `mirror`, in this process.
Graded grade(const Submission& submission, const How& how = {});
Graded grade(const fs::path& folder, const How& how = {});

/// Grades for another part, or for "floor": all parts.
Graded gradePart(const std::string& part, const fs::path& folder, const How& how = {});
Graded gradePart(const std::string& part, const Submission& submission, const How& how = {});

/// The same by the real tool, without a diagnosis; a failure of the tool is a failure of the test.
Graded gradeByTool(const fs::path& folder, const Arguments& more = {},
                   const Environment& environment = {});
Graded gradeByTool(const Submission& submission, const Arguments& more = {},
                   const Environment& environment = {});

/// A patch of a part's catalogue, and what must become of it.
struct Catalogued {
  std::string part;
  ggrade::calibration::KnownAnswer program;
  std::string shows; ///< mistake: tag of the scenes that show it
};
/// Google Test names a case by it.
void PrintTo(const Catalogued& one, std::ostream* out);

/// Every mistake and variant of every part.
std::vector<Catalogued> catalogue();
/// Grades one as `calibrate` does, with the assignment's own seed, and expects that it loses what
/// it must and nothing that it may not. A mistake is graded in the public scene and as far as those
/// that show it, unless all scenes are asked for; a variant in all.
Graded gradeCatalogued(const Catalogued& one, bool allScenes = false,
                       const How& how = {.repair = true});
/// The mistake with this name, in all scenes, by the rubric alone.
Graded gradeMistake(const std::string& name);

/// Expects no line of an assignment's solution in any file under `handedOut`; with `wholeBlocks` no
/// block of several lines (single ones any program has). Returns the number of blocks that the
/// solution has.
int expectNoSolutionIn(const ggrade::Assignment& assignment, const fs::path& handedOut,
                       bool wholeBlocks = false);

/// A whole file as text; fails the test where there is none.
std::string read(const fs::path& file);
/// The names in a folder, sorted; without the list of contents that the tool keeps.
std::vector<std::string> names(const fs::path& folder);

} // namespace tool
