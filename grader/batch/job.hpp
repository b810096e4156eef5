#pragma once
/// \file
/// One upload on its way to a result, as a batch hands it to a worker.

#include "grading/grade.hpp"
#include "grading/scenes.hpp"
#include "intake/find_uploads.hpp"

#include <nlohmann/json_fwd.hpp>

namespace ggrade::batch {

struct Job {
  intake::Upload upload;
  std::string key; ///< hash of what was handed in; empty: whoever grades it works it out
};

nlohmann::json toJson(const Job& job);
/// Throws nlohmann::json::exception.
Job jobFrom(const nlohmann::json& line);

/// How a job ended.
struct Reply {
  std::string problem; ///< our fault: nothing was written; empty: the result stands
  std::string outcome;
  double score = 0, maxScore = 0, seconds = 0;
};

nlohmann::json toJson(const Reply& reply);
/// Throws nlohmann::json::exception.
Reply replyFrom(const nlohmann::json& line);

/// What a worker says before runs of a kind, and when they are over: {"runs": "hidden"}. The answer
/// to all but `none` is a line that says that it may go on.
nlohmann::json toJson(grading::Runs kind);
/// Throws nlohmann::json::exception.
grading::Runs runsFrom(const nlohmann::json& line);

/// A hash of everything that an upload holds, read as far as an upload is ever read. Throws
/// std::system_error where the machine can't read it.
std::string keyOf(const intake::Upload& upload);

/// A hash of all else that a result depends on: the tool, the points, the solution, the scenes, and
/// the words in which it is told.
std::string graderOf(const Target& target, const std::filesystem::path& solutionFolder,
                     const grading::ScenePlan& plan);

} // namespace ggrade::batch
