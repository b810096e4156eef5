#include "grading/workspace.hpp"

#include "assignment/assignment.hpp"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>

namespace ggrade::grading {

namespace fs = std::filesystem;

std::atomic<bool> interrupted{false};

void catchInterrupts() {
  struct sigaction action = {};
  action.sa_handler = [](int) { interrupted = true; };
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  signal(SIGPIPE, SIG_IGN);
}

void requireReplaceable(const fs::path& folder, const std::string& marker) {
  std::error_code none;
  if (!fs::exists(folder, none)) return;
  if (!fs::is_directory(folder, none))
    throw UsageError(
        fmt::format("{} is not a folder: name another one with --out", folder.string()));
  if (!fs::is_empty(folder) && !fs::exists(folder / marker))
    throw UsageError(fmt::format("{} exists and holds no earlier result ({}): name another folder "
                                 "with --out, or remove it",
                                 folder.string(), marker));
}

TemporaryFolder::TemporaryFolder(const fs::path& parent) {
  std::error_code error;
  const fs::path base = parent.empty() ? fs::temp_directory_path() : parent;
  fs::create_directories(base, error);
  std::string name = (base / ".ggrade-XXXXXX").string();
  if (!mkdtemp(name.data()))
    throw UsageError(fmt::format("can't write to {}: {}. Name another folder with --out, or give "
                                 "yourself write permission",
                                 base.string(), std::strerror(errno)));
  path_ = name;
  // The sandbox reads from here under another user ID.
  fs::permissions(path_, fs::perms(0755));
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code none;
  if (!path_.empty()) fs::remove_all(path_, none);
}

void TemporaryFolder::publish(const fs::path& final, const std::string& marker) {
  // One step either way: exchanged with an earlier result, or moved into place.
  requireReplaceable(final, marker);
  if (fs::exists(final)) {
    if (renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, final.c_str(), RENAME_EXCHANGE) == 0) return;
    fs::remove_all(final); // a file system that can't exchange
  }
  fs::rename(path_, final);
  path_.clear();
}

} // namespace ggrade::grading
