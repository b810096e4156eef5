#include "cli/rendering.hpp"

#include "assignment/assignment.hpp"
#include "cli/commands.hpp"
#include "grading/overlay.hpp"
#include "grading/scenes.hpp"
#include "grading/store.hpp"
#include "words/words.hpp"

#include <cmath>
#include <cstdio>
#include <optional>

namespace ggrade::cli {

namespace fs = std::filesystem;
using gg::say;
using nlohmann::json;
using sandbox::Isolation;

namespace {

/// Which assignment a folder of files belongs to: the one whose program it holds.
Target targetOf(const std::string& named) {
  const fs::path folder = named;
  if (!fs::is_directory(folder)) return findTarget(assignmentsFolder(), named);
  for (Assignment& assignment : loadAssignments(assignmentsFolder()))
    if (fs::exists(folder / (assignment.id + ".cpp")))
      return findTarget(assignmentsFolder(), assignment.id);
  throw UsageError(
      say("{0} holds no assignment's program, ID.cpp. To take what it lacks from the "
          "handed-out files, name the assignment or part before it (see ggrade list): mirror {0}",
          named));
}

} // namespace

Size parseSize(const std::string& text) {
  if (text.empty()) return {};
  // Wide enough that a number which is too large stays one.
  unsigned long long width = 0, height = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%llux%llu%c", &width, &height, &rest) != 2 || width < 1 ||
      height < 1 || width > channel::kMaxSide || height > channel::kMaxSide)
    throw UsageError(say("--size {}: must be WIDTHxHEIGHT, such as 640x480, each 1 to {}", text,
                         channel::kMaxSide));
  return {std::uint32_t(width), std::uint32_t(height)};
}

namespace {

void checkTimes(const std::vector<double>& times, const std::string& option) {
  for (double time : times)
    if (!std::isfinite(time) || time < 0)
      throw UsageError(say("{} {}: a time is a number of seconds from 0", option, time));
  if (times.size() > channel::kMaxFrames)
    throw UsageError(say("{}: {} frames are more than {}: render them in parts", option,
                         times.size(), channel::kMaxFrames));
}

} // namespace

grading::Moments momentsOf(const std::vector<double>& before, const std::vector<double>& times,
                           const std::string& option) {
  checkTimes(times, option);
  checkTimes(before, "--before");
  grading::Moments moments(times);
  for (const double seconds : before) {
    moments.before.push_back({seconds});
    if (times.at(0) - seconds < 0)
      throw UsageError(say("--before {}: {} {} is less than that after the beginning", seconds,
                           option, times.at(0)));
  }
  if (moments.frames() > channel::kMaxFrames)
    throw UsageError(say("{} and --before: {} frames are more than {}", option, moments.frames(),
                         channel::kMaxFrames));
  return moments;
}

void declareBefore(CLI::App& command, std::vector<double>& before) {
  command
      .add_option("--before", before,
                  say("Frames to draw before, of which nothing is kept: so many seconds "
                      "earlier than the first, separated by commas"))
      ->delimiter(',');
}

grading::Rendering renderTarget(const RenderTarget& what, Progress& progress) {
  if (what.solution && !what.folder.empty())
    throw UsageError(say("name either a folder or --solution"));
  const Target target =
      what.folder.empty() ? targetOf(what.target) : findTarget(assignmentsFolder(), what.target);
  const std::string& id = target.assignment.id;
  const fs::path folder = what.folder.empty() ? what.target : what.folder;
  const bool upload = fs::is_directory(folder);
  if (!what.folder.empty() && !upload)
    throw UsageError(say("{} is not a folder of files", what.folder));
  // With an ID the folder may hold what was changed alone, as for `check`.
  std::optional<grading::TemporaryFolder> whole;
  if (!what.folder.empty()) grading::overlay(target.assignment, folder, whole.emplace().path());
  const fs::path sources = whole           ? whole->path()
                           : upload        ? folder
                           : what.solution ? solutionFolder(id)
                                           : target.assignment.folder;
  const Isolation isolation = upload ? Isolation::bwrap : Isolation::none;
  if (upload) requireSandbox();

  json scene = grading::readScene(target.assignment, what.scene.empty()
                                                         ? target.assignment.folder / "scene.json"
                                                         : fs::path(what.scene));
  if (what.scene.empty())
    for (const Part& part : target.parts) scene.merge_patch(part.scene);
  if (what.size.width) scene["size"] = {what.size.width, what.size.height};

  grading::Program program(target.assignment, {sources}, isolation,
                           upload ? grading::Program::Use::once : grading::Program::Use::often);
  program.files(); // what is missing is said before it takes time
  progress(say("building"), 0, 2);
  if (program.build().ok()) progress(say("rendering"), 1, 2);
  return program.render(scene, what.times, {}, what.trace);
}

} // namespace ggrade::cli
