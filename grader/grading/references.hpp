#pragma once
/// \file
/// The reference's, stub's and probes' pictures, rendered once and kept.

#include "grading/parallel.hpp"
#include "grading/progress.hpp"
#include "grading/scenes.hpp"
#include "grading/store.hpp"
#include "rubric/evidence.hpp"

#include <functional>
#include <map>
#include <mutex>

namespace ggrade::grading {

struct References {
  std::vector<rubric::SceneFolders> scenes; ///< all but the students' folders is filled in
  ShaderCache shaders;                      ///< warmed by the stub
  ShaderCache ownShaders; ///< warmed by the reference; for programs whose words reach no student

  /// Of the first scene's reference: what draws on this machine, whatever a submission says.
  Renderer renderer() const;
};

/// What the pictures of the reference and the stub depend on besides the scenes: tool, renderer and
/// programs.
std::string referenceKey(const Target& target, const std::filesystem::path& solutionFolder);

/// A hash of this very tool, for what depends on its code.
const std::string& toolHash();

/// What a grading's result depends on besides the submission: this very tool, its rubrics, the
/// points, the reference, and the scenes.
std::string gradingKey(const Target& target, const std::filesystem::path& solutionFolder,
                       const ScenePlan& plan);

/// What its texts depend on besides: the tables of the assignment and of the solution.
std::string wordsKey(const Assignment& assignment, const std::filesystem::path& solutionFolder);

/// Makes sure that everything of `plan` is rendered, in the sandbox like a submission, and says
/// where it stands. What was rendered before by the same tool, assignment, seed and renderer is
/// taken from the cache
/// (`GGRADE_CACHE`, else the build folder). What isn't there yet is put there, or into `elsewhere`
/// if that is named, by who doesn't want to keep it. Throws UsageError where our own programs fail.
References prepareReferences(const Target& target, const std::filesystem::path& solutionFolder,
                             const ScenePlan& plan, const Progress& progress,
                             const std::filesystem::path& elsewhere = {});

/// Reads and encodes the reference's frames once for all submissions that they are held against.
/// Several threads may ask.
class ReferencePictures {
public:
  struct Frame {
    rubric::RawFrame raw;
    Image image;     ///< RGBA, 0 to 1
    std::string png; ///< data URI
  };

  /// The frames in a folder of the reference's. Throws like `rubric::readFrames`.
  const std::vector<Frame>& of(const std::filesystem::path& folder);

private:
  std::mutex mutex_;
  std::map<std::filesystem::path, std::vector<Frame>> known_;
};

} // namespace ggrade::grading
