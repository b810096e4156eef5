#pragma once
// The Cornell box in double precision, asked by rays: nothing of it is rasterised, no volume is
// made, and nothing but the scene file and the meshes' vertices is taken from the program that is
// judged.

#include "truth/kept.hpp"
#include "truth/scene.hpp"

#include <array>
#include <memory>
#include <vector>

namespace shadow_volume_truth {

using namespace ggrade;
using nlohmann::json;
using truth::dvec3, truth::Surface;

/// IDs of surfaces.
inline constexpr int kNothing = -1; ///< the background
inline constexpr int kCaster = 0;   ///< walls count from 1: floor, ceiling, back, left, right

/// The scene at one time, in a window of `width` x `height` pixels. World space unless something
/// else is said.
class Room {
public:
  /// Throws nlohmann::json::exception where the scene lacks a key, gg::FileError for its mesh.
  Room(const json& scene, double time, int width, int height);

  int width, height;
  bool shadow; ///< the effect
  dvec3 background, lamp;
  truth::Camera camera;

  /// Through the centre of a pixel, row 0 on top. The caster and the walls are seen from their
  /// fronts alone.
  Surface seen(int x, int y) const;
  /// Blinn-Phong by the lamp.
  ///   visible: how much of its light arrives, 0 to 1
  dvec3 color(const Surface& surface, double visible) const;
  /// Is the flat triangle turned away from the lamp?
  bool isAverted(const Surface& surface) const;
  /// Does the caster stand between it and the lamp, or turn it away? Walls hide nothing.
  bool inShadow(const Surface& surface) const;

  /// Does the caster stand between a point in the air and the lamp: is it in a shadow volume?
  bool isHidden(const dvec3& point) const;
  /// Is a point inside the caster? Asked by a ray: for meshes that are closed.
  bool isInCaster(const dvec3& point) const;
  /// Is the point where the line of sight of any pixel begins, in the near plane, in a volume?
  bool nearPlaneIsHidden() const;

private:
  struct Wall {
    dvec3 middle, normal; ///< it faces the room
    dvec3 half;           ///< half of its extent along each axis; 0 along the normal
    dvec3 color;
  };
  truth::Material wall_, caster_;
  std::array<Wall, 5> walls_;
  std::unique_ptr<truth::Objects> objects_;
};

/// Every pixel, row by row.
std::vector<Surface> look(const Room& room);

/// What one pixel must show.
struct Point {
  bool isSurface = false; ///< no background
  bool isAverted = false; ///< turned from the lamp
  bool inShadow = false;
  /// A surface that is turned towards the lamp; and so are all eight neighbours, on the same smooth
  /// piece of it, all in shadow or all lit as it is?
  bool counts = false;
  /// Could a picture tell? Where light and shadow differ by less than 4 of 255 (in every channel),
  /// it can't.
  bool tellable = false;
  dvec3 lit{0}, dark{0}; ///< as the window shows it
};

struct Shadows {
  Image picture;             ///< RGB, 0 to 1
  std::vector<Point> points; ///< row by row
};

Shadows shadowsOf(const truth::Rendered& rendered);

/// Pixels that were judged, by what they must show; how many of them show the other thing, and how
/// many neither: the colour is more than 4 of 255 from both.
struct Counts {
  std::size_t lit = 0, dark = 0, falseShadow = 0, falseLight = 0, strange = 0;
  std::size_t judged() const { return lit + dark; }
  std::size_t wrong() const { return falseShadow + falseLight; }
};

/// Compares a window with them; pixels that count and are tellable. A pixel shows what it is nearer
/// to: its colour with the lamp's light, or without.
///   difference: if given, gets a picture: red for a false shadow, blue for false light
Counts count(const Shadows& shadows, const Image& window, Image* difference = nullptr);

} // namespace shadow_volume_truth
