#include "calibration/adopt.hpp"

#include "grading/catalogue.hpp"
#include "grading/overlay.hpp"
#include "grading/recipe.hpp"
#include "grading/workspace.hpp"
#include "report/text.hpp"
#include "sandbox/sandbox.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>

namespace ggrade::calibration {

namespace fs = std::filesystem;

namespace {

/// What diff says of two files, without their paths; empty if they are equal.
std::string difference(const fs::path& before, const fs::path& after) {
  sandbox::Command command;
  const auto orNothing = [](const fs::path& file) {
    return fs::exists(file) ? file.string() : std::string("/dev/null");
  };
  // One line of context: two patches of the catalogue then apply together more often.
  command.arguments = {"/usr/bin/diff", "-U1",   "--text", "--label",         "before",
                       "--label",       "after", "--",     orNothing(before), orNothing(after)};
  command.workingDirectory = "/";
  command.limits.outputBytes = 4 * grading::kLargestSource;
  const sandbox::Result run =
      sandbox::run(command, sandbox::Isolation::none, &grading::interrupted);
  if (run.end == sandbox::End::interrupted) throw grading::Interrupted{};
  if (run.end != sandbox::End::exited || run.exitCode > 1 || run.outputTruncated)
    throw UsageError(fmt::format("can't compare {} with {}: {}{}", after.string(), before.string(),
                                 run.standardError, run.detail));
  const std::size_t hunks = run.standardOutput.find("@@");
  return hunks == std::string::npos ? std::string() : run.standardOutput.substr(hunks);
}

/// The patch from the solution's files to the submission's.
std::string patchOf(const Assignment& assignment, const fs::path& solutionFolder,
                    const fs::path& overlaid) {
  std::set<std::string> names;
  for (const std::string& name : grading::ownFiles(assignment, solutionFolder)) names.insert(name);
  for (const std::string& name : grading::ownFiles(assignment, overlaid)) names.insert(name);
  std::string patch;
  for (const std::string& name : names) {
    const std::string hunks = difference(solutionFolder / name, overlaid / name);
    if (hunks.empty()) continue;
    const std::string path = "solutions/" + assignment.id + '/' + name;
    const bool isNew = !fs::exists(solutionFolder / name), isGone = !fs::exists(overlaid / name);
    patch += fmt::format("diff --git a/{0} b/{0}\n", path);
    if (isNew) patch += "new file mode 100644\n";
    if (isGone) patch += "deleted file mode 100644\n";
    patch += isNew ? "--- /dev/null\n" : fmt::format("--- a/{}\n", path);
    patch += isGone ? "+++ /dev/null\n" : fmt::format("+++ b/{}\n", path);
    patch += hunks;
  }
  return patch;
}

/// Share of its points that an item lost.
double lossOf(const results::Item& item) {
  if (item.points <= 0) return 0;
  return (item.kind == results::ItemKind::keep ? -item.earned : item.points - item.earned) /
         item.points;
}

std::string headerOf(const Part& part, const fs::path& solutionFolder, AdoptAs as,
                     const std::vector<results::Item>& items) {
  if (as == AdoptAs::variant)
    return fmt::format("Title: A right answer in other words\nGrades: {}\n", part.id);
  // The item that lost most, a required one if there is any.
  const ItemDeclaration* fails = &part.items.at(0);
  double most = -1;
  for (const ItemDeclaration& declared : part.items)
    for (const results::Item& item : items)
      if (item.id == declared.id && item.kind != results::ItemKind::bonus && lossOf(item) > most) {
        most = lossOf(item);
        fails = &declared;
      }
  std::string tag;
  if (!fails->scenes.empty()) {
    tag = fails->scenes[0];
  } else {
    const nlohmann::json scenes = readJson(solutionFolder / "scenes.json");
    for (const auto& scene : scenes.at("scenes"))
      if (tag.empty() && scene.value("parts", nlohmann::json()) == nlohmann::json{part.id} &&
          scene.contains("tags"))
        tag = scene["tags"].at(0);
  }
  return fmt::format("Title: A mistake that was disputed\nGrades: {}\nSymptom: {}: not so here.\n"
                     "Hint: {}\nFails: {}\nStep: {}\nShows: {}\n",
                     part.id, fails->title, fails->cause, fails->id, fails->step, tag);
}

fs::path freePath(const fs::path& folder, const std::string& part, const std::string& name) {
  const auto pathOf = [&](const std::string& one) {
    return folder / fmt::format("{}_{}.patch", part, one);
  };
  if (name.empty()) {
    for (int i = 1;; ++i)
      if (const fs::path path = pathOf(fmt::format("disputed_{}", i)); !fs::exists(path))
        return path;
  }
  if (name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != name.npos)
    throw UsageError(fmt::format("--name {}: use small letters, digits and _", name));
  if (fs::exists(pathOf(name)))
    throw UsageError(
        fmt::format("{} is there already: choose another --name", pathOf(name).string()));
  return pathOf(name);
}

} // namespace

fs::path adopt(const Target& target, const fs::path& solutionFolder, const fs::path& catalogue,
               const fs::path& submission, AdoptAs as, const std::string& name,
               const std::vector<results::Item>& items) {
  const Assignment& assignment = target.assignment;
  if (target.parts.size() != 1)
    throw UsageError(
        fmt::format("{} has several parts: say which one the submission answers", target.id));
  const Part& part = target.parts[0];
  grading::TemporaryFolder work;
  const fs::path overlaid = work.makeVisible("overlaid");
  grading::overlay(assignment, submission, overlaid);
  const std::string diff = patchOf(assignment, solutionFolder, overlaid);
  if (diff.empty())
    throw UsageError(
        fmt::format("{} is the solution itself: there is nothing to adopt", submission.string()));
  const fs::path folder = catalogue / (as == AdoptAs::mistake ? "mistakes" : "variants");
  const fs::path path = freePath(folder, part.id, name);
  const fs::path made = work.path() / "made.patch";
  {
    std::ofstream out(made, std::ios::binary);
    if (!(out << headerOf(part, solutionFolder, as, items) << '\n' << diff) || !out.flush())
      throw UsageError(fmt::format("can't write {}: is the disk full?", made.string()));
  }
  // What was written must give back what was handed in.
  grading::writeFiles(assignment, {solutionFolder, {made}}, work.path() / "again");
  for (const std::string& file : grading::ownFiles(assignment, overlaid))
    if (readFile(work.path() / "again" / file) != readFile(overlaid / file))
      throw std::runtime_error(fmt::format("the patch doesn't give back {}", file));
  fs::create_directories(folder);
  fs::copy_file(made, path);
  return path;
}

} // namespace ggrade::calibration
