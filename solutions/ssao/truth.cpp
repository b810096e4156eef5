// Occlusion held against ray tracing: by rays in all directions, not by what the eye happens to
// see. A second answer marches along such rays through what the eye sees, so that what a depth
// buffer doesn't hold can be told from what few samples miss in it.

#include "truth/truth.hpp"
#include "truth/kept.hpp"
#include "truth/scene.hpp"

#include <gg/mesh_data.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

using namespace ggrade;
using glm::dvec3;
using nlohmann::json;
using truth::aboutY;
using truth::number;
using truth::Surface;

namespace {

/// Rays of each pixel: good for about 0.01.
constexpr int kRays = 256;
/// Of the march, and steps of each; neighbours' differ, so that less will do.
constexpr int kMarched = 64, kSteps = 32;
/// With the truth above this a pixel counts as open: it doesn't take part in the first error.
constexpr double kOpen = 0.9;

/// The still life's boxes, as the program has them: foot, size, turn.
struct Box {
  dvec3 foot, size;
  double turn;
};
constexpr Box kBoxes[] = {
    {{-0.95, 0, -0.20}, {0.70, 1.10, 0.70}, 0.3},   {{0.95, 0, -0.35}, {0.90, 0.50, 0.90}, -0.2},
    {{0.90, 0.50, -0.30}, {0.45, 0.45, 0.45}, 0.5}, {{0.55, 0, 0.75}, {0.50, 0.30, 0.50}, 0.9},
    {{-0.40, 0, 0.80}, {0.30, 0.60, 0.30}, -0.4},   {{0.10, 0, -0.95}, {1.10, 0.80, 0.25}, 0.1}};
constexpr double kMeshScale = 1.3;

truth::Objects::Object place(const gg::MeshData& mesh, const dvec3& scale, double turn,
                             const dvec3& foot, double turntable) {
  truth::Objects::Object placed;
  placed.triangles.indices = mesh.indices;
  for (const glm::vec3& p : mesh.positions)
    placed.triangles.positions.push_back(aboutY(aboutY(scale * dvec3(p), turn) + foot, turntable));
  for (const glm::vec3& n : mesh.normals)
    placed.normals.push_back(glm::normalize(aboutY(dvec3(n) / scale, turn + turntable)));
  return placed;
}

truth::Objects stillLife(const json& scene, double time) {
  const double period = number(scene, "/turntable/period");
  const double turned = 2 * std::numbers::pi * std::fmod(time, period) / period;
  const double size = number(scene, "/ground/size");
  const auto mesh = gg::loadMeshData(scene.at("mesh").get<std::string>(), "");
  std::vector<truth::Objects::Object> all;
  all.push_back(place(gg::plane(1, 1), {size, 1, size}, 0, {}, 0));
  all.push_back(place(mesh, dvec3(kMeshScale), 0, {}, turned));
  for (const Box& box : kBoxes)
    all.push_back(place(gg::box(), box.size, box.turn, box.foot, turned));
  return truth::Objects(std::move(all));
}

/// Directions above a surface, as dense as the cosine to its normal: evenly over the disc that they
/// are seen in from above (Hammersley's points).
class Directions {
public:
  ///   turn: of all about the normal, a share of a full turn
  Directions(const Surface& surface, int count, double turn)
      : surface_(surface), count_(count), turn_(turn),
        u_(glm::normalize(glm::cross(
            surface.normal, std::abs(surface.normal.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)))),
        v_(glm::cross(surface.normal, u_)) {}

  dvec3 at(int i) const {
    double inverse = 0, digit = 0.5; // i's binary digits behind the point, backwards
    for (int rest = i; rest > 0; rest /= 2, digit /= 2) inverse += digit * (rest % 2);
    const double r = std::sqrt((i + 0.5) / count_);
    const double angle = 2 * std::numbers::pi * (inverse + turn_);
    const dvec3 direction =
        r * (std::cos(angle) * u_ + std::sin(angle) * v_) + std::sqrt(1 - r * r) * surface_.normal;
    // A flat triangle that stands for a round surface hides nothing from itself.
    const double above = glm::dot(direction, surface_.face);
    return above < 0 ? direction - 2 * above * surface_.face : direction;
  }

private:
  const Surface& surface_;
  int count_;
  double turn_;
  dvec3 u_, v_;
};

/// 1 - the mean over all directions of max(1 - t / radius, 0), where t is how far a ray gets.
double openToRays(const truth::Objects& objects, const Surface& surface, double radius,
                  double turn) {
  const Directions directions(surface, kRays, turn);
  // Single precision is good for 1e-7 of a coordinate.
  const dvec3 from =
      surface.position + 1e-6 * (glm::length(surface.position) + radius) * surface.face;
  double hidden = 0;
  for (int i = 0; i < kRays; ++i)
    if (const auto hit = objects.rays().closestHit(from, directions.at(i), 0, radius))
      hidden += 1 - hit->distance / radius;
  return 1 - hidden / kRays;
}

/// What the eye sees, a surface a pixel: all that a depth buffer holds.
struct Seen {
  truth::Camera camera;
  std::vector<Surface> surfaces; // by rows; those of the background have the ID -1

