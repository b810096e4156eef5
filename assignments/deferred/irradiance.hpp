// Irradiance: what falls on a surface from the whole half space above it, by the surface's normal.
//
// Three ways to it: spherical harmonics for what changes slowly, a closed form for the sun's disc,
// and the sum over all texels. A white surface (albedo 1) then reflects irradiance / pi.
#pragma once

#include "sky.hpp"

#include <cstddef>

// Coefficients of real spherical harmonics (orthonormal, no Condon-Shortley phase), that of degree
// l and order m at l (l + 1) + m. Up to degree 2 the functions are 0.282095; 0.488603 (y, z, x);
// 1.092548 (xy, yz), 0.315392 (3 z^2 - 1), 1.092548 xz, 0.546274 (x^2 - y^2).
struct Harmonics {
  int degree = 0;
  std::vector<glm::vec3> coefficients; // (degree + 1)^2
};

// The values of all functions up to a degree in a direction (unit length).
// By the usual recurrences of the associated Legendre functions, divided by sin^m.
inline std::vector<double> harmonicsAt(const glm::dvec3& direction, int degree) {
  std::vector<double> values(std::size_t((degree + 1) * (degree + 1)));
  const double z = direction.z;
  double cosine = 1, sine = 0;                           // of m times the azimuth, times sin^m
  double diagonal = 1 / std::sqrt(4 * std::numbers::pi); // degree m, order m
  for (int m = 0; m <= degree; ++m) {
    double before = 0, now = diagonal; // degrees l - 1 and l, order m
    for (int l = m; l <= degree; ++l) {
      const std::size_t middle = std::size_t(l * (l + 1));
      const std::size_t order = std::size_t(m);
      const double scale = m == 0 ? 1 : std::numbers::sqrt2;
      values[middle + order] = scale * now * cosine;
      if (m > 0) values[middle - order] = scale * now * sine;
      const auto root = [&](int k) { return std::sqrt((4.0 * k * k - 1) / (k * k - m * m)); };
      const double next = root(l + 1) * (z * now - (l > m ? before / root(l) : 0));
      before = now, now = next;
    }
    const double turned = cosine * direction.x - sine * direction.y;
    sine = cosine * direction.y + sine * direction.x;
    cosine = turned;
    diagonal *= std::sqrt((2.0 * m + 3) / (2 * m + 2));
  }
  return values;
}

// The map in harmonics. Every texel is integrated at 2 x 2 places (Gauss and Legendre's).
//   map: 64 texels wide is enough for a sky without a sun;  degree: at least 0
inline Harmonics project(const EnvironmentMap& map, int degree) {
  std::vector<glm::dvec3> sums(std::size_t((degree + 1) * (degree + 1)));
  const double place = 0.5 / std::sqrt(3.0); // from a texel's middle
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const glm::dvec3 light(map.texels[std::size_t(y) * std::size_t(map.width) + std::size_t(x)]);
      const double top = std::cos(std::numbers::pi * y / map.height);
      const double bottom = std::cos(std::numbers::pi * (y + 1) / map.height);
      for (const double right : {-place, place})
        for (const double up : {-place, place}) {
          const double turn = 2 * std::numbers::pi * ((x + 0.5 + right) / map.width - 0.5);
          const double height = (top + bottom) / 2 + up * (top - bottom); // equal areas
          const double r = std::sqrt(1 - height * height);
          const std::vector<double> values =
              harmonicsAt({r * std::sin(turn), height, -r * std::cos(turn)}, degree);
          for (std::size_t i = 0; i < sums.size(); ++i)
            sums[i] += 0.25 * solidAngle(map, y) * values[i] * light;
        }
    }
  return {degree, {sums.begin(), sums.end()}};
}

// By how much the cosine of a surface weakens harmonics of degree l: pi, 2 pi / 3, pi / 4, 0, ...
// (Ramamoorthi and Hanrahan, "An efficient representation for irradiance environment maps", 2001,
// equation 8).
inline double cosineFactor(int l) {
  if (l == 1) return 2 * std::numbers::pi / 3;
  if (l % 2 == 1) return 0;
  double factor = 2 * std::numbers::pi * (l % 4 == 0 ? -1 : 1) / ((l + 2.0) * (l - 1.0));
  for (int k = 1; k <= l / 2; ++k) factor *= (l / 2 + k) / (4.0 * k); // l! / (2^l (l/2)!^2)
  return factor;
}

// What falls on a surface with this normal; never less than 0.
inline glm::vec3 irradiance(const Harmonics& harmonics, const glm::vec3& normal) {
  const std::vector<double> values = harmonicsAt(glm::dvec3(normal), harmonics.degree);
  glm::dvec3 sum(0);
  std::size_t i = 0;
  for (int l = 0; l <= harmonics.degree; ++l)
    for (int m = -l; m <= l; ++m, ++i)
      sum += cosineFactor(l) * values[i] * glm::dvec3(harmonics.coefficients[i]);
  return glm::max(glm::vec3(sum), glm::vec3(0));
}

