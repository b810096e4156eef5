#include "helper.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <grp.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>

namespace ggrade::sandbox::helper {
namespace {

/// Makes the sources of all mounts reachable for a uid that may not enter the folders above them
/// (a clone in /root, say). Only this process and bwrap see the result. Returns what went wrong.
std::string stageMounts(const HelperPlan& plan) {
  const auto error = [](const std::string& text) { return text + ": " + std::strerror(errno); };
  if (unshare(CLONE_NEWNS) != 0) return error("cannot make a mount namespace");
  if (mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0)
    return error("cannot make the mounts private");
  // The sources are picked up before the stage covers its folder: they may lie below it.
  std::vector<int> trees;
  for (const std::string& path : plan.staged) {
    trees.push_back(open_tree(AT_FDCWD, path.c_str(), OPEN_TREE_CLONE | OPEN_TREE_CLOEXEC));
    if (trees.back() < 0) return error("cannot mount " + path);
  }
  if (mount("tmpfs", kStage, "tmpfs", MS_NOSUID | MS_NODEV, "mode=0755,size=1M") != 0)
    return error(std::string("cannot mount a tmpfs on ") + kStage);
  for (std::size_t i = 0; i < trees.size(); ++i) {
    const std::string place = std::string(kStage) + "/" + std::to_string(i);
    struct stat status {};
    if (fstat(trees[i], &status) != 0) return error("cannot examine " + plan.staged[i]);
    const bool isFolder = S_ISDIR(status.st_mode);
    const int made = isFolder ? mkdir(place.c_str(), 0755)
                              : open(place.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0644);
    if (made < 0) return error("cannot make " + place);
    if (!isFolder) close(made);
    if (move_mount(trees[i], "", AT_FDCWD, place.c_str(), MOVE_MOUNT_F_EMPTY_PATH) != 0)
      return error("cannot mount " + plan.staged[i] + " on the stage");
    close(trees[i]);
  }
  return {};
}

/// Becomes `plan.uid` for good. Raw calls are not needed: this process has one thread.
std::string becomeWorker(const HelperPlan& plan) {
  const auto id = static_cast<uid_t>(plan.uid);
  if (setgroups(0, nullptr) != 0 || setresgid(id, id, id) != 0 || setresuid(id, id, id) != 0)
    return "cannot become uid " + std::to_string(plan.uid) + ": " + std::strerror(errno);
  for (std::size_t i = 0; i < plan.staged.size(); ++i) {
    const std::string place = std::string(kStage) + "/" + std::to_string(i);
    struct stat status {};
    const bool isFolder = stat(place.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
    if (access(place.c_str(), isFolder ? R_OK | X_OK : R_OK) != 0)
      return "the sandbox's user may not read " + plan.staged[i] + ": " + std::strerror(errno) +
             " (remedy: chmod -R go+rX " + plan.staged[i] + ")";
  }
  return {};
}

/// Closes what the caller left open: descriptors without close-on-exec belong to somebody else.
void closeAllBut(std::vector<std::int64_t> kept) {
  std::sort(kept.begin(), kept.end());
  unsigned next = 3;
  for (const std::int64_t number : kept) {
    if (number < 3) continue;
    const auto keep = static_cast<unsigned>(number);
    if (keep > next) close_range(next, keep - 1, 0);
    next = std::max(next, keep + 1);
  }
  close_range(next, ~0u, 0);
}

} // namespace

int runOutside(const HelperPlan& plan) {
  const auto fail = [&](const std::string& text) {
    report(plan, HelperReport::Kind::failed, text);
    return 1;
  };
  closeAllBut(plan.kept);
  // If memory runs out all the same, the kernel should end the submission and not the host's work.
  if (const int file = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC); file >= 0) {
    (void)!write(file, "1000", 4);
    close(file);
  }
  if (plan.uid >= 0) {
    if (const std::string error = stageMounts(plan); !error.empty()) return fail(error);
    if (const std::string error = becomeWorker(plan); !error.empty()) return fail(error);
    // Nobody else has this uid now (see WorkerUid): whatever does is left of a run whose tool was
    // killed, such as a bwrap that waits for its dead parent. The kernel leaves out who asks.
    kill(-1, SIGKILL);
  }
  // After the change of uid, which clears it. The supervisor may have died before it was set.
  if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || getppid() != plan.parent) return 1;
  if (plan.bwrap.empty()) return runInside(plan);
  // Also disarms a bwrap that is installed setuid: it must not hold more rights than we do.
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return fail("cannot set no_new_privs");
  const std::string arguments = std::to_string(plan.bwrapArguments);
  // The plan is kept under the first number of `kept`.
  const std::string planNumber = std::to_string(plan.kept.front());
  const char* argv[] = {"bwrap",       "--args", arguments.c_str(),  "--",
                        kHelperInside, "inside", planNumber.c_str(), nullptr};
  const char* environment[] = {nullptr};
  execve(plan.bwrap.c_str(), const_cast<char**>(argv), const_cast<char**>(environment));
  return fail("cannot start " + plan.bwrap + ": " + std::strerror(errno));
}

} // namespace ggrade::sandbox::helper
