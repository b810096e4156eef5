#pragma once
/// \file
/// Files that appear whole or not at all.

#include <filesystem>
#include <span>

namespace ggrade {

/// A name beside `target` to write to. `commit` renames it to the target; without it the destructor
/// removes it, so that an error in the middle leaves the old file, or none. The extension stays the
/// target's.
class TemporaryFile {
public:
  /// Throws std::runtime_error with the path and the cause if the target is a folder or something
  /// else that must not be replaced (a device, a pipe), or if its folder is missing. A link is
  /// followed.
  explicit TemporaryFile(const std::filesystem::path& target);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Is a file of this name one that a killed process has left?
  static bool isOne(const std::filesystem::path& path);
  /// Throws std::runtime_error with the path and the cause.
  void commit();

private:
  std::filesystem::path target_, path_;
};

/// Writes all of `bytes` to `target`, whole or not at all. Throws std::runtime_error with the path
/// and the cause (disk full, no permission).
void writeWholeFile(const std::filesystem::path& target, std::span<const unsigned char> bytes);

} // namespace ggrade
