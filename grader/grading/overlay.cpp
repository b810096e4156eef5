#include "grading/overlay.hpp"

#include "words/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <fstream>

#include <fcntl.h>
#include <fnmatch.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ggrade::grading {

namespace fs = std::filesystem;
using gg::say;

namespace {

/// Reads one uploaded file without following a link or waiting on a FIFO. Returns why not, or "".
std::string readUploaded(const fs::path& path, std::string& content) {
  const int fd = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (fd < 0) return errno == ELOOP ? say("a link") : say("can't be read");
  struct stat status = {};
  std::string reason;
  if (fstat(fd, &status) != 0 || !S_ISREG(status.st_mode)) {
    reason = say("not a regular file");
  } else if (std::uintmax_t(status.st_size) > kLargestSource) {
    reason = say("larger than {} KiB", kLargestSource / 1024);
  } else {
    content.resize(kLargestSource + 1);
    std::size_t length = 0;
    for (ssize_t got; length < content.size() &&
                      (got = read(fd, content.data() + length, content.size() - length)) > 0;)
      length += std::size_t(got);
    content.resize(std::min<std::size_t>(length, kLargestSource));
  }
  close(fd);
  return reason;
}

void writeFile(const fs::path& path, const std::string& content) {
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  if (!(out << content) || !out.flush())
    throw UsageError(fmt::format("can't write {}: is the disk full?", path.string()));
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
    writeFile(into / name, readFile(assignment.folder / name));
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
    writeFile(into / name, content);
    result.used.push_back(name);
  }
  if (result.used.empty())
    throw NothingToGrade(say("{} holds no file of {}: expected {}", upload.string(), assignment.id,
                             fmt::format("{}", fmt::join(assignment.files, ", "))));
  for (const std::string& name : assignment.files) {
    if (has(result.used, name)) continue;
    writeFile(into / name, readFile(assignment.folder / name));
    result.missing.push_back(name);
  }
  return result;
}

} // namespace ggrade::grading
