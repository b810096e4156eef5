#include "truth/scene.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ggrade::truth {

namespace {

using nlohmann::json;

/// Where `up` says nothing about a camera, see gg::Camera::view().
dvec3 usableUp(const dvec3& forward, const dvec3& up) {
  if (glm::length(glm::cross(forward, glm::normalize(up))) > 1e-5) return up;
  if (std::abs(forward.y) > 0.5) return {0, 0, forward.y < 0 ? -1 : 1};
  return {0, 1, 0};
}

RayScene raysOf(const std::vector<Objects::Object>& objects) {
  std::vector<Triangles> all;
  for (const Objects::Object& object : objects) all.push_back(object.triangles);
  return RayScene(std::move(all));
}

} // namespace

double number(const json& scene, const std::string& key) {
  return scene.at(json::json_pointer(key)).get<double>();
}

dvec3 vector(const json& scene, const std::string& key) {
  const auto v = scene.at(json::json_pointer(key)).get<std::vector<double>>();
  return {v.at(0), v.at(1), v.at(2)};
}

dvec3 aboutY(const dvec3& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

Camera::Camera(const json& scene, int w, int h)
    : eye(vector(scene, "/camera/position")),
      forward(glm::normalize(vector(scene, "/camera/target") - eye)),
      near(number(scene, "/camera/near")), far(number(scene, "/camera/far")), width(w), height(h) {
  const double tangent = std::tan(number(scene, "/camera/fov") / 2);
  const dvec3 aside =
      glm::normalize(glm::cross(forward, usableUp(forward, vector(scene, "/camera/up"))));
  up = tangent * glm::cross(aside, forward);
  right = tangent * w / h * aside;
}

dvec3 Camera::through(int x, int y) const {
  return forward + (2 * (x + 0.5) / width - 1) * right + (1 - 2 * (y + 0.5) / height) * up;
}

Material::Material(const json& scene, const std::string& name) {
  const std::string path = "/materials/" + name;
  ambient = vector(scene, path + "/ambient") * vector(scene, "/light/ambient");
  diffuse = vector(scene, path + "/diffuse") * vector(scene, "/light/diffuse");
  specular = vector(scene, path + "/specular") * vector(scene, "/light/specular");
  shininess = number(scene, path + "/shininess");
}

Lit Material::lit(const dvec3& normal, const dvec3& toLight, const dvec3& toEye) const {
  const dvec3 halfway = glm::normalize(toLight + toEye);
  const double facing = glm::dot(normal, toLight);
  const double highlight =
      facing > 0 ? std::pow(std::max(glm::dot(normal, halfway), 1e-6), shininess) : 0;
  return {ambient, std::max(facing, 0.0) * diffuse, highlight * specular};
}

bool continues(const Surface& a, const Surface& b) {
  if (a.id != b.id) return false;
  if (a.id < 0) return true;
  const dvec3 step = b.position - a.position;
  return std::abs(glm::dot(a.normal, step)) <= 0.9 * glm::length(step);
}

bool isSmooth(const Surface& a, const Surface& b) {
  return continues(a, b) && (a.id < 0 || glm::dot(a.normal, b.normal) > std::numbers::sqrt2 / 2);
}

Objects::Objects(std::vector<Object> objects) : rays_(raysOf(objects)) {
  for (Object& object : objects) {
    for (const dvec3& p : object.triangles.positions) reach_ = std::max(reach_, glm::length(p));
    indices_.push_back(std::move(object.triangles.indices));
    normals_.push_back(std::move(object.normals));
  }
}

Surface Objects::first(const dvec3& origin, const dvec3& direction, double from, double to) const {
  Surface surface;
  if (!(from < to)) return surface;
  const auto hit = rays_.closestHit(origin, direction, from, to, Faces::front);
  if (!hit) return surface;
  surface.id = int(hit->mesh);
  surface.position = origin + hit->distance * direction;
  const std::uint32_t* corners = &indices_[hit->mesh][3 * std::size_t(hit->triangle)];
  for (int k = 0; k < 3; ++k) surface.normal += hit->weights[k] * normals_[hit->mesh][corners[k]];
  surface.normal = glm::normalize(surface.normal);
  surface.face = hit->normal;
  return surface;
}

bool Objects::hide(const Surface& surface, const dvec3& light) const {
  // Single precision is good for 1e-7 of a coordinate.
  const double lift = 1e-6 * (glm::length(surface.position) + reach_);
  const dvec3 from = surface.position + lift * surface.face;
  const double distance = glm::distance(from, light);
  const auto hit = rays_.closestHit(from, (light - from) / distance, 0, distance);
  return hit && hit->distance < distance - lift; // the light may stand on a surface, too
}

dvec3 cut(const dvec3& light) {
  return glm::clamp(light, dvec3(0), dvec3(1));
}

} // namespace ggrade::truth
