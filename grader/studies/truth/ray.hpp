#pragma once
/// \file
/// Rays against triangles (Embree 3), for what rasterisation only approximates.

#include <glm/vec3.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace ggrade::truth {

/// Triangles in world space, counterclockwise seen from outside.
struct Triangles {
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> indices; ///< three a triangle
};

/// Where a ray meets a triangle.
struct Hit {
  double distance = 0;    ///< in lengths of the ray's direction
  std::uint32_t mesh = 0; ///< index in what the scene was made of
  std::uint32_t triangle = 0;
  glm::dvec3 weights{0}; ///< of the triangle's corners; they add up to 1
  glm::dvec3 normal{0};  ///< of the triangle, unit length, on its front side
};

/// What a ray sees of a triangle.
enum class Faces { both, front };

/// Triangles that can be asked what a ray meets. Embree finds the triangle, in single precision and
/// without gaps between neighbours (its robust mode); where on it is computed in double precision.
class RayScene {
public:
  /// Throws std::runtime_error if Embree fails, std::invalid_argument for an index out of range.
  explicit RayScene(std::vector<Triangles> meshes);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  /// The nearest triangle whose distance lies between `from` and `to`.
  ///   direction: any length but 0; distances count in it
  std::optional<Hit> closestHit(const glm::dvec3& origin, const glm::dvec3& direction,
                                double from = 0,
                                double to = std::numeric_limits<double>::infinity(),
                                Faces faces = Faces::both) const;
  /// Is there any triangle nearer than `distance`?
  bool occluded(const glm::dvec3& origin, const glm::dvec3& direction, double distance) const;

private:
  struct Owned;
  std::unique_ptr<Owned> owned_;
};

} // namespace ggrade::truth
