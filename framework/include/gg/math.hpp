#pragma once
/// \file
/// GLM as graphics programs use it, and what it lacks. Angles are in radians.

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace gg {

/// The cofactor matrix of the upper left 3x3 of `m`: determinant times inverse transpose.
///
/// It takes normals where `m` takes positions (the normal matrix of the lecture). A normal is the
/// cross product of two edges, and `cross(M a, M b)` is `cofactor(M) cross(a, b)` for every M, the
/// singular ones included. So unlike the inverse transpose it needs no division, and its sign flips
/// with the determinant: under a mirror image, normals point the way the turned winding says, that
/// is inward. Lengths change; normalise before lighting.
inline glm::mat3 cofactor(const glm::mat4& m) {
  const glm::vec3 x(m[0]), y(m[1]), z(m[2]);
  return {glm::cross(y, z), glm::cross(z, x), glm::cross(x, y)};
}

} // namespace gg
