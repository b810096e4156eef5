#include "truth_room.hpp"

#include <gg/mesh_data.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shadow_volume_truth {

namespace {

constexpr double kTellable = 4.0 / 255;

// Cornell University Program of Computer Graphics, "Cornell Box Data", in units of 100 mm; the
// origin is moved to the middle of the front edge of the floor.
const dvec3 kSize(5.528, 5.488, 5.592);
const dvec3 kWhite(0.73, 0.71, 0.68), kRed(0.63, 0.06, 0.05), kGreen(0.14, 0.45, 0.09);
/// The top faces, x and z in millimetres as published, and their height.
struct Block {
  std::array<std::array<double, 2>, 4> corners;
  double height;
};
const Block kShort = {{{{130, 65}, {82, 225}, {240, 272}, {290, 114}}}, 165};
const Block kTall = {{{{423, 247}, {265, 296}, {314, 456}, {472, 406}}}, 330};

/// Adds a face of four corners, each with its normal, counterclockwise from the front.
void addFace(truth::Objects::Object& object, const std::array<dvec3, 4>& corners) {
  const auto first = std::uint32_t(object.triangles.positions.size());
  const dvec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  for (const dvec3& corner : corners) {
    object.triangles.positions.push_back(corner);
    object.normals.push_back(normal);
  }
  for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u})
    object.triangles.indices.push_back(first + i);
}

/// About the middle of the floor.
void addBlock(truth::Objects::Object& object, const Block& block) {
  std::array<dvec3, 4> top, bottom;
  for (std::size_t i = 0; i < 4; ++i) {
    top[i] = {block.corners[i][0] / 100 - kSize.x / 2, block.height / 100,
              block.corners[i][1] / 100 - kSize.z / 2};
    bottom[i] = {top[i].x, 0, top[i].z};
  }
  addFace(object, top);
  addFace(object, {bottom[3], bottom[2], bottom[1], bottom[0]});
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    addFace(object, {bottom[i], bottom[next], top[next], top[i]});
  }
}

/// In model space: its foot is in the origin.
truth::Objects::Object casterOf(const std::string& mesh) {
  truth::Objects::Object object;
  if (mesh == "none") return object;
  if (mesh == "blocks") {
    addBlock(object, kShort);
    addBlock(object, kTall);
    return object;
  }
  const gg::MeshData data = gg::loadMeshData(mesh, "");
  object.triangles.indices = data.indices;
  for (const glm::vec3& p : data.positions) object.triangles.positions.emplace_back(p);
  for (const glm::vec3& n : data.normals) object.normals.emplace_back(n);
  return object;
}

/// As large as the room allows: as high as the tall block or, if it is wide, 3.6 wide.
double fitOf(const truth::Objects::Object& object) {
  dvec3 low(1e300), high(-1e300);
  for (const dvec3& p : object.triangles.positions)
    low = glm::min(low, p), high = glm::max(high, p);
  const dvec3 size = high - low;
  return std::min(3.3 / std::max(size.y, 0.1), 3.6 / std::max({size.x, size.z, 0.1}));
}

} // namespace

Room::Room(const json& scene, double time, int w, int h)
    : width(w), height(h), shadow(scene.at("effects").at("shadow").get<bool>()),
      background(truth::vector(scene, "/background")), camera(scene, w, h), wall_(scene, "wall"),
      caster_(scene, "caster") {
  const double period = truth::number(scene, "/orbit/period");
  const double angle = 2 * std::numbers::pi * std::fmod(time, period) / period;
  lamp = truth::vector(scene, "/light/position") +
         truth::number(scene, "/orbit/radius") * dvec3(std::cos(angle), 0, std::sin(angle));

  const double scale = truth::number(scene, "/room/scale");
  const dvec3 half = scale * kSize / 2.0, middle(0, half.y, half.z);
  const auto wall = [&](const dvec3& normal, const dvec3& color) {
    return Wall{middle - half * normal, normal, half * (1.0 - glm::abs(normal)), color};
  };
  walls_ = {wall({0, 1, 0}, kWhite), wall({0, -1, 0}, kWhite), wall({0, 0, -1}, kWhite),
            wall({-1, 0, 0}, kRed), wall({1, 0, 0}, kGreen)};

  const std::string mesh = scene.at("mesh").get<std::string>();
  truth::Objects::Object object = casterOf(mesh);
  const double fit = mesh == "blocks" || mesh == "none" ? 1 : fitOf(object);
  const double turn = truth::number(scene, "/caster/turn");
  const dvec3 foot(0, truth::number(scene, "/caster/lift"), kSize.z / 2);
  for (dvec3& p : object.triangles.positions) p = scale * (foot + truth::aboutY(fit * p, turn));
  for (dvec3& n : object.normals) n = truth::aboutY(n, turn);
  std::vector<truth::Objects::Object> all;
  all.push_back(std::move(object));
  objects_ = std::make_unique<truth::Objects>(std::move(all));
}

