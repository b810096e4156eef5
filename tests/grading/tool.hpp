#pragma once
/// \file
/// The real tool, run as a user runs it in a process of its own, and submissions made for it.

#include "../unit/framework_temporary_folder.hpp"

#include "assignment/assignment.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
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
  /// The solution with `solutions/floor/examples/<name>.patch`.
  static Submission example(const std::string& name);
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
  Ended ended;
  nlohmann::json results; ///< results.json; null if there is none

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

/// Among further arguments: grade with a diagnosis, which is left out otherwise.
inline const std::string kDiagnosed = "(with a diagnosis)";

/// Grades for part `mirror`; a failure of the tool is a failure of the test.
Graded grade(const Submission& submission, const Arguments& more = {},
             const Environment& environment = {});
Graded grade(const fs::path& folder, const Arguments& more = {},
             const Environment& environment = {});

/// Grades for another part, or for "floor": all parts.
Graded gradePart(const std::string& part, const fs::path& folder, const Arguments& more = {},
                 const Environment& environment = {});
Graded gradePart(const std::string& part, const Submission& submission);

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
