#pragma once
/// \file
/// The light in scenes of "deferred": what each part's picture should hold.

#include "truth_world.hpp"

namespace deferred_truth {

/// What part "targets" adds up, at one pixel.
struct Kinds {
  dvec3 diffuse{0}, specular{0}, ambient{0};
};

/// Forward shading of all pixels, row by row; the background is diffuse light.
std::vector<Kinds> shade(const World& world, const std::vector<truth::Surface>& surfaces,
                         const json& scene);

/// Their sum, at every pixel, the diffuse light with its edges emphasised if the scene says so.
std::vector<dvec3> compose(const World& world, const std::vector<Kinds>& kinds, bool edges);

/// What falls from the environment on a surface, if nothing is in the light's way: summed over
/// directions.
class OpenSky {
public:
  explicit OpenSky(const Sky& sky);
  dvec3 irradiance(const dvec3& normal) const;

private:
  struct Ray {
    dvec3 towards, light; ///< radiance times solid angle
  };
  std::vector<Ray> rays_;
};

/// The same, of the directions in which nothing is in its way: by rays, 256 to the sky, 16 to the
/// sun.
///   turn: of the rays about the normal, a share of a full turn
dvec3 visibleIrradiance(const World& world, const truth::Surface& surface, const Sky& sky,
                        double turn);

/// What part "figure" shows, before it is encoded for the display. Reflections show the environment
/// only, whatever stands in the way, as the figure means it.
///   visible: does what stands in the way keep scattered light off?
std::vector<dvec3> lightOf(const World& world, const std::vector<truth::Surface>& surfaces,
                           const Sky& sky, bool visible);

} // namespace deferred_truth
