#pragma once
/// \file
/// The scenes that a submission is rendered in: the public one and hidden ones drawn from a seed.

#include "assignment/assignment.hpp"
#include "rubric/evidence.hpp"

#include <cstdint>
#include <optional>

namespace ggrade::grading {

/// How closely a grading looks, for the time that it takes: `ggrade calibrate --trade` measures
/// both.
enum class Quality {
  fast,     ///< no scenes that are like another one but for a change, and no second run
  balanced, ///< all of scenes.json
  thorough, ///< every hidden scene twice, drawn anew
};

inline constexpr const char* kQualities[] = {"fast", "balanced", "thorough"};
inline std::string nameOf(Quality quality) {
  return kQualities[std::size_t(quality)];
}
/// Throws UsageError for another name.
Quality parseQuality(const std::string& name);

/// What a plan is drawn by.
struct Draw {
  std::optional<std::uint64_t> seed; ///< none: the assignment's own
  Quality quality = Quality::balanced;

  bool operator==(const Draw&) const = default;
};

using rubric::Moments;
using rubric::SceneCase;

struct ScenePlan {
  std::uint64_t seed = 0;
  Quality quality = Quality::balanced;
  std::vector<SceneCase> scenes;
};

/// Draws the plan of `target` from `solutionFolder/scenes.json` and the assignment's scene.json. A
/// scene with `"parts"` has these parts' settings, and is drawn where all of them are graded. In
/// scenes.json a value `{"between": [a, b]}` is drawn evenly (numbers, or arrays component by
/// component), `{"choose": [...]}` picks one; everything else stands as it is. A scene with
/// `"like"` is an earlier scene of the same parts, at its first time, with `scene` as what has
/// changed: there `{"plus": x}` and `{"times": x}` are counted from that scene's value. `"before"`
/// are the frames that are drawn before those of `times` (rubric/moments.hpp); a scene that is like
/// another one has that one's, unless it has its own. The same seed gives the same plan on every
/// machine. Throws UsageError, also for a scene outside of what assignment.json
/// declares.
ScenePlan drawScenes(const Target& target, const std::filesystem::path& solutionFolder,
                     const Draw& draw = {});

/// All of a plan as text, the same in every language: equal texts are equal plans.
std::string describe(const ScenePlan& plan);

/// Throws UsageError, with `name`, unless the scene is one that assignment.json allows.
void checkScene(const Assignment& assignment, const nlohmann::json& scene, const std::string& name);
/// Reads a scene file that a person wrote. Throws UsageError as `file:line: key: ...`.
nlohmann::json readScene(const Assignment& assignment, const std::filesystem::path& file);

/// The assignment's scene with the settings of the parts with these IDs, one over the other.
nlohmann::json partScene(const Assignment& assignment, const std::vector<std::string>& parts);

/// The scene of the handout's picture of step `k` (0: nothing done yet) of a part: the assignment's
/// scene, the part's, `settings["scene"]`, and the one given for this step (without its `before`).
nlohmann::json handoutScene(const Assignment& assignment, const Part& part,
                            const nlohmann::json& settings, std::size_t k);

/// When it is drawn: at `settings["times"]`, after the frames of this step's `before`, else of
/// `settings["before"]`. Throws UsageError.
Moments handoutTimes(const Part& part, const nlohmann::json& settings, std::size_t k);
/// The same for anything else of handout.json that may have a `before`, such as a picture.
/// \param name for errors
Moments handoutTimes(const nlohmann::json& settings, const nlohmann::json& one,
                     const std::string& name);

} // namespace ggrade::grading
