#pragma once
/// \file
/// What a rubric judges, as files: rendered frames of the submission, the reference, the stub and
/// the probes, scene by scene. The grading process writes it, the judging process reads it.

#include "assignment/assignment.hpp"
#include "image/image.hpp"
#include "rubric/moments.hpp"
#include "trace/trace.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ggrade::rubric {

/// One frame as bytes: width x height x 4, RGBA, top row first.
struct RawFrame {
  double time = 0; ///< seconds
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
};

/// Writes frames to `folder` (made if missing). Throws UsageError, naming the file.
void writeFrames(const std::filesystem::path& folder, const std::vector<RawFrame>& frames);
/// Reads them back. Throws UsageError for a file that is missing or of another size than it says.
std::vector<RawFrame> readFrames(const std::filesystem::path& folder);

/// RGB, 0 to 1.
Image toImage(const RawFrame& frame);
std::vector<Image> toImages(const std::vector<RawFrame>& frames);

using Frames = std::vector<Image>;

/// One scene with everything that was rendered in it.
struct SceneEvidence {
  std::string name;
  bool isPublic = false;
  std::vector<std::string> tags;
  nlohmann::json scene;
  std::string like; ///< name of the scene that this one is a change of; empty: of none
  std::size_t frameCount = 0;
  Frames student; ///< fewer than frameCount if the program didn't get that far
  Frames reference, stub;
  trace::Trace studentTrace, referenceTrace, stubTrace; ///< with copies of the first frame's passes
  std::map<std::string, Frames> probes;                 ///< reference only, see scenes.json

  bool has(const std::string& tag) const;
};

struct Evidence {
  std::filesystem::path assignmentFolder; ///< holds assignment.json
  std::string target;                     ///< "mirror" or "floor"
  std::vector<SceneEvidence> scenes;
  /// IDs of the items that are judged once more, by the scenes' first frames alone; empty: all
  /// items are judged, by all frames.
  std::vector<std::string> again{};
};

/// One scene to render, fully drawn: no random choice is left in it.
struct SceneCase {
  std::string name; ///< in the language that was chosen
  bool isPublic = false;
  std::vector<std::string> tags; ///< what it can show; rubric items choose scenes by tag
  Moments times;
  nlohmann::json scene; ///< a whole scene file
  std::string like;     ///< the scene that this one is a change of; empty: of none
  /// Scenes that only the reference is rendered in, to learn where things are (masks) and what a
  /// feature changes: the scene with a patch merged over it. A probe with tags belongs to the
  /// scenes that share one.
  std::map<std::string, nlohmann::json> probes;
  std::string english = {}; ///< the name as scenes.json has it; empty: `name`
};

/// And where what was rendered in it stands.
struct SceneFolders : SceneCase {
  std::filesystem::path student, reference, stub;
  std::map<std::string, std::filesystem::path> probeFolders;
};

void writeEvidence(const std::filesystem::path& file, const std::filesystem::path& assignmentFolder,
                   const std::string& target, const std::vector<SceneFolders>& scenes);
/// Scenes without a student's folder have no student's frames.
Evidence readEvidence(const std::filesystem::path& file);
/// What is judged; from then on its solution's words are known, in the language that was chosen.
Target targetOf(const Evidence& evidence);
/// Leaves the first frame of each scene, of whoever drew it.
void keepFirstFrames(Evidence& evidence);
/// Reads what a submission drew in this scene.
void readStudent(SceneEvidence& scene, const std::filesystem::path& folder);

} // namespace ggrade::rubric
