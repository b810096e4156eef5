#include "grading/patched.hpp"

#include "grading/workspace.hpp"
#include "sandbox/sandbox.hpp"

#include <fmt/format.h>

#include <sstream>

namespace ggrade::grading {

namespace fs = std::filesystem;

std::map<std::string, std::string> patchHeader(const fs::path& patch) {
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
      header[key] = line.substr(colon + 2);
    } else {
      throw UsageError(
          fmt::format("{}:{}: expected \"Key: value\" before the diff", patch.string(), number));
    }
  }
  for (const char* needed : {"Title", "Grades", "Outcome"})
    if (!header.count(needed))
      throw UsageError(fmt::format("{}: its header lacks \"{}:\"", patch.string(), needed));
  return header;
}

void writePatched(const Assignment& assignment, const fs::path& solutionFolder,
                  const fs::path& patch, const fs::path& into) {
  fs::create_directories(into);
  // Everything at the top: the files that a patch may add go there, too.
  for (const std::string& file : assignment.files)
    fs::copy_file(solutionFolder / file, into / file);
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

} // namespace ggrade::grading
