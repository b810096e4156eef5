#pragma once
/// \file
/// What `render` and `inspect` share: a target named on the command line, built and rendered.

#include "cli/terminal.hpp"
#include "grading/program.hpp"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace ggrade::cli {

struct Size {
  std::uint32_t width = 0, height = 0; ///< pixels; 0 as the program asks
};

/// "640x480"; empty text gives {0, 0}. Throws UsageError for anything else.
Size parseSize(const std::string& text);

/// `times` after the frames of --before. Throws UsageError unless every time is a finite number of
/// seconds from 0 and there are not too many. `option` is the option's name, such as `--times`.
grading::Moments momentsOf(const std::vector<double>& before, const std::vector<double>& times,
                           const std::string& option);
/// Adds --before.
void declareBefore(CLI::App& command, std::vector<double>& before);

struct RenderTarget {
  std::string target; ///< ID of an assignment or part, or a folder of files
  std::string scene;  ///< file; empty: the assignment's scene.json with the part's effects
  Size size;          ///< 0: the scene's
  grading::Moments times = {0};
  bool solution = false;     ///< an ID stands for the reference
  trace::Request trace = {}; ///< what to record of the passes
  std::string folder = {};   ///< with an ID: these files over the assignment's own
};

/// Builds the target and renders its frames. A folder may be a stranger's: it is built and run in
/// the sandbox; an ID names this tree's own files. Throws UsageError for what can't be rendered,
/// ends the command when a sandbox is needed and there is none.
grading::Rendering renderTarget(const RenderTarget& what, Progress& progress);

} // namespace ggrade::cli