Surface Room::seen(int x, int y) const {
  const dvec3 direction = camera.through(x, y);
  Surface nearest = objects_->first(camera.eye, direction, camera.near, camera.far);
  double distance = camera.far;
  if (nearest.id != kNothing)
    distance = glm::dot(nearest.position - camera.eye, direction) / glm::dot(direction, direction);
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    const Wall& wall = walls_[i];
    const double slope = glm::dot(direction, wall.normal);
    if (slope >= 0) continue; // seen from behind
    const double at = glm::dot(wall.middle - camera.eye, wall.normal) / slope;
    if (at < camera.near || at >= distance) continue;
    dvec3 point = camera.eye + at * direction;
    const dvec3 aside = glm::abs(point - wall.middle) * (1.0 - glm::abs(wall.normal));
    if (aside.x > wall.half.x || aside.y > wall.half.y || aside.z > wall.half.z) continue;
    nearest = {int(i) + 1, point, wall.normal, wall.normal};
    distance = at;
  }
  return nearest;
}

dvec3 Room::color(const Surface& surface, double visible) const {
  if (surface.id == kNothing) return background;
  const dvec3 albedo = surface.id == kCaster ? kWhite : walls_[std::size_t(surface.id - 1)].color;
  const truth::Lit lit = (surface.id == kCaster ? caster_ : wall_)
                             .lit(surface.normal, glm::normalize(lamp - surface.position),
                                  glm::normalize(camera.eye - surface.position));
  return albedo * (lit.ambient + visible * lit.diffuse) + visible * lit.specular;
}

bool Room::isAverted(const Surface& surface) const {
  return glm::dot(surface.face, lamp - surface.position) <= 0;
}

bool Room::inShadow(const Surface& surface) const {
  return surface.id != kNothing &&
         ((surface.id == kCaster && isAverted(surface)) || objects_->hide(surface, lamp));
}

bool Room::isHidden(const dvec3& point) const {
  return objects_->rays().occluded(point, lamp - point, glm::distance(lamp, point));
}

bool Room::isInCaster(const dvec3& point) const {
  const dvec3 anywhere(0.36, 0.48, 0.8); // a direction that no face of the scenes has
  const auto hit = objects_->rays().closestHit(point, anywhere);
  return hit && glm::dot(hit->normal, anywhere) > 0;
}

bool Room::nearPlaneIsHidden() const {
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (isHidden(camera.eye + camera.near * camera.through(x, y))) return true;
  return false;
}

std::vector<Surface> look(const Room& room) {
  std::vector<Surface> all;
  all.reserve(std::size_t(room.width) * std::size_t(room.height));
  for (int y = 0; y < room.height; ++y)
    for (int x = 0; x < room.width; ++x) all.push_back(room.seen(x, y));
  return all;
}

Shadows shadowsOf(const truth::Rendered& rendered) {
  const Room room(rendered.scene, rendered.time, rendered.window.width(), rendered.window.height());
  const std::vector<Surface> all = look(room);
  Shadows made{Image(room.width, room.height, 3), {}};
  for (const Surface& surface : all) {
    Point& point = made.points.emplace_back();
    point.isSurface = surface.id != kNothing;
    point.inShadow = room.shadow && room.inShadow(surface);
    point.isAverted = room.isAverted(surface);
    point.counts = point.isSurface && !point.isAverted;
    point.lit = truth::cut(room.color(surface, 1)), point.dark = truth::cut(room.color(surface, 0));
    const dvec3 apart = glm::abs(point.lit - point.dark);
    point.tellable = std::max({apart.x, apart.y, apart.z}) >= kTellable;
  }
  const auto index = [&](int x, int y) {
    return std::size_t(y) * std::size_t(room.width) + std::size_t(x);
  };
  for (int y = 0; y < room.height; ++y)
    for (int x = 0; x < room.width; ++x) {
      Point& here = made.points[index(x, y)];
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, room.height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, room.width - 1); ++u)
          if (!truth::isSmooth(all[index(x, y)], all[index(u, v)]) ||
              made.points[index(u, v)].isAverted != here.isAverted ||
              made.points[index(u, v)].inShadow != here.inShadow)
            here.counts = false;
      const dvec3& color = here.inShadow ? here.dark : here.lit;
      for (int c = 0; c < 3; ++c) made.picture.at(x, y, c) = float(color[c]);
    }
  return made;
}

Counts count(const Shadows& shadows, const Image& window, Image* difference) {
  if (difference) *difference = Image(window.width(), window.height(), 3);
  Counts counts;
  for (int y = 0; y < window.height(); ++y)
    for (int x = 0; x < window.width(); ++x) {
      const Point& point =
          shadows.points[std::size_t(y) * std::size_t(window.width()) + std::size_t(x)];
      if (!point.counts || !point.tellable) continue;
      ++(point.inShadow ? counts.dark : counts.lit);
      const auto pixel = window.pixel(x, y);
      const dvec3 color(pixel[0], pixel[1], pixel[2]);
      const double toDark = glm::distance(color, point.dark);
      const double toLit = glm::distance(color, point.lit);
      if (std::min(toDark, toLit) > kTellable) ++counts.strange;
      const bool showsShadow = toDark < toLit;
      if (showsShadow == point.inShadow) continue;
      ++(showsShadow ? counts.falseShadow : counts.falseLight);
      if (difference) difference->at(x, y, showsShadow ? 0 : 2) = 1;
    }
  return counts;
}

} // namespace shadow_volume_truth
