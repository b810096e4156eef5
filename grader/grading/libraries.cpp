#include "grading/libraries.hpp"

#include "grading/toolchain.hpp"
#include "sandbox/descriptor.hpp"
#include "sandbox/sandbox.hpp"

#include <sstream>
#include <stdexcept>

#include <fcntl.h>

namespace ggrade::grading {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> list() {
  sandbox::Command command;
  command.arguments = {"/usr/bin/ldd", toolchain::kLinkedProgram};
  command.environment = {{"PATH", "/usr/bin:/bin"},
                         {"LC_ALL", "C.UTF-8"},
                         {"LD_LIBRARY_PATH", toolchain::kCaptureFolder}};
  command.workingDirectory = "/";
  const sandbox::Result run = sandbox::run(command, sandbox::Isolation::none);
  const auto fail = [&](const std::string& what) {
    throw std::runtime_error("the libraries of programs can't be listed: " + what);
  };
  if (run.end != sandbox::End::exited || run.exitCode != 0)
    fail(run.detail + run.standardOutput + run.standardError);
  std::vector<fs::path> files;
  std::istringstream lines(run.standardOutput);
  for (std::string line; std::getline(lines, line);) {
    // "name => path (address)", the loader as "path (address)", and the kernel's without a path.
    if (line.find("not found") != line.npos) fail(line);
    const std::size_t start = line.find('/'), end = line.rfind(" (");
    if (start == line.npos || end == line.npos || end < start) continue;
    const fs::path path = line.substr(start, end - start);
    if (path.parent_path() == toolchain::kCaptureFolder) continue;
    files.push_back(fs::canonical(path.parent_path()) / path.filename());
    const sandbox::Descriptor file(open(files.back().c_str(), O_RDONLY | O_CLOEXEC));
    if (!file) fail(files.back().string() + " can't be opened");
    posix_fadvise(file.get(), 0, 0, POSIX_FADV_WILLNEED);
  }
  if (files.empty()) fail(run.standardOutput);
  return files;
}

} // namespace

const std::vector<fs::path>& programLibraries() {
  static const std::vector<fs::path> files = list();
  return files;
}

} // namespace ggrade::grading
