#pragma once
/// \file
/// A judge that stays: it knows the scenes of one seed and is asked about many submissions.

#include "assignment/assignment.hpp"
#include "grading/workspace.hpp"
#include "image/compare.hpp"
#include "rubric/evidence.hpp"

#include <cstdio>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include <sys/types.h>

namespace ggrade::grading {

/// May be asked by several threads. Throws std::runtime_error where it can't be started.
class JudgeServer {
public:
  /// \param tolerances null: the published ones
  JudgeServer(const Target& target, const std::vector<rubric::SceneFolders>& scenes,
              const Tolerances* tolerances = nullptr);
  ~JudgeServer();
  JudgeServer(const JudgeServer&) = delete;
  JudgeServer& operator=(const JudgeServer&) = delete;

  /// The items of the submission whose folders stand in `scenes`; `work` is for the answer's files.
  /// `problem` says why items stay unjudged. `again`: see rubric::Evidence. Throws Interrupted.
  std::vector<report::Item> judge(const std::vector<rubric::SceneFolders>& scenes,
                                  const std::filesystem::path& work, std::string& problem,
                                  const std::vector<std::string>& again = {});

private:
  /// Why it is gone, or "".
  std::string gone();

  const Target& target_;
  TemporaryFolder folder_;
  std::mutex mutex_;
  pid_t pid_ = 0;
  int requests_ = -1;
  unsigned asked_ = 0;
  std::string end_;
};

} // namespace ggrade::grading
