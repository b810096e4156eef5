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
  /// Limits only, for trusted programs (our own references), said in every result. The command sees
  /// the host as it is: `mounts` must have equal paths inside and outside, `privateCopies` are
  /// refused, `workingDirectory` must exist, `processes` and `scratchBytes` do not hold. Nothing
  /// outlives the run.
  none
};

/// A file or folder of the host that the command sees, read-only. Mounts inside a mounted folder do
/// not come with it. As root the files must be readable for everybody, the folders above need not
/// be.
struct Mount {
  std::filesystem::path host;
  std::filesystem::path inside; ///< absolute; not one of the sandbox's own folders
};

/// A regular file inside, reached through no symbolic link, that is written to `into` on the host
/// (mode 0755 if executable, else 0644), if it has at most `limits.fileBytes`.
struct Collect {
  std::filesystem::path inside;
  std::filesystem::path into; ///< replaced in one step; untouched when nothing is collected
};

/// All limits hold for the command and everything that it starts, together, unless a comment says
/// otherwise. Memory and processor time are measured every 20 ms (memory every 5 ms above half of
/// its limit), so a run can overshoot by what it gets done in that time.
struct Limits {
  double wallSeconds = 10;
  double cpuSeconds = 20; ///< children that nobody waits for count only while they live
  std::uint64_t memoryBytes = 1536ull
                              << 20; ///< private memory, page tables, swap and files in memory
  std::uint64_t addressSpaceBytes = 4096ull << 20; ///< a process (RLIMIT_AS)
  std::uint64_t fileBytes = 64ull << 20;           ///< largest file (RLIMIT_FSIZE)
  std::uint64_t scratchBytes = 64ull << 20;        ///< size of each writable tmpfs
  std::uint32_t processes = 64;                    ///< processes and threads (RLIMIT_NPROC)
  std::uint64_t outputBytes =
      1ull << 20; ///< kept of stdout and of stderr, each; the rest is read and dropped
};

/// What to run. The command starts with `environment` alone, standard input at its end, in
/// `/scratch` (a private tmpfs) unless `workingDirectory` says otherwise. Besides `mounts` it sees,
/// read-only, the parts of /usr that packages install (not /usr/local and /usr/src) unless
/// `systemFiles` says otherwise, the loader's cache in /etc, four harmless devices, and of /proc
/// /proc/self/exe alone; writable are /scratch, /tmp and the private copies. There is no /dev/shm,
/// and shared anonymous memory, memfd_create and sockets are refused.
struct Command {
  std::vector<std::string> arguments; ///< arguments[0] is an absolute path inside
  std::vector<std::pair<std::string, std::string>> environment;
  std::vector<Mount> mounts;
  /// Of the system only these files, absolute, each at its own place, and no pipes; empty: the
  /// folders above, as compilers need them.
  std::vector<std::filesystem::path> systemFiles;
  std::vector<Mount>
      privateCopies; ///< folders copied into a tmpfs of the run's own, writable, discarded
  std::filesystem::path workingDirectory = "/scratch";
  /// Kept open, same number (3 or more), in the command: the capture channel. What is written
  /// through it is not counted, so seal the file's size (F_SEAL_GROW, F_SEAL_SHRINK, F_SEAL_SEAL).
  int inheritedDescriptor = -1;
  /// After exit code 0 these are handed out, all of them or none; at most 8.
  std::vector<Collect> collect;
  Limits limits;
};

/// How a run ended. Exactly one holds.
enum class End {
  exited,      ///< `exitCode` says how; 126 without a start if the system cannot execute the file
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
  std::uint64_t peakMemoryBytes =
      0;                      ///< highest value measured; 0 for runs shorter than a measurement
  std::string standardOutput; ///< raw bytes, capped
  std::string standardError;  ///< raw bytes, capped
  bool outputTruncated = false;
  bool collected = false;     ///< all of `collect` was written
  std::string collectProblem; ///< why it was not, after a successful exit
  bool collectIsOurs = false; ///< our fault: there was no room for it, or the disk failed
  std::string detail;         ///< one sentence with the limit and the value that met it
};

/// Runs `command` to its end. Never throws for what the command does. When `cancel` becomes true
/// the whole tree is killed within 0.1 s and the result says `interrupted`.
Result run(const Command& command, Isolation isolation, const std::atomic<bool>* cancel = nullptr);

/// What the sandbox was seen to do.
struct SelfTest {
  /// Nothing when it holds; otherwise one sentence with the remedy (for example: AppArmor on Ubuntu
  /// 24.04 stops bwrap).
  std::optional<std::string> problem;
  std::vector<std::string> refused; ///< escapes that were tried in vain, a few words each
};

/// Tries the sandbox once, and escapes from it (6 ms).
SelfTest selfTest();

/// Is bubblewrap's program there?
bool isInstalled();

/// "bubblewrap 0.8.0"; "bubblewrap" where the program doesn't say. Asked once.
const std::string& version();

/// What keeps a command away from the machine: "namespaces", "system calls", "limits", each with a
/// few words, for whoever must know what a class was graded under.
std::vector<std::pair<std::string, std::string>> protections();

} // namespace ggrade::sandbox
