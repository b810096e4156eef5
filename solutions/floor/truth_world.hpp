#pragma once
// The floor's scene in double precision, asked by rays: nothing of it is rasterised, and nothing
// but the scene file and the meshes' vertices is taken from the program that is judged.

#include "truth/blur.hpp"
#include "truth/kept.hpp"
#include "truth/scene.hpp"

#include <memory>
#include <string>
#include <vector>

namespace floor_truth {

using namespace ggrade;
using nlohmann::json;
using truth::aboutY, truth::continues, truth::cut, truth::dvec3, truth::kept, truth::number,
    truth::shownDifference, truth::Surface, truth::vector;

/// IDs of surfaces.
inline constexpr int kNothing = -1; ///< the background
inline constexpr int kFloor = 0;    ///< objects count from 1

/// What a pixel shows.
struct Seen {
  Surface surface;
  dvec3 toEye{0};      ///< from the surface, unit length
  Surface reflected;   ///< what a mirror in the plane of the floor shows at this pixel
  dvec3 reflection{0}; ///< its light; the background's where there is nothing
};

/// The scene at one time, in a window of `width` x `height` pixels.
class World {
public:
  /// Throws nlohmann::json::exception where the scene lacks a key, gg::FileError for its mesh.
  World(const json& scene, double time, int width, int height);

  int width, height;
  bool mirror, shadow, bloom; ///< the effects
  dvec3 background, light;    ///< position of the light
  dvec3 floorSpecular;        ///< what the floor reflects

  /// Through the centre of a pixel, row 0 on top.
  Seen seen(int x, int y) const;
  /// Blinn-Phong by the light; the floor without its reflection.
  ///   visible: how much of the light arrives, 0 to 1
  dvec3 color(const Surface& surface, const dvec3& toEye, double visible) const;
  /// Does an object stand between it and the light? The floor hides nothing from the light, as in
  /// the lecture.
  bool inShadow(const Surface& surface) const;
  /// How much of a round light of this radius is seen, 0 to 1: rays to 128 places spread evenly
  /// over the disc that faces the surface (a spiral, Vogel 1979).
  double shareOfLight(const Surface& surface, double radius) const;
  /// As much light as the scene lets arrive: all of it where shadows are off.
  double visibility(const Surface& surface) const { return shadow && inShadow(surface) ? 0 : 1; }
  /// Does the line between two tiles go through this very point? Then rounding decides which tile
  /// it belongs to.
  bool onTileLine(const Surface& surface) const;
  /// The light of a pixel. In a scene without bloom a reflection is at most 1, as its texture and
  /// the window are; with bloom nothing is cut off.
  dvec3 shown(const Seen& seen, double visible) const;

  /// Where objects can be at any time: middle and radius of a ball.
  dvec3 ballMiddle;
  double ballRadius;

private:
  /// The first object on a ray; behind `from`, in lengths of `direction`.
  Surface object(const dvec3& origin, const dvec3& direction, double from, double to) const;

  truth::Camera camera_;
  truth::Material object_, floor_;
  double glow_, tilesPerUnit_, halfWidth_, halfDepth_;
  std::unique_ptr<truth::Objects> objects_;
};

World worldOf(const truth::Rendered& rendered);
/// The same. Throws std::invalid_argument, with `whose` truth it is, for a scene with bloom.
World worldWithoutBloom(const truth::Rendered& rendered, const std::string& whose);

/// Every pixel, row by row.
std::vector<Seen> look(const World& world);

} // namespace floor_truth
