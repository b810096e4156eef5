#pragma once
/// \file
/// What is to be measured: `solutions/<id>/quality.json`, checked against assignment.json.
///
///     {
///       "size": [480, 360],                        pixels of every sweep
///       "parts": {
///         "mirror": {
///           "off": { "effects": { "mirror": false } },   the scene without what the part adds
///           "scenes": [ {
///             "name": "sharp", "about": "...", "time": 0.21,
///             "before": [0.2],                     frames drawn before, see rubric/moments.hpp
///             "scene": { ... },                    merged over scene.json and the part's scene
///             "truth": { "light_radius": 0.1 },    what the part's truth is told besides
///             "numbers": { "mirror_size": [64, 128, ...] },   from the least to the most
///             "together": [["mirror_size", "mirror_clip"]],
///             "reference": { "mirror_clip": 1 },   where the last value is not the best
///             "compare": [ { "name": "SMAA", "setting": { "antialias": 1 } } ],   side by side
///             "notes": { "mirror_clip": "..." }    why the error goes as it does, for the page
///           } ]
///         }
///       },
///       "amounts": ["mirror_size"],                numbers whose cost has an exponent
///       "growth": [ { "name": "objects", "steps": [ { "value": 1, "scene": {...} }, ... ] } ],
///       "saved": [ { "name": "...", "scene": {...}, "against": {...} } ]
///     }
///
/// A step of growth may say `"sphere": 16` instead of a value: its mesh is then a sphere of so many
/// rings that is made for it, and its value the number of triangles. `against` is what the scene's
/// needs are compared with, a patch of it; without one all passes are drawn.

#include "assignment/assignment.hpp"
#include "rubric/moments.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace ggrade::tradeoff {

using nlohmann::json;

/// A quality number that is swept.
struct Number {
  std::string name; ///< "mirror_size"
  std::vector<json> values;
  std::string note;    ///< why the error goes as it does with it; may be empty
  bool amount = false; ///< not a choice between kinds: its cost has an exponent
};

/// A setting that has a name of its own, such as a method's.
struct Named {
  std::string name;
  json setting; ///< of some of a sweep's numbers
};

/// One scene of a part, and the numbers that are swept in it.
struct Sweep {
  std::string part, name, about;
  json scene; ///< whole
  json off;   ///< whole, without what the part adds
  double time = 0;
  std::vector<rubric::Moment> before; ///< frames that are drawn before
  json truth;                         ///< what the part's truth is told besides; null for nothing
  std::vector<Number> numbers;
  std::vector<std::vector<std::string>> together;
  std::string suffix; ///< of its files: ".soft" if an earlier scene sweeps one of its numbers
  json reference =
      json::object();         ///< the best values of numbers whose last value is not their best
  std::vector<Named> compare; ///< these stand side by side, on the front or not
};

/// One step of a series along which cost grows.
struct Step {
  double value = 0;
  json scene;     ///< a patch
  int sphere = 0; ///< rings of the mesh that is made for it; 0: none
};

struct Series {
  std::string name; ///< "objects"
  std::vector<Step> steps;
};

/// What a scene needs is compared with what it would need.
struct SavedCase {
  std::string name;
  json scene, against; ///< whole
};

/// A part as the assignment shows it, and without what it adds.
struct PartScenes {
  std::string part;
  json on, off; ///< whole
};

struct Plan {
  std::vector<PartScenes> parts;
  std::vector<Sweep> sweeps;
  std::vector<Series> growth;
  std::vector<SavedCase> saved;
};

/// Reads `file` for the parts with these IDs. Throws UsageError that names the file, the key and
/// the value.
Plan readPlan(const Assignment& assignment, const std::vector<std::string>& parts,
              const std::filesystem::path& file);

/// Leaves the numbers in `only`, and what is swept together of them. Throws UsageError, with the
/// numbers there are, for one that no sweep has. Nothing is changed if `only` is empty.
void keepOnly(Plan& plan, const std::vector<std::string>& only);

/// The values that the scene has of all numbers of the sweep.
json defaultSetting(const Sweep& sweep);
/// Every number at its last value, or what `reference` says of it.
json referenceSetting(const Sweep& sweep);
/// One number's values, the rest as the scene has it.
std::vector<json> settingsOf(const Sweep& sweep, const std::string& number);
/// Every combination of the values of these numbers, the rest as the scene has it.
std::vector<json> settingsOf(const Sweep& sweep, const std::vector<std::string>& together);
/// All of the sweep, each setting once; the scene's own and the reference among them.
std::vector<json> allSettings(const Sweep& sweep);

/// Does a setting have all that `part` says?
bool holds(const json& setting, const json& part);

/// The scene with the setting in its quality numbers.
json withSetting(json scene, const json& setting);

/// An OBJ file of a sphere of this many rings, standing on the origin like the other meshes: 4
/// rings (rings - 1) triangles, radius 0.5. Throws std::invalid_argument below 2 rings.
std::string sphereObj(int rings);
std::string sphereFile(int rings); ///< its name, which is also the mesh's
double sphereTriangles(int rings);

} // namespace ggrade::tradeoff