// What falls from the sun's disc on a surface with this normal; exact, also where the surface's
// plane cuts the disc.
//   Lambert: of radiance 1 it is half of the integral of n . (r x dr) around the outline of what is
//   seen. That is an arc of the disc's edge and, if the disc is cut, an arc in the surface's plane.
//   (Snyder, "Area light sources for real-time graphics", 1996, has the same for a sphere.)
inline glm::vec3 discIrradiance(const Sky& sky, const glm::vec3& normal) {
  // Of exactly unit length: of what follows, most cancels out where the disc has nearly set.
  const glm::dvec3 n = glm::normalize(glm::dvec3(normal));
  const glm::dvec3 s = glm::normalize(glm::dvec3(sky.sunDirection));
  const double height = glm::dot(n, s), slope = glm::length(glm::cross(n, s)); // cosine and sine
  const double c = std::cos(double(sky.sunRadius)), r = std::sin(double(sky.sunRadius));
  if (height <= -r) return glm::vec3(0);
  // Half of the disc's edge that is seen, as an angle about its middle; pi: all of it.
  const double half =
      height >= r ? std::numbers::pi : std::acos(std::clamp(-c * height / (r * slope), -1.0, 1.0));
  const double edge = half * r * r * height - r * c * slope * std::sin(half);
  const double plane =
      height >= r ? 0 : std::atan2(r * std::sin(half), c * slope - r * height * std::cos(half));
  return float(std::max(edge + plane, 0.0)) * sky.sunRadiance;
}

// A texel as a lamp: `towards` is the integral of the direction over it, so that
// dot(normal, towards) is its part in the irradiance of radiance 1, exactly if all of it is above
// the surface.
struct Lamp {
  glm::dvec3 towards;
  glm::dvec3 radiance;
};

inline std::vector<Lamp> lamps(const EnvironmentMap& map) {
  std::vector<Lamp> all;
  const auto area = [](double down) { return (down - std::sin(down) * std::cos(down)) / 2; };
  const double step = 2 * std::numbers::pi / map.width;
  for (int y = 0; y < map.height; ++y) {
    const double top = std::numbers::pi * y / map.height;
    const double bottom = std::numbers::pi * (y + 1) / map.height;
    const double level = 2 * std::sin(step / 2) * (area(bottom) - area(top));
    const double up = step * (std::pow(std::cos(top), 2) - std::pow(std::cos(bottom), 2)) / 2;
    for (int x = 0; x < map.width; ++x) {
      const double turn = step * (x + 0.5) - std::numbers::pi;
      all.push_back({{level * std::sin(turn), up, -level * std::cos(turn)},
                     map.texels[std::size_t(y) * std::size_t(map.width) + std::size_t(x)]});
    }
  }
  return all;
}

// What falls from all of them on a surface with this normal.
inline glm::vec3 irradiance(const std::vector<Lamp>& lamps, const glm::vec3& normal) {
  const glm::dvec3 n(normal);
  glm::dvec3 sum(0);
  for (const Lamp& lamp : lamps) sum += std::max(glm::dot(n, lamp.towards), 0.0) * lamp.radiance;
  return glm::vec3(sum);
}

// Irradiance by normal, to be looked up as the environment is by direction: of a sky, by harmonics
// of this degree and its sun's disc. To be within 1% of the brightest normal's, a clear day takes
// degree 2, a low sun over a bright horizon 4, and light from the horizon alone 8.
inline EnvironmentMap irradianceMap(const Sky& sky, int degree, int width) {
  Sky withoutSun = sky;
  withoutSun.sunRadiance = glm::vec3(0);
  const Harmonics harmonics = project(environmentMap(withoutSun, 64), degree);
  return tabulate(width, [&](const glm::vec3& normal) {
    return irradiance(harmonics, normal) + discIrradiance(sky, normal);
  });
}

// The light of a map in one of fewer texels, for irradiance: each texel's light goes to the texel
// that its middle lies in. None is lost, but even light comes out uneven.
//   width: even, at least 2
inline EnvironmentMap coarser(const EnvironmentMap& map, int width) {
  EnvironmentMap made{width, width / 2, {}};
  std::vector<glm::dvec3> sums(std::size_t(made.width) * std::size_t(made.height));
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const int u = int((x + 0.5) / map.width * made.width);
      const int v = int((y + 0.5) / map.height * made.height);
      sums[std::size_t(v) * std::size_t(made.width) + std::size_t(u)] +=
          solidAngle(map, y) *
          glm::dvec3(map.texels[std::size_t(y) * std::size_t(map.width) + std::size_t(x)]);
    }
  for (std::size_t i = 0; i < sums.size(); ++i)
    made.texels.emplace_back(sums[i] / solidAngle(made, int(i) / made.width));
  return made;
}

// The same of any environment, by brute force: width^2 / 2 times the texels of `map`.
inline EnvironmentMap irradianceMap(const EnvironmentMap& map, int width) {
  const std::vector<Lamp> all = lamps(map);
  return tabulate(width, [&](const glm::vec3& normal) { return irradiance(all, normal); });
}
