#pragma once
/// \file
/// What a class' folder remembers of its runs: `.ggrade-batch.json`.

#include "grading/scenes.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ggrade::batch {

struct State {
  std::string target;         ///< ID of what is graded
  grading::Draw draw;         ///< of the scenes
  std::filesystem::path work; ///< temporary folder of the run; removed by the next one if this died
  unsigned run = 1;           ///< counts regradings
  bool isFinished = false;
  std::string selfTest;             ///< of the sandbox, in words; empty: there was none
  std::vector<std::string> refused; ///< of the folder of uploads, "name: why"
  /// Scores, by folder, that the last finished run left: what this one's are compared with.
  std::map<std::string, double> before;
};

/// Nothing if `out` holds none. Throws UsageError with the remedy for a file that makes no sense.
std::optional<State> loadState(const std::filesystem::path& out);
void saveState(const std::filesystem::path& out, const State& state);

/// Makes the folder of a class if it is missing. Throws UsageError with the remedy.
void makeClassFolder(const std::filesystem::path& out);

/// Keeps a second run out of a folder while this exists.
class Lock {
public:
  /// Throws UsageError if somebody else is at it.
  explicit Lock(const std::filesystem::path& out);
  ~Lock();
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

private:
  int file_ = -1;
};

/// Removes what a killed run left: its temporary folder, half-written results and files. Only what
/// bears this tool's mark and belongs to this user; in a folder without a state only what was to
/// become one.
void sweep(const std::filesystem::path& out, const std::optional<State>& state);

} // namespace ggrade::batch
