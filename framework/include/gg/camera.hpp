#pragma once
/// \file
/// The scene's camera.

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace gg {

/// A perspective camera, in world space.
struct Camera {
  glm::vec3 position{0, 0, 1};
  glm::vec3 target{0, 0, 0}; ///< what it looks at; not the position
  glm::vec3 up{0, 1, 0};     ///< what is up in the picture; any length but 0
  float fov = 1;             ///< vertical angle of view, radians
  float near = 0.1f;         ///< distance of the near plane, more than 0
  float far = 100;           ///< distance of the far plane, more than `near`

  /// Clip from eye, z from -1 to 1.
  ///   aspect: width over height
  glm::mat4 projection(float aspect) const;

  /// Eye from world: the eye in the origin, looking along -z, y up.
  /// Where `up` lies in the direction of view (looking straight down, say) it says nothing; then
  /// what a camera shows that tilts there from the horizontal, looking along -z, decides: looking
  /// along -y the picture's top is -z, along +y it is +z, and along any other direction it is +y.
  glm::mat4 view() const;
};

} // namespace gg
