#pragma once
/// \file
/// A student's own program against what is expected of it, on the student's own machine: no
/// sandbox, no solution.

#include "check/rows.hpp"
#include "grading/program.hpp"
#include "grading/progress.hpp"

namespace ggrade::check {

/// A picture that isn't as it should be now, beside the one that is expected.
struct Wrong {
  std::string name;      ///< "the window at 0.9 s"
  std::size_t scene = 0; ///< of `Expected::scenes`
  bool another = false;  ///< is that a scene that wasn't handed out?
  double share = 0;      ///< of its pixels
  std::string missing;   ///< says that the program has no such picture; empty: it has
  Image ours;            ///< empty: the program makes no such picture
  Image expected;
  std::set<std::string> samplers; ///< uniforms by which the pass that draws it reads textures
};

/// One look at a program.
struct Checked {
  grading::Happened happened;
  bool drawn = false;                ///< did frames come, so that the rows are judged?
  std::vector<std::string> messages; ///< what the program and OpenGL said, a line each
  std::vector<Row> rows;             ///< no row is `done` or `wrong` if nothing was drawn
  std::string likely; ///< the TODO in whose place the fault most likely is; may be empty
  std::optional<Wrong>
      firstWrong;      ///< the first wrong picture of a frame, against what should be there now
  std::string cause;   ///< the likeliest one, in words; empty: none is known
  std::string hint;    ///< what to look at; may be empty
  std::string misread; ///< a sampler that reads another texture than it should; may be empty
  std::vector<std::string> titles; ///< of several mistakes that look alike; `hint` has them, too
  /// Is this for the student to find out, and told bit by bit? Not what compiler, OpenGL or the
  /// program itself say.
  bool isPuzzle = false;
  std::size_t scene = 0; ///< whose windows follow; of `Expected::scenes`
  Image window;          ///< first frame; RGB, empty: none came
  Image expectedWindow;  ///< of the program that has done what was begun
  Image finishedWindow;  ///< the reference's
  double seconds = 0;
};

/// Builds and runs the files in `folder` and says how far they are. `work` keeps the program until
/// the next call: where only shaders have changed it isn't compiled again. Throws UsageError where
/// `folder` holds no file of the assignment, and Interrupted.
Checked check(const Assignment& assignment, const Expected& expected,
              const std::filesystem::path& folder, const std::filesystem::path& work,
              const grading::Progress& progress);

} // namespace ggrade::check
