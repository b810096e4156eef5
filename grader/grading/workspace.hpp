#pragma once
/// \file
/// Folders that appear whole or not at all, and disappear when their owner does.

#include <atomic>
#include <filesystem>
#include <string>

namespace ggrade::grading {

/// Set by Ctrl-C, SIGTERM and SIGHUP (see catchInterrupts); everything long looks at it.
extern std::atomic<bool> interrupted;

/// Makes SIGINT, SIGTERM and SIGHUP set `interrupted` instead of ending the process.
void catchInterrupts();

/// Thrown where `interrupted` was seen; ends the tool with exit code 130.
struct Interrupted {};

/// How the names of temporary folders start.
inline constexpr char kTemporaryMark[] = ".ggrade-";

/// Throws UsageError: `folder` holds `name`, which is not this tool's. Says what to do.
[[noreturn]] void refuseForeign(const std::filesystem::path& folder, const std::string& name);

/// Throws UsageError with the remedy if `folder` exists and holds anything that this tool has not
/// published there.
void requireReplaceable(const std::filesystem::path& folder);

/// A private folder (mode 0700, random name) that is removed with everything in it.
class TemporaryFolder {
public:
  /// Under `parent`, or the system's temporary folder. Throws UsageError with the remedy.
  explicit TemporaryFolder(const std::filesystem::path& parent = {},
                           const char* remedy = "Name another folder with --out, or give yourself "
                                                "write permission");
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Makes a folder in it that the sandbox can show its command, which runs under another user ID.
  std::filesystem::path makeVisible(const std::string& name) const;
  /// Moves the folder to `final` in one step, with the caller's usual permissions. What stands
  /// there is replaced, see requireReplaceable.
  void publish(const std::filesystem::path& final);

private:
  std::filesystem::path path_;
};

/// Held by one process or thread at a time; who comes second waits. Where locks don't work, or the
/// file can't be made, nobody waits.
class FileLock {
public:
  /// Throws Interrupted.
  explicit FileLock(const std::filesystem::path& file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

private:
  int lock_;
};

} // namespace ggrade::grading
