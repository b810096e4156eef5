#pragma once
/// \file
/// What to draw, as read from scene.json.

#include <map>
#include <string>
#include <string_view>

#include <gg/camera.hpp>
#include <gg/declarations.hpp>
#include <gg/light.hpp>
#include <glm/vec2.hpp>

namespace gg {

/// All that varies in a picture. Lengths are in the scene's own unit, angles in radians, time in
/// seconds, colours linear RGB. The world's y axis points up.
///
/// An assignment's own keys are asked for by their dotted path: `scene.real("ring.radius")`. Asking
/// for a key that assignment.json does not declare, or for another type, is a mistake of the
/// program and throws std::invalid_argument.
class Scene {
public:
  /// Reads a scene file (a UTF-8 name) and checks it against the declarations.
  /// Throws SceneError with file, line, key, value and what is allowed.
  static Scene fromFile(const std::string& file, const Declarations& declarations);
  /// The same from text; `name` stands in messages.
  static Scene fromText(std::string_view text, const std::string& name,
                        const Declarations& declarations);

  glm::ivec2 size{640, 480}; ///< of the window, pixels
  glm::vec3 background{0};
  Camera camera;
  Light light; ///< in world space

  /// A material that the assignment names.
  const Material& material(std::string_view name) const;

  bool flag(std::string_view key) const;     ///< of type boolean
  int integer(std::string_view key) const;   ///< of type integer
  float real(std::string_view key) const;    ///< of type real or integer
  double number(std::string_view key) const; ///< of type real or integer, in full precision
  const std::string& text(std::string_view key) const; ///< of type text

  /// Is there a key of this name?
  bool has(std::string_view key) const { return values_.find(key) != values_.end(); }
  /// Replaces the value of a text key.
  void setText(std::string_view key, const std::string& value);

private:
  const SceneValue& value(std::string_view key) const;

  std::map<std::string, SceneValue, std::less<>> values_; // every declared key
  std::map<std::string, Material, std::less<>> materials_;
};

} // namespace gg
