#include "truth_world.hpp"

#include <gg/mesh_data.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace floor_truth {

namespace {

/// An object's own colour.
dvec3 colorOf(int i) {
  return {(i & 1) * 0.4 + 0.4, (i & 2) * 0.2 + 0.4, (i & 4) * 0.1 + 0.4};
}

bool flag(const json& scene, const char* key) {
  return scene.at(json::json_pointer(key)).get<bool>();
}

} // namespace

World::World(const json& scene, double time, int w, int h)
    : width(w), height(h), camera_(scene, w, h), object_(scene, "object"), floor_(scene, "floor") {
  mirror = flag(scene, "/effects/mirror");
  shadow = flag(scene, "/effects/shadow");
  bloom = flag(scene, "/effects/bloom");
  background = vector(scene, "/background");
  light = vector(scene, "/light/position");
  floorSpecular = vector(scene, "/materials/floor/specular");
  glow_ = number(scene, "/ring/glow");
  tilesPerUnit_ = number(scene, "/floor/tiles_per_unit");
  halfWidth_ = number(scene, "/floor/width") / 2, halfDepth_ = number(scene, "/floor/depth") / 2;

  const gg::MeshData mesh = gg::loadMeshData(scene.at("mesh").get<std::string>(), "");
  const int count = scene.at("ring").at("count").get<int>();
  const double scale = number(scene, "/ring/scale"), radius = number(scene, "/ring/radius");
  const double base = number(scene, "/ring/base"), hop = number(scene, "/ring/hop");
  const double cycle = number(scene, "/ring/cycle"), t = std::fmod(time, cycle) / cycle;
  const double phase = std::fmod(36 * t, 2) - 1; // two turns, eighteen hops a cycle
  const dvec3 place(0, base + hop * (1 - phase * phase), radius);
  std::vector<truth::Objects::Object> objects;
  for (int i = 1; i <= count; ++i) {
    const double angle = std::numbers::pi * (2.0 * i / count - 4 * t);
    truth::Objects::Object& object = objects.emplace_back();
    object.triangles.indices = mesh.indices;
    for (const glm::vec3& p : mesh.positions)
      object.triangles.positions.push_back(aboutY(scale * dvec3(p) + place, angle));
    for (const glm::vec3& n : mesh.normals) object.normals.push_back(aboutY(dvec3(n), angle));
  }
  objects_ = std::make_unique<truth::Objects>(std::move(objects));

  // Every hop lies in a cylinder about the y axis, and that in a ball.
  double wide = 0, low = 1e300, high = -1e300;
  for (const glm::vec3& p : mesh.positions) {
    wide = std::max(wide, std::hypot(double(p.x), double(p.z)));
    low = std::min(low, double(p.y)), high = std::max(high, double(p.y));
  }
  low = base + scale * low, high = base + hop + scale * high;
  ballMiddle = {0, (low + high) / 2, 0};
  ballRadius = std::hypot(radius + scale * wide, (high - low) / 2);
}

Surface World::object(const dvec3& origin, const dvec3& direction, double from, double to) const {
  Surface surface = objects_->first(origin, direction, from, to);
  if (surface.id != kNothing) ++surface.id;
  return surface;
}

