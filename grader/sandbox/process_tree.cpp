#include "process_tree.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <dirent.h>
#include <fcntl.h>
#include <memory>
#include <string_view>
#include <sys/vfs.h>

namespace ggrade::sandbox {
namespace {

/// Kernel memory of a tmpfs file beyond its contents: without it, millions of empty files look
/// free.
constexpr std::uint64_t kInodeBytes = 1024;

/// So often is a tree walked that changes meanwhile.
constexpr int kPasses = 3;

/// So many lists of threads' children are kept open; a run of ours has three threads.
constexpr std::size_t kMostKept = 16;

Descriptor openAt(int folder, const std::string& path) {
  return Descriptor(openat(folder, path.c_str(), O_RDONLY | O_CLOEXEC));
}

/// A file of /proc as it is now, as far as it fits: of the children of one thread more than limits
/// allow. Empty if it isn't open.
std::string textOf(const Descriptor& file) {
  std::string text(4096, '\0');
  const ssize_t count = pread(file.get(), text.data(), text.size(), 0);
  text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  return text;
}

/// The number behind `key` in /proc/PID/status, in bytes.
std::uint64_t kilobytes(std::string_view status, std::string_view key) {
  std::size_t at = status.find(key);
  if (at == std::string_view::npos) return 0;
  at = status.find_first_of("0123456789", at + key.size());
  std::uint64_t value = 0;
  if (at != std::string_view::npos)
    std::from_chars(status.data() + at, status.data() + status.size(), value);
  return value * 1024;
}

/// Fields 14 to 17 of /proc/PID/stat: utime, stime, cutime, cstime.
double processorSeconds(std::string_view stat) {
  // The name in parentheses is the program's choice and may hold anything.
  std::size_t at = stat.rfind(')');
  if (at == std::string_view::npos) return 0;
  double ticks = 0;
  for (int field = 3; field <= 17; ++field) {
    at = stat.find(' ', at);
    if (at == std::string_view::npos) return 0;
    ++at;
    std::uint64_t value = 0;
    if (field >= 14 &&
        std::from_chars(stat.data() + at, stat.data() + stat.size(), value).ec == std::errc{})
      ticks += static_cast<double>(value);
  }
  static const double perSecond = static_cast<double>(sysconf(_SC_CLK_TCK));
  return ticks / perSecond;
}

/// Adds one process. `sharedToo`: count shared memory; inside a namespace that is only files of a
/// tmpfs, which are counted there, and what the supervisor passed in. False when it is gone.
bool addProcess(Usage& usage, int proc, const std::string& pid, bool sharedToo) {
  const std::string status = textOf(openAt(proc, pid + "/status"));
  if (status.empty()) return false;
  ++usage.processes;
  for (const char* key : {"\nRssAnon:", "\nVmSwap:", "\nVmPTE:", "\nHugetlbPages:"})
    usage.memoryBytes += kilobytes(status, key);
  if (sharedToo) usage.memoryBytes += kilobytes(status, "\nRssShmem:");
  usage.cpuSeconds += processorSeconds(textOf(openAt(proc, pid + "/stat")));
  return true;
}

struct CloseFolder {
  void operator()(DIR* folder) const { closedir(folder); }
};

} // namespace

bool ProcessTree::openNamespace(pid_t pid, const std::vector<std::string>& writableFolders) {
  const std::string root = "/proc/" + std::to_string(pid) + "/root";
  root_ = 0;
  folders_.clear();
  for (const std::string& folder : writableFolders) {
    folders_.emplace_back(open((root + folder).c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    if (!folders_.back()) return false;
  }
  root_ = pid;
  inNamespace_ = true;
  return true;
}

void ProcessTree::addFolders(Usage& usage) const {
  for (const Descriptor& folder : folders_) {
    struct statfs status {};
    if (fstatfs(folder.get(), &status) != 0) continue;
    usage.memoryBytes +=
        (status.f_blocks - status.f_bfree) * static_cast<std::uint64_t>(status.f_bsize);
    usage.memoryBytes += (status.f_files - status.f_ffree) * kInodeBytes;
  }
}

/// A list that is opened anew each time is what a thread that ends takes out of the kernel's cache,
/// while the process that waits for its program spins until it has: of a run of half a second up to
/// a quarter of one. One that is open stays.
std::string ProcessTree::childrenOf(int proc, const std::string& thread) {
  auto kept = threads_.find(thread);
  if (kept == threads_.end()) {
    Descriptor file = openAt(proc, thread + "/children");
    if (!file || threads_.size() >= kMostKept) return textOf(file);
    kept = threads_.emplace(thread, Thread{std::move(file)}).first;
  }
  kept->second.isListed = true;
  return textOf(kept->second.children);
}

bool ProcessTree::addProcesses(Usage& usage) {
  const Descriptor proc(open("/proc", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  bool all = true;
  std::vector<std::string> waiting{std::to_string(root_)};
  while (!waiting.empty()) {
    const std::string pid = waiting.back();
    waiting.pop_back();
    if (!addProcess(usage, proc.get(), pid, !inNamespace_)) {
      all = false;
      continue;
    }
    const std::unique_ptr<DIR, CloseFolder> threads(
        fdopendir(openat(proc.get(), (pid + "/task").c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)));
    while (const dirent* thread = threads ? readdir(threads.get()) : nullptr) {
      if (thread->d_name[0] == '.') continue;
      const std::string children = childrenOf(proc.get(), pid + "/task/" + thread->d_name);
      for (std::size_t at = 0, space = 0; (space = children.find(' ', at)) != std::string::npos;
           at = space + 1)
        waiting.push_back(children.substr(at, space - at));
    }
  }
  return all;
}

Usage ProcessTree::measure() {
  Usage most;
  if (root_ <= 0) return most;
  for (auto& [name, thread] : threads_) thread.isListed = false;
  // A process that ends hands its children to init, whose own were perhaps listed before.
  for (int pass = 0; pass < kPasses; ++pass) {
    Usage usage;
    const bool all = addProcesses(usage);
    most.memoryBytes = std::max(most.memoryBytes, usage.memoryBytes);
    most.cpuSeconds = std::max(most.cpuSeconds, usage.cpuSeconds);
    most.processes = std::max(most.processes, usage.processes);
    if (all) break;
  }
  // Another thread may get the number of one that is gone.
  std::erase_if(threads_, [](const auto& thread) { return !thread.second.isListed; });
  addFolders(most);
  return most;
}

} // namespace ggrade::sandbox