  double depth(const dvec3& point) const { return glm::dot(point - camera.eye, camera.forward); }
  /// What is seen where a point is; nullptr if that is nothing, or behind the eye or outside the
  /// window.
  const Surface* at(const dvec3& point) const {
    const dvec3 from = point - camera.eye;
    const double deep = depth(point);
    if (deep <= 0) return nullptr;
    const double right = glm::dot(from, camera.right) / glm::dot(camera.right, camera.right);
    const double up = glm::dot(from, camera.up) / glm::dot(camera.up, camera.up);
    const double x = std::floor((0.5 + 0.5 * right / deep) * camera.width);
    const double y = std::floor((0.5 - 0.5 * up / deep) * camera.height);
    if (x < 0 || y < 0 || x >= camera.width || y >= camera.height) return nullptr;
    const Surface& surface = surfaces[std::size_t(y) * std::size_t(camera.width) + std::size_t(x)];
    return surface.id < 0 ? nullptr : &surface;
  }
};

/// The same as far as it can be seen: a ray ends where it comes behind what the eye sees, if that
/// is near enough, and above the surface's own plane.
double openToMarch(const Seen& seen, const Surface& surface, double radius, double turn) {
  const Directions directions(surface, kMarched, turn);
  double hidden = 0;
  for (int i = 0; i < kMarched; ++i) {
    const dvec3 direction = directions.at(i);
    for (int step = 0; step < kSteps; ++step) {
      const double t = radius * (step + 0.5) / kSteps;
      const dvec3 point = surface.position + t * direction;
      const Surface* before = seen.at(point);
      if (before == nullptr || seen.depth(before->position) >= seen.depth(point)) continue;
      const dvec3 to = before->position - surface.position;
      if (glm::length(to) >= radius || glm::dot(to, surface.normal) <= 0.01 * radius) continue;
      hidden += 1 - t / radius;
      break;
    }
  }
  return 1 - hidden / kMarched;
}

struct Traced {
  Image open, marched; // one channel; 1 for the background
  std::vector<bool> covered;
};

Traced trace(const truth::Rendered& rendered) {
  const int width = rendered.window.width(), height = rendered.window.height();
  const double radius = number(rendered.scene, "/ao/radius");
  const truth::Objects objects = stillLife(rendered.scene, rendered.time);
  Seen seen{truth::Camera(rendered.scene, width, height), {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      seen.surfaces.push_back(objects.first(seen.camera.eye, seen.camera.through(x, y),
                                            seen.camera.near, seen.camera.far));
  Traced traced{Image(width, height, 1), Image(width, height, 1), {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Surface& surface = seen.surfaces[traced.covered.size()];
      const double turn = 0.618034 * x + 0.754878 * y; // neighbours' rays lie between each other
      const bool covered = surface.id >= 0, hides = covered && radius > 0;
      traced.covered.push_back(covered);
      traced.open.at(x, y) = hides ? float(openToRays(objects, surface, radius, turn)) : 1;
      traced.marched.at(x, y) = hides ? float(openToMarch(seen, surface, radius, turn)) : 1;
    }
  return traced;
}

/// Errors, of the occlusion as the window shows it (debug.picture 3), 0 to 1. The first and the
/// last two are means over pixels whose truth is below 0.9, the others over all surfaces:
///   mean error where it is dark  |found - wanted|; a picture of 1 everywhere fails here
///   mean error                   |found - wanted|
///   mean too dark                max(wanted - found, 0)
///   mean too light               max(found - wanted, 0)
///   off what is seen             |found - marched|: what more or better samples could mend
///   what is not seen             |marched - wanted|: what they couldn't, whatever the setting
truth::Judgement judge(const truth::Rendered& rendered) {
  if (rendered.scene.at("debug").at("picture").get<int>() != 3)
    throw std::invalid_argument(
        "the occlusion's truth looks at the occlusion: set debug.picture to 3");
  const auto traced = truth::kept<Traced>(rendered, trace);
  truth::Mean dark, all, tooDark, tooLight, offSeen, notSeen;
  Image difference(rendered.window.width(), rendered.window.height(), 3);
  for (int y = 0; y < difference.height(); ++y)
    for (int x = 0; x < difference.width(); ++x) {
      if (!traced->covered[std::size_t(y) * std::size_t(difference.width()) + std::size_t(x)])
        continue;
      const double found = double(rendered.window.at(x, y, 0));
      const double wanted = double(traced->open.at(x, y));
      const double marched = double(traced->marched.at(x, y));
      const double apart = found - wanted;
      all.add(std::abs(apart));
      tooDark.add(std::max(-apart, 0.0));
      tooLight.add(std::max(apart, 0.0));
      if (wanted < kOpen) {
        dark.add(std::abs(apart));
        offSeen.add(std::abs(found - marched));
        notSeen.add(std::abs(marched - wanted));
      }
      // Red: too dark, blue: too light; four times as strong.
      difference.at(x, y, apart < 0 ? 0 : 2) = std::min(4 * float(std::abs(apart)), 1.0f);
    }
  truth::Judgement answer;
  answer.errors = {{"mean error where it is dark", dark.value()},
                   {"mean error", all.value()},
                   {"mean too dark", tooDark.value()},
                   {"mean too light", tooLight.value()},
                   {"off what is seen", offSeen.value()},
                   {"what is not seen", notSeen.value()}};
  answer.truth = traced->open;
  answer.rendered = firstChannels(rendered.window, 3);
  answer.difference = difference;
  return answer;
}

GGRADE_TRUTH("ssao", judge);

} // namespace