Seen World::seen(int x, int y) const {
  const dvec3 direction = camera_.through(x, y), eye = camera_.eye;
  Seen seen;
  seen.toEye = -glm::normalize(direction);
  seen.surface = object(eye, direction, camera_.near, camera_.far);

  const double atFloor = -eye.y / direction.y;
  const dvec3 point = eye + atFloor * direction;
  // Behind an object that is hit first there is no floor. It is seen from above alone.
  const bool hidden =
      seen.surface.id != kNothing &&
      glm::dot(seen.surface.position - eye, direction) < glm::dot(point - eye, direction);
  if (eye.y > 0 && direction.y < 0 && atFloor >= camera_.near && atFloor <= camera_.far &&
      !hidden && std::abs(point.x) <= halfWidth_ && std::abs(point.z) <= halfDepth_)
    seen.surface = {kFloor, {point.x, 0, point.z}, {0, 1, 0}, {0, 1, 0}};

  // The eye and the ray mirrored. Only what lies above the plane has a reflection: the ray counts
  // from where it comes up through the plane, which for a pixel of the floor is the point above.
  const dvec3 flip(1, -1, 1);
  seen.reflection = background;
  if (mirror && eye.y > 0 && direction.y < 0) {
    seen.reflected =
        object(eye * flip, direction * flip, std::max(camera_.near, atFloor), camera_.far);
    if (seen.reflected.id != kNothing)
      seen.reflection = color(seen.reflected, seen.toEye * flip, visibility(seen.reflected));
  }
  if (!bloom) seen.reflection = cut(seen.reflection);
  return seen;
}

dvec3 World::color(const Surface& surface, const dvec3& toEye, double visible) const {
  if (surface.id == kNothing) return background;
  const bool isFloor = surface.id == kFloor;
  const truth::Lit lit = (isFloor ? floor_ : object_)
                             .lit(surface.normal, glm::normalize(light - surface.position), toEye);

  dvec3 albedo, own(0);
  if (isFloor) {
    const double tile = std::floor(surface.position.x * tilesPerUnit_) +
                        std::floor(surface.position.z * tilesPerUnit_);
    albedo = std::fmod(std::abs(tile), 2) == 0 ? dvec3(0.9) : dvec3(0.6, 0.7, 0.8);
  } else {
    albedo = colorOf(surface.id);
    if (surface.id % 2 == 1) own = glow_ * albedo * albedo;
  }
  return albedo * (lit.ambient + visible * lit.diffuse) + visible * lit.specular + own;
}

bool World::inShadow(const Surface& surface) const {
  return objects_->hide(surface, light);
}

double World::shareOfLight(const Surface& surface, double radius) const {
  constexpr int kPlaces = 128;
  const dvec3 toLight = glm::normalize(light - surface.position);
  const dvec3 aside = std::abs(toLight.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
  const dvec3 u = glm::normalize(glm::cross(toLight, aside)), v = glm::cross(toLight, u);
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  int seen = 0;
  for (int i = 0; i < kPlaces; ++i) {
    const double r = radius * std::sqrt((i + 0.5) / kPlaces), angle = i * golden;
    const dvec3 place = light + r * (std::cos(angle) * u + std::sin(angle) * v);
    if (!objects_->hide(surface, place)) ++seen;
  }
  return double(seen) / kPlaces;
}

bool World::onTileLine(const Surface& surface) const {
  const auto near = [&](double along) {
    const double tiles = along * tilesPerUnit_;
    return std::abs(tiles - std::round(tiles)) < 1e-5 * std::max(std::abs(tiles), 1.0);
  };
  return surface.id == kFloor && (near(surface.position.x) || near(surface.position.z));
}

dvec3 World::shown(const Seen& seen, double visible) const {
  dvec3 all = color(seen.surface, seen.toEye, visible);
  if (mirror && seen.surface.id == kFloor) all += floorSpecular * seen.reflection;
  return all;
}

World worldOf(const truth::Rendered& rendered) {
  return {rendered.scene, rendered.time, rendered.window.width(), rendered.window.height()};
}

World worldWithoutBloom(const truth::Rendered& rendered, const std::string& whose) {
  World world = worldOf(rendered);
  if (world.bloom)
    throw std::invalid_argument(whose +
                                " truth is for scenes without bloom: set effects.bloom to false");
  return world;
}

std::vector<Seen> look(const World& world) {
  std::vector<Seen> all;
  all.reserve(std::size_t(world.width) * std::size_t(world.height));
  for (int y = 0; y < world.height; ++y)
    for (int x = 0; x < world.width; ++x) all.push_back(world.seen(x, y));
  return all;
}

} // namespace floor_truth
