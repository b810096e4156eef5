#pragma once
/// \file
/// Joining what several machines have graded.

#include <filesystem>
#include <string>
#include <vector>

namespace ggrade::batch {

struct Merged {
  std::string target;
  std::size_t copied = 0;
  /// One sentence each: the first folder's result was kept, or a result can't be read anywhere.
  std::vector<std::string> conflicts;
  std::vector<std::string> remarks; ///< shards that aren't finished
  std::vector<std::string> refused; ///< of the folders of uploads
  std::string selfTest;             ///< of the sandbox; empty: one of them had none
};

/// Copies the results of the classes in `from` to `out`, a new or empty folder. A submission that
/// stands in several of them with equal results is taken once; with others it is a conflict.
/// Throws UsageError where a folder holds no class, or classes of other assignments or seeds, or
/// graded by another build of the tool.
Merged mergeClasses(const std::vector<std::filesystem::path>& from,
                    const std::filesystem::path& out);

} // namespace ggrade::batch
