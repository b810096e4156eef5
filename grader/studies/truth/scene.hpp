#pragma once
/// \file
/// What truths of several assignments take from a scene file, in double precision: its camera, its
/// materials in its light, and meshes that rays can meet.

#include "truth/ray.hpp"
#include "truth/truth.hpp"

#include <memory>
#include <string>
#include <vector>

namespace ggrade::truth {

using glm::dvec3;

/// Values at a JSON pointer. Throw nlohmann::json::exception that names what is missing.
double number(const nlohmann::json& scene, const std::string& key);
dvec3 vector(const nlohmann::json& scene, const std::string& key);

/// Turned about the y axis as glm::rotate does it; radians.
dvec3 aboutY(const dvec3& v, double angle);

/// A pinhole.
struct Camera {
  /// As the scene's `camera` says, for a window of this many pixels.
  Camera(const nlohmann::json& scene, int width, int height);
  /// From the eye through the centre of a pixel, row 0 on top. One length of it is one unit of
  /// depth: near and far plane are distances along it.
  dvec3 through(int x, int y) const;

  dvec3 eye, forward, right, up; ///< right and up reach to the picture's edge at distance 1
  double near, far;
  int width, height; ///< pixels
};

/// The three kinds of light that leave a surface.
struct Lit {
  dvec3 ambient, diffuse, specular;
};

/// A material in a scene's light.
struct Material {
  Material() = default;
  Material(const nlohmann::json& scene, const std::string& name);
  /// Blinn-Phong (Blinn 1977); all directions of unit length, away from the surface.
  Lit lit(const dvec3& normal, const dvec3& toLight, const dvec3& toEye) const;

  dvec3 ambient{0}, diffuse{0}, specular{0}; ///< times the light's
  double shininess = 0;
};

/// What a ray meets first.
struct Surface {
  int id = -1; ///< -1: nothing; otherwise the truth's own numbering
  dvec3 position{0};
  dvec3 normal{0}; ///< interpolated, unit length
  dvec3 face{0};   ///< normal of the flat triangle, unit length
};

/// Do two neighbouring pixels show the same smooth piece of a surface?
bool continues(const Surface& a, const Surface& b);

/// The same, without an edge between them: their normals are less than 45 degrees apart.
bool isSmooth(const Surface& a, const Surface& b);

/// Meshes with normals at their vertices, all in world space.
class Objects {
public:
  struct Object {
    Triangles triangles;
    std::vector<dvec3> normals; ///< one a vertex
  };
  explicit Objects(std::vector<Object> objects);

  /// The first triangle that is seen from its front on the way, at least `from` and at most `to`
  /// lengths of `direction` away. Its `id` is the object's index.
  Surface first(const dvec3& origin, const dvec3& direction, double from, double to) const;
  /// Does a triangle, seen from either side, lie between the surface and the light?
  bool hide(const Surface& surface, const dvec3& light) const;
  const RayScene& rays() const { return rays_; }

private:
  std::vector<std::vector<std::uint32_t>> indices_;
  std::vector<std::vector<dvec3>> normals_;
  RayScene rays_;
  double reach_ = 0; ///< largest distance of a vertex from the origin
};

/// 0 to 1, as a window shows it.
dvec3 cut(const dvec3& light);

} // namespace ggrade::truth
