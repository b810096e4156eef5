#include "grading/workspace.hpp"

#include "assignment/assignment.hpp"
#include "report/write_file.hpp"
#include "words/words.hpp"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <set>
#include <sstream>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

namespace ggrade::grading {

namespace fs = std::filesystem;

std::atomic<bool> interrupted{false};

void catchInterrupts() {
  struct sigaction action = {};
  action.sa_handler = [](int) { interrupted = true; };
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGHUP, &action, nullptr);
  signal(SIGPIPE, SIG_IGN);
}

namespace {

/// Lists, a name a line, what the tool wrote into a folder that it published.
constexpr char kContents[] = ".ggrade-contents";

std::set<std::string> namesIn(const fs::path& folder) {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

} // namespace

void refuseForeign(const fs::path& folder, const std::string& name) {
  throw UsageError(gg::say("{} holds {}, which is no earlier result of this tool: name another "
                           "folder with --out, or move it away",
                           folder.string(), name));
}

void requireReplaceable(const fs::path& folder) {
  std::error_code none;
  if (!fs::exists(folder, none)) return;
  if (!fs::is_directory(folder, none))
    throw UsageError(gg::say("{} is not a folder: name another one with --out", folder.string()));
  std::set<std::string> ours = {kContents};
  std::istringstream in(fs::exists(folder / kContents) ? readFile(folder / kContents) : "");
  for (std::string name; std::getline(in, name);) ours.insert(name);
  for (const std::string& name : namesIn(folder))
    if (!ours.count(name)) refuseForeign(folder, name);
}

TemporaryFolder::TemporaryFolder(const fs::path& parent, const char* remedy) {
  std::error_code error;
  const fs::path base = parent.empty() ? fs::temp_directory_path() : parent;
  fs::create_directories(base, error);
  std::string name = (base / (std::string(kTemporaryMark) + "XXXXXX")).string();
  if (!error && !mkdtemp(name.data())) error.assign(errno, std::generic_category());
  if (error)
    throw UsageError(
        gg::say("can't write to {}: {}. {}", base.string(), error.message(), gg::words(remedy)));
  path_ = name;
}

fs::path TemporaryFolder::makeVisible(const std::string& name) const {
  const fs::path folder = path_ / name;
  fs::create_directory(folder);
  fs::permissions(folder, fs::perms(0755));
  return folder;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code none;
  if (!path_.empty()) fs::remove_all(path_, none);
}

void TemporaryFolder::publish(const fs::path& final) {
  requireReplaceable(final);
  std::string contents;
  for (const std::string& name : namesIn(path_)) contents += name + '\n';
  report::writeFile(path_ / kContents, contents);
  const mode_t mask = umask(0);
  umask(mask);
  fs::permissions(path_, fs::perms(0777 & ~mask));
  // One step either way: exchanged with an earlier result, or moved into place.
  if (fs::exists(final)) {
    if (renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, final.c_str(), RENAME_EXCHANGE) == 0) return;
    fs::remove_all(final); // a file system that can't exchange
  }
  fs::rename(path_, final);
  path_.clear();
}

FileLock::FileLock(const fs::path& file)
    : lock_(open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
  while (lock_ >= 0 && flock(lock_, LOCK_EX) != 0 && errno == EINTR)
    if (interrupted) {
      close(lock_);
      throw Interrupted{};
    }
}

FileLock::~FileLock() {
  if (lock_ >= 0) close(lock_);
}

} // namespace ggrade::grading
