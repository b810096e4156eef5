#pragma once
/// \file
/// What the scenes of "deferred" show, in double precision: surfaces by rays, light by formulas and
/// sums over directions, no texture anywhere.

#include "truth/kept.hpp"
#include "truth/scene.hpp"

#include "sky.hpp"

#include <memory>

namespace deferred_truth {

using namespace ggrade;
using glm::dvec3;
using nlohmann::json;

/// What an object's surface is like.
struct Paint {
  Paint(const json& scene, const std::string& name, const dvec3& color);

  truth::Material material; ///< in the scene's light, without the object's own colour
  dvec3 color;              ///< its own
  dvec3 albedo;             ///< with its own colour
  dvec3 straight;           ///< the share of light that it mirrors straight back
};

class World {
public:
  World(const json& scene, double time, int width, int height);

  truth::Surface seen(int x, int y) const;
  const Paint& paint(const truth::Surface& surface) const {
    return paints_[std::size_t(surface.id)];
  }
  /// Is there an object between the surface and what is infinitely far away?
  bool isHidden(const truth::Surface& surface, const dvec3& towards) const;

  int width, height;
  truth::Camera camera;

private:
  std::vector<Paint> paints_;
  std::unique_ptr<truth::Objects> objects_;
  double reach_ = 0; ///< how far any object is from the origin, about
};

/// What every pixel shows, row by row.
std::vector<truth::Surface> look(const World& world);

/// Pixels that stand for one smooth piece of a surface, or of the background, and so do their eight
/// neighbours: 1, otherwise 0.
std::vector<bool> smooth(const World& world, const std::vector<truth::Surface>& surfaces);

/// The scene's sky as the program makes it.
Sky skyOf(const json& scene);

/// Schlick's approximation (1994); none of it where `straight` is 0.
dvec3 fresnel(const dvec3& straight, double cosine);

/// IEC 61966-2-1, after what is brighter than 1 is cut off.
dvec3 display(const dvec3& light);

} // namespace deferred_truth
