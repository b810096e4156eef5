#pragma once
/// \file
/// Which keys a scene may have: those of every scene and those that an assignment declares.

#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gg {

enum class KeyType { boolean, integer, real, text };

/// A value of a scene. Arrays of numbers hold reals; an integer is stored as int.
using SceneValue = std::variant<bool, int, double, std::string, std::vector<double>>;

/// One key that a scene may have.
struct KeyDeclaration {
  KeyType type = KeyType::real;
  int length = 1;            ///< numbers: 1 is a plain number, more an array of so many
  double lowest = 0;         ///< numbers: smallest value allowed
  double highest = 0;        ///< numbers: largest value allowed
  bool hasDefault = false;   ///< if not, the scene must have the key
  SceneValue defaultValue{}; ///< meaningful if hasDefault
  std::string about;         ///< what the key means, for people
};

/// The keys that a scene may have, by dotted path (`camera.fov`).
///
/// Every scene has size, background, camera, light and one entry in materials for each material
/// that the assignment names. assignment.json adds keys of the assignment's own: \code
///   "materials": ["object", "floor"],
///   "scene": { "ring.count": { "type": "integer", "range": [0, 100], "default": 6, "about": "..."
///   } }
/// \endcode
/// `type` is boolean, integer, real or text; numbers need a `range`, both ends allowed; a key
/// without `default` must be in the scene.
///
/// presets.json, where there is one beside it, gives settings of several `quality` keys one name:
/// \code
///   { "fast": { "shadow_size": 512, "pcf_radius": 0 } }
/// \endcode
/// A scene asks for one with `"quality": "fast"`, or with `"quality": { "preset": "fast", ... }`,
/// where the values beside it win.
class Declarations {
public:
  /// The keys of every scene, with the given materials and no key of an assignment's own.
  explicit Declarations(const std::vector<std::string>& materials = {});

  /// Reads an assignment.json (a UTF-8 name), and presets.json beside it if there is one. Throws
  /// SceneError if one can't be read or declares something wrongly.
  static Declarations fromFile(const std::string& file);
  /// assignment.json alone, from text; `name` stands in messages.
  static Declarations fromText(std::string_view text, const std::string& name);
  /// Adds the presets in the text of a presets.json. Throws SceneError.
  void addPresets(std::string_view text, const std::string& name);

  const std::map<std::string, KeyDeclaration, std::less<>>& keys() const { return keys_; }
  const std::vector<std::string>& materials() const { return materials_; }
  using Preset = std::map<std::string, SceneValue, std::less<>>;
  const std::map<std::string, Preset, std::less<>>& presets() const { return presets_; }

  /// The known key that is spelled most like `key`; empty if none is near.
  std::string nearest(std::string_view key) const;

  /// What a value of the key must be, for messages: `a number between 0.01 and 3.1`.
  static std::string describe(const KeyDeclaration& key);

private:
  std::map<std::string, KeyDeclaration, std::less<>> keys_;
  std::vector<std::string> materials_;
  std::map<std::string, Preset, std::less<>> presets_;
};

} // namespace gg
