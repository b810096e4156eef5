#pragma once
/// \file
/// Builds a student's program and draws the scenes that tell how far it has come.

#include "check/rows.hpp"
#include "grading/program.hpp"
#include "grading/progress.hpp"

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace ggrade::check {

/// What a program shows, in order of `Expected::scenes`.
struct Drawn {
  /// How building it ended, or the first scene that didn't end well, or the public one.
  grading::Happened happened;
  bool isBuilt = false;
  std::string compilerOutput;
  std::set<std::string> begun; ///< TODOs, by text and pictures
  std::size_t step = 0;        ///< up to which the program should be right
  Shown shown;
  /// Likewise, of a finished program in all scenes: where those that were handed out are wrong, the
  /// others tell apart what looks alike there.
  Shown everywhere;
  std::vector<Image> windows;          ///< first frames; RGB, empty: none came
  std::vector<std::uint64_t> vertices; ///< of the first frame
  /// What the program and OpenGL said in the public scene, and where it ended early, a line each.
  std::vector<std::string> messages;
  std::vector<channel::CapturedMessage> glMessages; ///< of the public scene
  trace::Trace trace;                               ///< likewise
  diagnosis::Facts facts;                           ///< likewise
  /// The TODO in whose scene, not the public one, the program ended early.
  std::string endedAt;

  /// Did frames of the public scene come?
  bool isJudged() const { return !shown.empty() && shown[0].has_value(); }
};

/// What the program and OpenGL said in one scene, a line each.
std::vector<std::string> messagesOf(const grading::Rendering& rendering);

/// Where `draw` keeps the program.
std::filesystem::path programIn(const std::filesystem::path& work);

/// The files in `folder`, in the public scene, those of TODOs that were begun, and, where these are
/// right, the others. `work` and errors as for `check`.
Drawn draw(const Assignment& assignment, const Expected& expected,
           const std::filesystem::path& folder, const std::filesystem::path& work,
           const grading::Progress& progress);

} // namespace ggrade::check
