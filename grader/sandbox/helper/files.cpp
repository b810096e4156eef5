#include "helper.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

namespace ggrade::sandbox::helper {

std::string copyTree(const std::string& source, const std::string& destination) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::recursive_directory_iterator entries(source, error);
  for (; !error && entries != fs::recursive_directory_iterator(); entries.increment(error)) {
    const fs::path target = destination / entries->path().lexically_relative(source);
    if (entries->is_directory(error))
      fs::create_directory(target, error);
    else if (entries->is_regular_file(error))
      fs::copy_file(entries->path(), target, error);
    else
      continue;
    if (!error) fs::permissions(target, fs::perms::owner_write, fs::perm_options::add, error);
    if (error) return "cannot copy to " + target.string() + ": " + error.message();
  }
  return error ? "cannot read " + source + ": " + error.message() : std::string();
}

namespace {

/// Opens without following a symlink anywhere and without waiting on a FIFO.
int openPlain(const std::string& path) {
  open_how how{};
  how.flags = O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY;
  how.resolve = RESOLVE_NO_SYMLINKS | RESOLVE_NO_MAGICLINKS;
  return static_cast<int>(syscall(SYS_openat2, AT_FDCWD, path.c_str(), &how, sizeof how));
}

/// What the caller's disk refuses is no fault of the command's.
constexpr char kNotStored[] = "cannot be stored: ";

std::string copyOut(int from, int into, std::uint64_t limit) {
  std::uint64_t total = 0;
  static char block[1 << 16];
  for (;;) {
    const ssize_t count = read(from, block, sizeof block);
    if (count == 0) return {};
    if (count < 0) return std::string("cannot be read: ") + std::strerror(errno);
    total += static_cast<std::uint64_t>(count);
    if (total > limit) return "is larger than " + std::to_string(limit) + " bytes";
    for (ssize_t done = 0; done < count;) {
      const ssize_t written = write(into, block + done, static_cast<std::size_t>(count - done));
      if (written < 0) return kNotStored + std::string(std::strerror(errno));
      done += written;
    }
  }
}

} // namespace

void collect(const HelperPlan& plan) {
  // Everything else inside is dead by now: no file can change under us.
  std::int32_t executable = 0;
  const auto copyFile = [&](std::size_t n) -> std::string {
    const int file = openPlain(plan.collect[n]);
    if (file < 0 && errno == ELOOP) return "is reached through a symbolic link";
    if (file < 0) return std::string("cannot be opened: ") + std::strerror(errno);
    struct stat status {};
    if (fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) return "is not a regular file";
    if (static_cast<std::uint64_t>(status.st_size) > plan.collectLimit)
      return "has " + std::to_string(status.st_size) + " bytes, the limit is " +
             std::to_string(plan.collectLimit);
    if (status.st_mode & S_IXUSR) executable |= 1 << n;
    return copyOut(file, static_cast<int>(plan.collectInto[n]), plan.collectLimit);
  };
  for (std::size_t n = 0; n < plan.collect.size(); ++n)
    if (const std::string problem = copyFile(n); !problem.empty())
      return report(plan, HelperReport::Kind::notCollected, plan.collect[n] + " " + problem, 0,
                    problem.starts_with(kNotStored));
  report(plan, HelperReport::Kind::collected, "", 0, executable);
}

} // namespace ggrade::sandbox::helper
