#include "truth_world.hpp"

#include <gg/mesh_data.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace deferred_truth {

namespace {

constexpr std::array<const char*, 3> kPaints{"matt", "gloss", "metal"};

/// A sphere of 48 x 24 flat pieces, 1 high, on y = 0.
truth::Objects::Object sphere() {
  constexpr std::uint32_t kColumns = 48, kRows = 24;
  truth::Objects::Object object;
  for (std::uint32_t row = 0; row <= kRows; ++row)
    for (std::uint32_t column = 0; column <= kColumns; ++column) {
      const double turn = 2 * std::numbers::pi * column / kColumns;
      const double up = std::numbers::pi * row / kRows; // from the lowest point
      const dvec3 normal(std::sin(up) * std::sin(turn), -std::cos(up),
                         std::sin(up) * std::cos(turn));
      object.normals.push_back(normal);
      object.triangles.positions.push_back(0.5 * normal + dvec3(0, 0.5, 0));
    }
  for (std::uint32_t row = 0; row < kRows; ++row)
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const std::uint32_t low = row * (kColumns + 1) + column, high = low + kColumns + 1;
      for (const std::uint32_t i : {low, low + 1, high + 1, low, high + 1, high})
        object.triangles.indices.push_back(i);
    }
  return object;
}

truth::Objects::Object objectOf(const gg::MeshData& mesh) {
  truth::Objects::Object object;
  object.triangles.indices = mesh.indices;
  for (const glm::vec3& p : mesh.positions) object.triangles.positions.emplace_back(p);
  for (const glm::vec3& n : mesh.normals) object.normals.emplace_back(n);
  return object;
}

/// Six colours that can be told apart.
dvec3 colorOf(int i) {
  const int k = i + 1;
  return {0.4 + 0.4 * (k & 1), 0.4 + 0.2 * (k & 2), 0.4 + 0.1 * (k & 4)};
}

} // namespace

Paint::Paint(const json& scene, const std::string& name, const dvec3& own)
    : material(scene, name), color(own),
      albedo(own * truth::vector(scene, "/materials/" + name + "/diffuse")),
      straight(truth::vector(scene, "/materials/" + name + "/specular")) {}

World::World(const json& scene, double time, int w, int h)
    : width(w), height(h), camera(scene, w, h) {
  std::vector<truth::Objects::Object> all;
  const double size = truth::number(scene, "/ground/size");
  truth::Objects::Object ground = objectOf(gg::plane(1, 1));
  for (dvec3& p : ground.triangles.positions) p *= dvec3(size, 1, size);
  all.push_back(std::move(ground));
  paints_.emplace_back(scene, "ground", dvec3(1));

  const std::array shapes{objectOf(gg::loadMeshData(scene.at("mesh").get<std::string>(), "")),
                          sphere(), objectOf(gg::box())};
  const double period = truth::number(scene, "/ring/period");
  const double turned = std::fmod(time, period) / period;
  const double radius = truth::number(scene, "/ring/radius");
  const double scale = truth::number(scene, "/ring/scale");
  const int count = scene.at("ring").at("count").get<int>();
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (double(i) / count + turned);
    truth::Objects::Object object = shapes[std::size_t(i % 3)];
    for (dvec3& p : object.triangles.positions)
      p = truth::aboutY(scale * p + dvec3(0, 0, radius), angle);
    for (dvec3& n : object.normals) n = truth::aboutY(n, angle);
    all.push_back(std::move(object));
    paints_.emplace_back(scene, kPaints[std::size_t((i + i / 3) % 3)], colorOf(i));
  }
  reach_ = size + radius + scale;
  objects_ = std::make_unique<truth::Objects>(std::move(all));
}

truth::Surface World::seen(int x, int y) const {
  return objects_->first(camera.eye, camera.through(x, y), camera.near, camera.far);
}

bool World::isHidden(const truth::Surface& surface, const dvec3& towards) const {
  // Single precision is good for 1e-7 of a coordinate.
  const dvec3 from =
      surface.position + 1e-6 * (glm::length(surface.position) + reach_) * surface.face;
  return objects_->rays().occluded(from, towards, std::numeric_limits<double>::infinity());
}

std::vector<truth::Surface> look(const World& world) {
  std::vector<truth::Surface> all;
  all.reserve(std::size_t(world.width) * std::size_t(world.height));
  for (int y = 0; y < world.height; ++y)
    for (int x = 0; x < world.width; ++x) all.push_back(world.seen(x, y));
  return all;
}

std::vector<bool> smooth(const World& world, const std::vector<truth::Surface>& surfaces) {
  const auto at = [&](int x, int y) -> const truth::Surface& {
    return surfaces[std::size_t(y) * std::size_t(world.width) + std::size_t(x)];
  };
  std::vector<bool> all;
  for (int y = 0; y < world.height; ++y)
    for (int x = 0; x < world.width; ++x) {
      bool same = true;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, world.height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, world.width - 1); ++u)
          same = same && truth::isSmooth(at(x, y), at(u, v));
      all.push_back(same);
    }
  return all;
}

Sky skyOf(const json& scene) {
  Sky sky;
  if (scene.at("sky").at("uniform").get<bool>())
    sky.zenith = sky.horizon = sky.ground = glm::vec3(0.5f), sky.glow = 0;
  const dvec3 towards = truth::vector(scene, "/light/position");
  sky.sunDirection = towards == dvec3(0) ? glm::vec3(0, 1, 0) : glm::vec3(glm::normalize(towards));
  const auto brightness = float(truth::number(scene, "/sky/brightness"));
  sky.zenith *= brightness, sky.horizon *= brightness, sky.ground *= brightness;
  sky.sunRadiance *= float(truth::number(scene, "/sun/brightness"));
  sky.sunRadius = float(truth::number(scene, "/sun/radius"));
  return sky;
}

dvec3 fresnel(const dvec3& straight, double cosine) {
  if (straight == dvec3(0)) return straight;
  return straight + (1.0 - straight) * std::pow(1 - std::max(cosine, 0.0), 5);
}

dvec3 display(const dvec3& light) {
  dvec3 shown;
  for (int c = 0; c < 3; ++c) {
    const double cut = std::min(light[c], 1.0);
    shown[c] = cut <= 0.0031308 ? 12.92 * cut : 1.055 * std::pow(cut, 1 / 2.4) - 0.055;
  }
  return shown;
}

} // namespace deferred_truth
