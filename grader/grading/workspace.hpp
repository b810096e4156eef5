#pragma once
/// \file
/// Folders that appear whole or not at all, and disappear when their owner does.

#include <atomic>
#include <filesystem>
#include <string>

namespace ggrade::grading {

/// Set by Ctrl-C and SIGTERM (see catchInterrupts); everything long looks at it.
extern std::atomic<bool> interrupted;

/// Makes SIGINT and SIGTERM set `interrupted` instead of ending the process.
void catchInterrupts();

/// Thrown where `interrupted` was seen; ends the tool with exit code 130.
struct Interrupted {};

/// Throws UsageError with the remedy if `folder` exists and is neither empty nor an earlier result,
/// which holds a file called `marker`.
void requireReplaceable(const std::filesystem::path& folder, const std::string& marker);

/// A private folder (mode 0755, random name) that is removed with everything in it.
class TemporaryFolder {
public:
  /// Under `parent`, or the system's temporary folder. Throws UsageError with the remedy.
  explicit TemporaryFolder(const std::filesystem::path& parent = {});
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Moves the folder to `final` in one step. What stands there is replaced, see
  /// requireReplaceable.
  void publish(const std::filesystem::path& final, const std::string& marker);

private:
  std::filesystem::path path_;
};

} // namespace ggrade::grading
