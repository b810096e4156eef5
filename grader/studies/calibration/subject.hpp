#pragma once
/// \file
/// A program on its way through a measurement, and its gradings. They are kept, so that a
/// measurement that was broken off goes on where it was.

#include "calibration/programs.hpp"
#include "grading/grade.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>

namespace ggrade::calibration {

struct Subject {
  Measured measured;
  std::shared_ptr<grading::Program> program; ///< none for pictures
  std::string key;                           ///< what tells it from others
  std::once_flag once;
  grading::Built built;

  /// What was built of it, when it is first needed. Several threads may ask.
  const grading::Built& build(grading::Grader& grader);
};

/// Makes each program's files and says what tells them from others. A patch that doesn't apply is
/// its program's `problem`.
std::vector<std::unique_ptr<Subject>> subjectsOf(const Target& target,
                                                 const std::vector<KnownAnswer>& programs);

/// Where the grading with this key is kept.
std::filesystem::path scoreFile(const std::string& key);

/// Grades subjects as `ggrade grade` does, but for the pictures in reports: one at a time a thread.
grading::GraderOptions graderOptions(bool twice = false);

/// The reference's pictures of one seed. Those of ten seeds are gigabytes: they are removed with
/// this, unless they are the public scene's or the seed is the assignment's own.
class SeedPictures {
public:
  SeedPictures(const Target& target, const std::filesystem::path& solutionFolder,
               const grading::ScenePlan& plan);

private:
  grading::TemporaryFolder folder_;

public:
  const grading::References references;
};

Score scoreOf(const results::Result& result);

nlohmann::json toJson(const Score& score);
/// Throws nlohmann::json::exception for anything that toJson didn't write.
Score scoreFrom(const nlohmann::json& json);

/// What was kept in a file of the cache; nothing if it isn't there or isn't whole.
std::optional<nlohmann::json> loadKept(const std::filesystem::path& file);
/// Appears whole or not at all. Throws UsageError when the disk is full.
void saveKept(const std::filesystem::path& file, const nlohmann::json& kept);

/// Likewise, of one grading.
std::optional<Score> loadScore(const std::filesystem::path& file);
void saveScore(const std::filesystem::path& file, const Score& score);

} // namespace ggrade::calibration
