#include "grading/overlay.hpp"

#include "report/write_file.hpp"
#include "sandbox/descriptor.hpp"
#include "words/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <system_error>

#include <fcntl.h>
#include <fnmatch.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ggrade::grading {

namespace fs = std::filesystem;
using gg::say;

namespace {

/// Reads one uploaded file without following a link or waiting on a FIFO. Returns what the file is
/// to blame for, or "". What the machine fails at is nobody's fault: throws std::system_error.
std::string readUploaded(const fs::path& path, std::string& content) {
  const sandbox::Descriptor file(
      open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (!file && errno == ELOOP) return say("a link");
  if (!file && (errno == ENXIO || errno == ENODEV)) return say("not a regular file"); // a socket
  if (!file && errno == EACCES) return say("can't be read");
  const auto fail = [&] {
    throw std::system_error(errno, std::generic_category(), say("can't read {}", path.string()));
  };
  struct stat status = {};
  if (!file || fstat(file.get(), &status) != 0) fail();
  if (!S_ISREG(status.st_mode)) return say("not a regular file");
  if (std::uintmax_t(status.st_size) > kLargestSource)
    return say("larger than {} KiB", kLargestSource / 1024);
  content.resize(kLargestSource + 1);
  std::size_t length = 0;
  while (length < content.size()) {
    const ssize_t got = read(file.get(), content.data() + length, content.size() - length);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail();
    if (got == 0) break;
    length += std::size_t(got);
  }
  content.resize(std::min<std::size_t>(length, kLargestSource));
  return {};
}

bool has(const std::vector<std::string>& list, const std::string& value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

} // namespace

bool isCompiled(const fs::path& file) {
  const std::string extension = file.extension();
  return extension == ".cpp" || extension == ".hpp" || extension == ".h";
}

bool takes(const Assignment& assignment, const std::string& name) {
  return has(assignment.files, name) ||
         std::any_of(assignment.optionalFiles.begin(), assignment.optionalFiles.end(),
                     [&](const std::string& pattern) {
                       return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
                     });
}

std::vector<std::string> ownFiles(const Assignment& assignment, const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const bool judges = name.starts_with("rubric") || name.starts_with("truth");
    if (entry.is_regular_file() && takes(assignment, name) && !judges) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

Overlay overlay(const Assignment& assignment, const fs::path& upload, const fs::path& into) {
  if (!fs::is_directory(upload))
    throw UsageError(
        say("{}: {}. Name the folder that holds {}", upload.string(),
            fs::exists(upload) ? say("is not a folder") : say("there is no such folder"),
            fmt::format("{}", fmt::join(assignment.files, ", "))));
  Overlay result;
  for (const std::string& name : assignment.dataFiles())
    report::writeFile(into / name, readFile(assignment.folder / name));
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(upload))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  // The assignment's own files first: what else is there must not crowd them out.
  const auto others =
      std::stable_partition(names.begin(), names.end(),
                            [&](const std::string& name) { return has(assignment.files, name); });
  if (const auto many = std::size_t(names.end() - others); many > kMostOtherFiles) {
    result.unused.push_back(
        say("{} more files: an upload may have {} beside those of the assignment",
            many - kMostOtherFiles, kMostOtherFiles));
    names.erase(others + kMostOtherFiles, names.end());
  }
  std::uintmax_t bytes = 0;
  for (const std::string& name : names) {
    if (!takes(assignment, name)) {
      // What was handed out beside the editable files comes back with them, and is no mistake.
      if (!fs::exists(assignment.folder / name))
        result.unused.push_back(say("{}: not a file of this assignment", name));
      continue;
    }
    std::string content;
    std::string reason = readUploaded(upload / name, content);
    if (reason.empty() && bytes + content.size() > kLargestUpload)
      reason = say("the files before it have {} MiB already", kLargestUpload >> 20);
    if (!reason.empty()) {
      result.unused.push_back(name + ": " + reason);
      continue;
    }
    bytes += content.size();
    report::writeFile(into / name, content);
    result.used.push_back(name);
  }
  if (result.used.empty())
    throw NothingToGrade(say("{} holds no file of {}: expected {}", upload.string(), assignment.id,
                             fmt::format("{}", fmt::join(assignment.files, ", "))));
  for (const std::string& name : assignment.files) {
    if (has(result.used, name)) continue;
    report::writeFile(into / name, readFile(assignment.folder / name));
    result.missing.push_back(name);
  }
  return result;
}

} // namespace ggrade::grading
