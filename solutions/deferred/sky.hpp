// The environment: a sky, a ground and a sun, all infinitely far away; and the same as a picture.
//
// Directions are of unit length, in world space, y up. Radiance is linear RGB.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

// By default a clear day. What falls on level ground from the sky and from the sun is then about
// the same.
struct Sky {
  glm::vec3 zenith{0.25f, 0.45f, 0.9f};
  glm::vec3 horizon{0.9f, 0.95f, 1.0f};
  glm::vec3 ground{0.2f, 0.18f, 0.15f};          // all that lies below the horizon
  glm::vec3 sunDirection{0.48f, 0.6f, 0.64f};    // to its middle; unit length
  glm::vec3 sunRadiance{3.0e4f, 2.7e4f, 2.3e4f}; // half floats end at 65504
  float glow = 0.5f;                             // by how much the sky is brighter at the sun
  float sunRadius = 0.00465f;                    // radians, more than 0, at most 0.5
};

// The radiance from a direction, without the sun's disc.
//   From the zenith Z to the horizon H it goes as Z + (H - Z) (1 - y)^3, and is brighter by
//   1 + glow max(cos a, 0)^8 at the angle a from the sun.
inline glm::vec3 skyRadiance(const Sky& sky, const glm::vec3& direction) {
  if (direction.y < 0) return sky.ground;
  const float low = 1 - direction.y;
  const float towardsSun = std::max(glm::dot(direction, sky.sunDirection), 0.0f);
  return (1 + sky.glow * std::pow(towardsSun, 8.0f)) *
         glm::mix(sky.zenith, sky.horizon, low * low * low);
}

// The same with the sun's disc, whose radiance is added. Nothing hides the sun, not even the
// ground.
inline glm::vec3 radiance(const Sky& sky, const glm::vec3& direction) {
  // The sine of a small angle is exact in floats, its cosine isn't.
  const bool inDisc =
      glm::dot(direction, sky.sunDirection) > 0 &&
      glm::length(glm::cross(direction, sky.sunDirection)) < std::sin(sky.sunRadius);
  return skyRadiance(sky, direction) + (inDisc ? sky.sunRadiance : glm::vec3(0));
}

// All directions in a rectangle (equirectangular): u turns to the right, as seen from inside, and
// its middle is -z; v goes from +y, 0, to -y, 1. So row 0 is the uppermost, and as a texture it has
// the very same coordinates, with GL_REPEAT along u and GL_CLAMP_TO_EDGE along v.
struct EnvironmentMap {
  int width = 0, height = 0;     // width is twice the height
  std::vector<glm::vec3> texels; // the mean over each texel
};

inline glm::vec3 directionOf(const glm::dvec2& uv) {
  const double turn = 2 * std::numbers::pi * (uv.x - 0.5), down = std::numbers::pi * uv.y;
  return {std::sin(down) * std::sin(turn), std::cos(down), -std::sin(down) * std::cos(turn)};
}

inline glm::dvec2 uvOf(const glm::dvec3& direction) {
  return {0.5 + std::atan2(direction.x, -direction.z) / (2 * std::numbers::pi),
          std::acos(std::clamp(direction.y, -1.0, 1.0)) / std::numbers::pi};
}

// Of a texel of this row, steradians.
inline double solidAngle(const EnvironmentMap& map, int row) {
  const double step = std::numbers::pi / map.height;
  return 2 * std::numbers::pi / map.width * (std::cos(row * step) - std::cos((row + 1) * step));
}

// A map of function(direction) at every texel's middle.
//   width: even, at least 2
template <class Function> EnvironmentMap tabulate(int width, Function function) {
  EnvironmentMap map{width, width / 2, {}};
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < width; ++x)
      map.texels.push_back(function(directionOf({(x + 0.5) / width, (y + 0.5) / map.height})));
  return map;
}

// The sky with its sun. The disc may be smaller than a texel, so its light is handed out to the
// texels in 65536 equal parts: all of it arrives, however coarse the map.
//   width: even, at least 2
inline EnvironmentMap environmentMap(const Sky& sky, int width) {
  EnvironmentMap map =
      tabulate(width, [&](const glm::vec3& direction) { return skyRadiance(sky, direction); });
  if (sky.sunRadiance == glm::vec3(0)) return map;

  const glm::dvec3 middle = glm::normalize(glm::dvec3(sky.sunDirection));
  const glm::dvec3 aside = glm::normalize(
      glm::cross(middle, std::abs(middle.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
  const glm::dvec3 across = glm::cross(middle, aside);
  const double height = 1 - std::cos(double(sky.sunRadius)); // of the disc, a cap of the sphere
  constexpr int kParts = 65536;
  std::vector<double> covered(map.texels.size()); // steradians
  for (int i = 0; i < kParts; ++i) {
    // On a spiral (Vogel 1979) that spreads them evenly: equal steps of height are equal areas.
    const double z = 1 - height * (i + 0.5) / kParts, r = std::sqrt(1 - z * z);
    const double turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const glm::dvec2 uv = uvOf(z * middle + r * (std::cos(turn) * aside + std::sin(turn) * across));
    const int x = std::min(int(uv.x * map.width), map.width - 1);
    const int y = std::min(int(uv.y * map.height), map.height - 1);
    covered[std::size_t(y) * std::size_t(map.width) + std::size_t(x)] +=
        2 * std::numbers::pi * height / kParts;
  }
  for (std::size_t i = 0; i < covered.size(); ++i)
    map.texels[i] += float(covered[i] / solidAngle(map, int(i) / map.width)) * sky.sunRadiance;
  return map;
}
