#include "truth_light.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace deferred_truth {

namespace {

constexpr double kPi = std::numbers::pi;

/// Two directions that are at right angles to a third and to each other; all of unit length.
std::pair<dvec3, dvec3> aside(const dvec3& normal) {
  const dvec3 other = std::abs(normal.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
  const dvec3 u = glm::normalize(glm::cross(normal, other));
  return {u, glm::cross(normal, u)};
}

dvec3 withoutSun(const Sky& sky, const dvec3& direction) {
  return {skyRadiance(sky, glm::vec3(direction))};
}

/// Directions spread evenly over the sun's disc, and the solid angle of each.
std::pair<std::vector<dvec3>, double> sunRays(const Sky& sky, int count) {
  const dvec3 middle = glm::normalize(dvec3(sky.sunDirection));
  const auto [u, v] = aside(middle);
  const double height = 1 - std::cos(double(sky.sunRadius)); // of the disc, a cap of the sphere
  std::vector<dvec3> rays;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - height * (i + 0.5) / count, r = std::sqrt(1 - z * z);
    const double turn = i * kPi * (3 - std::sqrt(5.0));
    rays.push_back(z * middle + r * (std::cos(turn) * u + std::sin(turn) * v));
  }
  return {rays, 2 * kPi * height / count};
}

} // namespace

std::vector<Kinds> shade(const World& world, const std::vector<truth::Surface>& surfaces,
                         const json& scene) {
  const dvec3 background = truth::vector(scene, "/background");
  const dvec3 lamp = truth::vector(scene, "/light/position");
  std::vector<Kinds> all;
  for (const truth::Surface& surface : surfaces) {
    Kinds& kinds = all.emplace_back();
    if (surface.id < 0) {
      kinds.diffuse = background;
      continue;
    }
    const Paint& paint = world.paint(surface);
    const truth::Lit lit =
        paint.material.lit(surface.normal, glm::normalize(lamp - surface.position),
                           glm::normalize(world.camera.eye - surface.position));
    kinds = {paint.color * lit.diffuse, lit.specular, paint.color * lit.ambient};
  }
  return all;
}

std::vector<dvec3> compose(const World& world, const std::vector<Kinds>& kinds, bool edges) {
  const auto at = [&](int x, int y) -> const Kinds& {
    x = std::clamp(x, 0, world.width - 1), y = std::clamp(y, 0, world.height - 1);
    return kinds[std::size_t(y) * std::size_t(world.width) + std::size_t(x)];
  };
  std::vector<dvec3> all;
  for (int y = 0; y < world.height; ++y)
    for (int x = 0; x < world.width; ++x) {
      dvec3 light = at(x, y).diffuse;
      if (edges)
        light = glm::max(5.0 * light - at(x - 1, y).diffuse - at(x + 1, y).diffuse -
                             at(x, y - 1).diffuse - at(x, y + 1).diffuse,
                         dvec3(0));
      all.push_back(light + at(x, y).specular + at(x, y).ambient);
    }
  return all;
}

OpenSky::OpenSky(const Sky& sky) {
  constexpr int kRows = 96, kColumns = 192; // equal steps of height are equal solid angles
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const double y = 1 - 2 * (row + 0.5) / kRows, r = std::sqrt(1 - y * y);
      const double turn = 2 * kPi * (column + 0.5) / kColumns;
      const dvec3 towards(r * std::cos(turn), y, r * std::sin(turn));
      rays_.push_back({towards, 4 * kPi / (kRows * kColumns) * withoutSun(sky, towards)});
    }
  const auto [rays, angle] = sunRays(sky, 64);
  for (const dvec3& towards : rays) rays_.push_back({towards, angle * dvec3(sky.sunRadiance)});
}

dvec3 OpenSky::irradiance(const dvec3& normal) const {
  dvec3 sum(0);
  for (const Ray& ray : rays_) sum += std::max(glm::dot(normal, ray.towards), 0.0) * ray.light;
  return sum;
}

dvec3 visibleIrradiance(const World& world, const truth::Surface& surface, const Sky& sky,
                        double turn) {
  constexpr int kSky = 256, kSun = 16;
  const auto [u, v] = aside(surface.normal);
  dvec3 sum(0);
  for (int i = 0; i < kSky; ++i) {
    double inverse = 0, digit = 0.5; // i's binary digits behind the point, backwards
    for (int rest = i; rest > 0; rest /= 2, digit /= 2) inverse += digit * (rest % 2);
    // As dense as the cosine: even over the disc that the directions are seen in from above.
    const double r = std::sqrt((i + 0.5) / kSky), angle = 2 * kPi * (inverse + turn);
    dvec3 towards =
        r * (std::cos(angle) * u + std::sin(angle) * v) + std::sqrt(1 - r * r) * surface.normal;
    const dvec3 light = kPi / kSky * withoutSun(sky, towards);
    // A flat triangle that stands for a round surface hides nothing from itself.
    const double above = glm::dot(towards, surface.face);
    if (above < 0) towards -= 2 * above * surface.face;
    if (!world.isHidden(surface, towards)) sum += light;
  }
  if (sky.sunRadiance == glm::vec3(0)) return sum;
  const auto [rays, angle] = sunRays(sky, kSun);
  for (const dvec3& towards : rays) {
    const double cosine = glm::dot(surface.normal, towards);
    if (cosine > 0 && !world.isHidden(surface, towards))
      sum += cosine * angle * dvec3(sky.sunRadiance);
  }
  return sum;
}

std::vector<dvec3> lightOf(const World& world, const std::vector<truth::Surface>& surfaces,
                           const Sky& sky, bool visible) {
  const OpenSky open(sky);
  std::vector<dvec3> all;
  for (int y = 0; y < world.height; ++y)
    for (int x = 0; x < world.width; ++x) {
      const truth::Surface& surface = surfaces[all.size()];
      const dvec3 view = glm::normalize(world.camera.through(x, y));
      if (surface.id < 0) {
        all.emplace_back(radiance(sky, glm::vec3(view)));
        continue;
      }
      const Paint& paint = world.paint(surface);
      const dvec3 share = fresnel(paint.straight, -glm::dot(surface.normal, view));
      dvec3 light(0);
      if (paint.albedo != dvec3(0)) {
        const double turn = 0.618034 * x + 0.754878 * y; // neighbours' rays lie between each other
        light = (1.0 - share) * paint.albedo / kPi *
                (visible ? visibleIrradiance(world, surface, sky, turn)
                         : open.irradiance(surface.normal));
      }
      if (share != dvec3(0))
        light += share * dvec3(radiance(sky, glm::vec3(glm::reflect(view, surface.normal))));
      all.push_back(light);
    }
  return all;
}

} // namespace deferred_truth
