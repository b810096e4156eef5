#include "grading/recipe.hpp"

#include "authoring/solution_blocks.hpp"
#include "grading/overlay.hpp"
#include "grading/workspace.hpp"
#include "sandbox/sandbox.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

namespace ggrade::grading {

namespace fs = std::filesystem;

std::map<std::string, std::string> patchHeader(const fs::path& patch,
                                               const std::vector<std::string>& needed) {
  std::istringstream in(readFile(patch));
  std::map<std::string, std::string> header;
  std::string key;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line) && !line.starts_with("diff --git");) {
    ++number;
    if (line.empty()) continue;
    const std::size_t colon = line.find(": ");
    if (line[0] == ' ' && !key.empty()) {
      header[key] += ' ' + line.substr(line.find_first_not_of(' '));
    } else if (colon != line.npos) {
      key = line.substr(0, colon);
      if (!header.emplace(key, line.substr(colon + 2)).second)
        throw UsageError(
            fmt::format("{}:{}: \"{}:\" stands there twice", patch.string(), number, key));
    } else {
      throw UsageError(
          fmt::format("{}:{}: expected \"Key: value\" before the diff", patch.string(), number));
    }
  }
  for (const std::string& one : needed)
    if (!header.count(one) || header[one].empty())
      throw UsageError(fmt::format("{}: its header lacks \"{}:\"", patch.string(), one));
  return header;
}

std::vector<std::string> patchedFiles(const Assignment& assignment, const fs::path& patch) {
  const std::string folder = "solutions/" + assignment.id + '/';
  std::vector<std::string> names;
  std::istringstream in(readFile(patch));
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("diff --git ")) continue;
    const std::string path = line.substr(line.rfind(' ') + 1);
    if (!path.starts_with("b/" + folder) || path.find('/', folder.size() + 2) != path.npos)
      throw UsageError(fmt::format("{}: \"{}\" is no file of {}: make it with git diff from the "
                                   "repository's root",
                                   patch.string(), line, folder));
    names.push_back(path.substr(folder.size() + 2));
  }
  return names;
}

namespace {

void applyPatch(const fs::path& patch, const fs::path& solutionFolder, const fs::path& into) {
  sandbox::Command command;
  // -p3 takes off a/solutions/<id>/.
  command.arguments = {"/usr/bin/patch",
                       "-p3",
                       "-F0",
                       "-s",
                       "-f",
                       "--no-backup-if-mismatch",
                       "-i",
                       fs::absolute(patch).string()};
  command.workingDirectory = into;
  const sandbox::Result run = sandbox::run(command, sandbox::Isolation::none, &interrupted);
  if (run.end == sandbox::End::interrupted) throw Interrupted{};
  if (run.end != sandbox::End::exited || run.exitCode != 0)
    throw UsageError(fmt::format("{} no longer applies to {}: {}{}", patch.string(),
                                 solutionFolder.string(), run.standardOutput, run.detail));
}

} // namespace

void writeFiles(const Assignment& assignment, const Recipe& recipe, const fs::path& into) {
  fs::create_directories(into);
  // Everything at the top: the files that a patch may add go there, too.
  for (const std::string& file : ownFiles(assignment, recipe.folder))
    fs::copy_file(recipe.folder / file, into / file);
  for (const fs::path& patch : recipe.patches) applyPatch(patch, recipe.folder, into);
  if (!recipe.filled) return;
  for (const std::string& file : assignment.files) {
    const std::string text =
        authoring::withFilled(readFile(into / file), (into / file).string(), *recipe.filled);
    if (!(std::ofstream(into / file, std::ios::binary) << text).flush())
      throw UsageError(fmt::format("can't write {}: is the disk full?", (into / file).string()));
  }
}

} // namespace ggrade::grading
