#pragma once
/// \file
/// Light and material, laid out as the uniform blocks `Light` and `Material` of gg/lighting.glsl.
/// std140 gives every vec3 the room of a vec4, so all are vec4s here. A colour's fourth component
/// is 1 and takes no part in lighting.

#include <cstddef>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace gg {

inline constexpr unsigned kLightBinding = 0;    ///< binding point of the block `Light`
inline constexpr unsigned kMaterialBinding = 1; ///< binding point of the block `Material`

/// A point light. Colours are linear RGB; 1 is what a white surface shows as white.
struct Light {
  glm::vec4 ambient{0.2f, 0.2f, 0.2f, 1};
  glm::vec4 diffuse{1};
  glm::vec4 specular{1};
  glm::vec4 position{0, 0, 0, 1}; ///< homogeneous, in the space that the lighting is done in

  /// The same light in another space.
  ///   toSpace: that space from this light's; the scene's own light is in world space
  Light in(const glm::mat4& toSpace) const {
    return {ambient, diffuse, specular, toSpace * position};
  }
};

/// What a Blinn-Phong surface reflects. Colours are linear RGB.
struct Material {
  glm::vec4 ambient{0.6f, 0.6f, 0.6f, 1};
  glm::vec4 diffuse{0.6f, 0.6f, 0.6f, 1};
  glm::vec4 specular{0.3f, 0.3f, 0.3f, 1};
  float shininess = 60; ///< Blinn-Phong exponent
  float unused[3] = {}; ///< std140 rounds a block's size up to a vec4's
};

static_assert(sizeof(Light) == 64 && offsetof(Light, position) == 48);
static_assert(sizeof(Material) == 64 && offsetof(Material, shininess) == 48);

} // namespace gg
