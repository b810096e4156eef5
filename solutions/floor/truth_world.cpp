#include "truth_world.hpp"

#include <gg/mesh_data.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace floor_truth {

namespace {

const json& at(const json& scene, const char* key) {
  return scene.at(json::json_pointer(key));
}
double number(const json& scene, const char* key) {
  return at(scene, key).get<double>();
}
dvec3 vector(const json& scene, const std::string& key) {
  const auto v = at(scene, key.c_str()).get<std::vector<double>>();
  return {v.at(0), v.at(1), v.at(2)};
}

/// An object's own colour.
dvec3 colorOf(int i) {
  return {(i & 1) * 0.4 + 0.4, (i & 2) * 0.2 + 0.4, (i & 4) * 0.1 + 0.4};
}

/// Where `up` says nothing about a camera, see gg::Camera::view().
dvec3 usableUp(const dvec3& forward, const dvec3& up) {
  if (glm::length(glm::cross(forward, glm::normalize(up))) > 1e-5) return up;
  if (std::abs(forward.y) > 0.5) return {0, 0, forward.y < 0 ? -1 : 1};
  return {0, 1, 0};
}

dvec3 aboutY(const dvec3& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

} // namespace

World::World(const json& scene, double time, int w, int h) : width(w), height(h) {
  mirror = at(scene, "/effects/mirror").get<bool>();
  shadow = at(scene, "/effects/shadow").get<bool>();
  bloom = at(scene, "/effects/bloom").get<bool>();
  background = vector(scene, "/background");
  light = vector(scene, "/light/position");

  eye_ = vector(scene, "/camera/position");
  forward_ = glm::normalize(vector(scene, "/camera/target") - eye_);
  const double tangent = std::tan(number(scene, "/camera/fov") / 2);
  const dvec3 right =
      glm::normalize(glm::cross(forward_, usableUp(forward_, vector(scene, "/camera/up"))));
  up_ = tangent * glm::cross(right, forward_);
  right_ = tangent * w / h * right;
  near_ = number(scene, "/camera/near"), far_ = number(scene, "/camera/far");

  object_ = material(scene, "object"), floor_ = material(scene, "floor");
  floorSpecular = vector(scene, "/materials/floor/specular");
  glow_ = number(scene, "/ring/glow");
  tilesPerUnit_ = number(scene, "/floor/tiles_per_unit");
  halfWidth_ = number(scene, "/floor/width") / 2, halfDepth_ = number(scene, "/floor/depth") / 2;

  const gg::MeshData mesh = gg::loadMeshData(at(scene, "/mesh").get<std::string>(), "");
  indices_ = mesh.indices;
  const int count = at(scene, "/ring/count").get<int>();
  const double scale = number(scene, "/ring/scale"), radius = number(scene, "/ring/radius");
  const double base = number(scene, "/ring/base"), hop = number(scene, "/ring/hop");
  const double cycle = number(scene, "/ring/cycle"), t = std::fmod(time, cycle) / cycle;
  const double phase = std::fmod(36 * t, 2) - 1; // two turns, eighteen hops a cycle
  const dvec3 place(0, base + hop * (1 - phase * phase), radius);
  std::vector<truth::Triangles> objects;
  for (int i = 1; i <= count; ++i) {
    const double angle = std::numbers::pi * (2.0 * i / count - 4 * t);
    truth::Triangles object;
    object.indices = mesh.indices;
    for (const glm::vec3& p : mesh.positions)
      object.positions.push_back(aboutY(scale * dvec3(p) + place, angle));
    std::vector<dvec3>& normals = normals_.emplace_back();
    for (const glm::vec3& n : mesh.normals) normals.push_back(aboutY(dvec3(n), angle));
    objects.push_back(std::move(object));
  }
  rays_ = std::make_unique<truth::RayScene>(std::move(objects));

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

World::Material World::material(const json& scene, const char* name) const {
  const std::string path = std::string("/materials/") + name;
  return {vector(scene, path + "/ambient") * vector(scene, "/light/ambient"),
          vector(scene, path + "/diffuse") * vector(scene, "/light/diffuse"),
          vector(scene, path + "/specular") * vector(scene, "/light/specular"),
          number(scene, (path + "/shininess").c_str())};
}

Surface World::object(const dvec3& origin, const dvec3& direction, double from, double to) const {
  Surface surface;
  if (!(from < to)) return surface;
  const auto hit = rays_->closestHit(origin, direction, from, to, truth::Faces::front);
  if (!hit) return surface;
  surface.id = int(hit->mesh) + 1;
  surface.position = origin + hit->distance * direction;
  const std::uint32_t* corners = &indices_[3 * std::size_t(hit->triangle)];
  for (int k = 0; k < 3; ++k) surface.normal += hit->weights[k] * normals_[hit->mesh][corners[k]];
  surface.normal = glm::normalize(surface.normal);
  surface.face = hit->normal;
  return surface;
}

Seen World::seen(int x, int y) const {
  // One length of `direction` is one unit of depth: near and far plane are distances on the ray.
  const dvec3 direction =
      forward_ + (2 * (x + 0.5) / width - 1) * right_ + (1 - 2 * (y + 0.5) / height) * up_;
  Seen seen;
  seen.toEye = -glm::normalize(direction);
  seen.surface = object(eye_, direction, near_, far_);

  const double atFloor = -eye_.y / direction.y;
  const dvec3 point = eye_ + atFloor * direction;
  // Behind an object that is hit first there is no floor. It is seen from above alone.
  const bool hidden =
      seen.surface.id != kNothing &&
      glm::dot(seen.surface.position - eye_, direction) < glm::dot(point - eye_, direction);
  if (eye_.y > 0 && direction.y < 0 && atFloor >= near_ && atFloor <= far_ && !hidden &&
      std::abs(point.x) <= halfWidth_ && std::abs(point.z) <= halfDepth_)
    seen.surface = {kFloor, {point.x, 0, point.z}, {0, 1, 0}, {0, 1, 0}};

  // The eye and the ray mirrored. Only what lies above the plane has a reflection: the ray counts
  // from where it comes up through the plane, which for a pixel of the floor is the point above.
  const dvec3 flip(1, -1, 1);
  seen.reflection = background;
  if (mirror && eye_.y > 0 && direction.y < 0) {
    seen.reflected = object(eye_ * flip, direction * flip, std::max(near_, atFloor), far_);
    if (seen.reflected.id != kNothing)
      seen.reflection = color(seen.reflected, seen.toEye * flip, visibility(seen.reflected));
  }
  if (!bloom) seen.reflection = cut(seen.reflection);
  return seen;
}

dvec3 World::color(const Surface& surface, const dvec3& toEye, double visible) const {
  if (surface.id == kNothing) return background;
  const bool isFloor = surface.id == kFloor;
  const Material& of = isFloor ? floor_ : object_;
  const dvec3 toLight = glm::normalize(light - surface.position);
  const dvec3 halfway = glm::normalize(toLight + toEye);
  const double facing = glm::dot(surface.normal, toLight);
  const double highlight =
      facing > 0 ? std::pow(std::max(glm::dot(surface.normal, halfway), 1e-6), of.shininess) : 0;

  dvec3 albedo, own(0);
  if (isFloor) {
    const double tile = std::floor(surface.position.x * tilesPerUnit_) +
                        std::floor(surface.position.z * tilesPerUnit_);
    albedo = std::fmod(std::abs(tile), 2) == 0 ? dvec3(0.9) : dvec3(0.6, 0.7, 0.8);
  } else {
    albedo = colorOf(surface.id);
    if (surface.id % 2 == 1) own = glow_ * albedo * albedo;
  }
  return albedo * (of.ambient + visible * std::max(facing, 0.0) * of.diffuse) +
         visible * highlight * of.specular + own;
}

bool World::hidden(const Surface& surface, const dvec3& from) const {
  const dvec3 toLight = from - surface.position;
  const double distance = glm::length(toLight);
  // Single precision is good for 1e-7 of a coordinate.
  const double lift = 1e-6 * (glm::length(surface.position) + distance);
  return rays_->occluded(surface.position + lift * surface.face, toLight / distance, distance);
}

bool World::inShadow(const Surface& surface) const {
  return hidden(surface, light);
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
    if (!hidden(surface, light + r * (std::cos(angle) * u + std::sin(angle) * v))) ++seen;
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

bool continues(const Surface& a, const Surface& b) {
  if (a.id != b.id) return false;
  if (a.id == kNothing) return true;
  const dvec3 step = b.position - a.position;
  return std::abs(glm::dot(a.normal, step)) <= 0.9 * glm::length(step);
}

std::string keyOf(const truth::Rendered& rendered) {
  json scene = rendered.scene;
  scene.erase("quality");
  return json::array({scene, rendered.time, rendered.truth, rendered.window.width(),
                      rendered.window.height()})
      .dump();
}

dvec3 cut(const dvec3& light) {
  return glm::clamp(light, dvec3(0), dvec3(1));
}

Image shownDifference(const Image& a, const Image& b) {
  Image out(a.width(), a.height(), 3);
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      for (int c = 0; c < 3; ++c)
        out.at(x, y, c) = std::min(4 * std::abs(a.at(x, y, c) - b.at(x, y, c)), 1.0f);
  return out;
}

} // namespace floor_truth
