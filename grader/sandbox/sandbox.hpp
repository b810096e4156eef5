#pragma once
/// \file
/// Runs one untrusted command, isolated and limited, and says how it ended.

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ggrade::sandbox {

/// How much separation a run gets.
enum class Isolation {
  bwrap, ///< bubblewrap, an unused uid as root, seccomp, limits
  none   ///< limits only; for trusted programs (our own references), said in every result
};

/// A file or folder of the host that the command sees, read-only.
struct Mount {
  std::filesystem::path host;
  std::filesystem::path inside; ///< absolute
};

/// All limits hold for the command and everything that it starts, together.
struct Limits {
  double wallSeconds = 10;
  double cpuSeconds = 20;
  std::uint64_t memoryBytes = 1536ull << 20;       ///< resident memory of the whole tree
  std::uint64_t addressSpaceBytes = 4096ull << 20; ///< a process (RLIMIT_AS)
  std::uint64_t fileBytes = 64ull << 20;           ///< largest file (RLIMIT_FSIZE)
  std::uint64_t scratchBytes = 64ull << 20;        ///< size of each writable tmpfs
  std::uint32_t processes = 64;                    ///< processes and threads (RLIMIT_NPROC)
  std::uint64_t outputBytes =
      1ull << 20; ///< kept of stdout and of stderr, each; the rest is read and dropped
};

/// What to run. The command starts with an empty environment but for `environment`, in `/scratch`
/// (a private tmpfs) unless `workingDirectory` says otherwise. Besides `mounts` it sees /usr
/// (read-only), a minimal /etc, /dev and /proc of its own, and nothing else of the host.
struct Command {
  std::vector<std::string> arguments; ///< arguments[0] is an absolute path inside
  std::vector<std::pair<std::string, std::string>> environment;
  std::vector<Mount> mounts;
  std::vector<Mount>
      privateCopies; ///< folders copied into a tmpfs of the run's own, writable, discarded
  std::filesystem::path workingDirectory = "/scratch";
  int inheritedDescriptor = -1; ///< kept open, same number, in the command (the capture channel)
  /// After a successful exit this file inside is written to `collectInto` on the host, capped by
  /// `limits.fileBytes`. Empty: nothing is collected.
  std::filesystem::path collect;
  std::filesystem::path collectInto;
  Limits limits;
};

/// How a run ended. Exactly one holds.
enum class End {
  exited,      ///< `exitCode` says how
  signalled,   ///< `signal` says which
  timeLimit,   ///< wall or CPU time
  memoryLimit, ///< the tree's memory
  interrupted, ///< `cancel` was set
  setupFailed  ///< our fault: the command never started; `detail` says why
};

struct Result {
  End end = End::setupFailed;
  int exitCode = -1;
  int signal = 0;
  double wallSeconds = 0;
  double cpuSeconds = 0;
  std::uint64_t peakMemoryBytes = 0;
  std::string standardOutput; ///< raw bytes, capped
  std::string standardError;  ///< raw bytes, capped
  bool outputTruncated = false;
  bool collected = false;     ///< `collectInto` was written
  std::string collectProblem; ///< why it was not, after a successful exit
  std::string detail;         ///< one sentence with the limit and the value that met it
};

/// Runs `command` to its end. Never throws for what the command does. When `cancel` becomes true
/// the whole tree is killed within 0.1 s and the result says `interrupted`.
Result run(const Command& command, Isolation isolation, const std::atomic<bool>* cancel = nullptr);

/// Tries the sandbox once. Empty when it holds; otherwise one sentence with the remedy
/// (for example: AppArmor on Ubuntu 24.04 stops bwrap).
std::optional<std::string> unavailable();

} // namespace ggrade::sandbox
