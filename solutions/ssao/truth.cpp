// Occlusion held against ray tracing: by rays in all directions, not by what the eye happens to
// see.

#include "truth/truth.hpp"
#include "truth/kept.hpp"
#include "truth/ray.hpp"
#include "truth/scene.hpp"

#include <gg/mesh_data.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>

using namespace ggrade;
using glm::dvec3;
using nlohmann::json;
using truth::aboutY;
using truth::number;

namespace {

/// Rays of each pixel: good for about 0.01.
constexpr int kRays = 256;
/// With the truth above this a pixel counts as open: it doesn't take part in the first error.
constexpr double kOpen = 0.9;

/// A mesh as it stands in the world.
struct Placed {
  truth::Triangles triangles;
  std::vector<dvec3> normals; // world space, by vertex
};

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

Placed place(const gg::MeshData& mesh, const dvec3& scale, double turn, const dvec3& foot,
             double turntable) {
  Placed placed;
  placed.triangles.indices = mesh.indices;
  for (const glm::vec3& p : mesh.positions)
    placed.triangles.positions.push_back(aboutY(aboutY(scale * dvec3(p), turn) + foot, turntable));
  for (const glm::vec3& n : mesh.normals)
    placed.normals.push_back(glm::normalize(aboutY(dvec3(n) / scale, turn + turntable)));
  return placed;
}

class World {
public:
  World(const json& scene, double time) : radius_(number(scene, "/ao/radius")) {
    const double period = number(scene, "/turntable/period");
    const double turned = 2 * std::numbers::pi * std::fmod(time, period) / period;
    const double size = number(scene, "/ground/size");
    std::vector<Placed> all;
    all.push_back(place(gg::plane(1, 1), {size, 1, size}, 0, {}, 0));
    const auto mesh = gg::loadMeshData(scene.at("mesh").get<std::string>(), "");
    all.push_back(place(mesh, dvec3(kMeshScale), 0, {}, turned));
    for (const Box& box : kBoxes)
      all.push_back(place(gg::box(), box.size, box.turn, box.foot, turned));
    std::vector<truth::Triangles> triangles;
    for (Placed& one : all) {
      indices_.push_back(one.triangles.indices);
      normals_.push_back(std::move(one.normals));
      triangles.push_back(std::move(one.triangles));
    }
    rays_ = std::make_unique<truth::RayScene>(std::move(triangles));
  }

  /// How open is what a pixel shows? 1 for the background; `covered` says whether it is one.
  ///   turn: of the pixel's rays, a share of a full turn
  double open(const truth::Camera& camera, int x, int y, double turn, bool& covered) const {
    const dvec3 along = camera.through(x, y);
    const auto hit =
        rays_->closestHit(camera.eye, along, camera.near, camera.far, truth::Faces::front);
    covered = hit.has_value();
    if (!hit || radius_ == 0) return 1;
    const std::uint32_t* corners = &indices_[hit->mesh][3 * std::size_t(hit->triangle)];
    dvec3 normal(0);
    for (int k = 0; k < 3; ++k) normal += hit->weights[k] * normals_[hit->mesh][corners[k]];
    return openTo(camera.eye + hit->distance * along, glm::normalize(normal), hit->normal, turn);
  }

private:
  /// 1 - the mean over directions, dense as the cosine to the normal, of max(1 - t / radius, 0),
  /// where t is how far a ray gets.
  double openTo(const dvec3& position, const dvec3& normal, const dvec3& face, double turn) const {
    const dvec3 aside = std::abs(normal.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
    const dvec3 u = glm::normalize(glm::cross(normal, aside)), v = glm::cross(normal, u);
    // Single precision is good for 1e-7 of a coordinate.
    const dvec3 from = position + 1e-6 * (glm::length(position) + radius_) * face;
    double hidden = 0;
    for (int i = 0; i < kRays; ++i) {
      double inverse = 0, digit = 0.5; // i's binary digits behind the point, backwards
      for (int rest = i; rest > 0; rest /= 2, digit /= 2) inverse += digit * (rest % 2);
      const double r = std::sqrt((i + 0.5) / kRays);
      const double angle = 2 * std::numbers::pi * (inverse + turn);
      dvec3 direction =
          r * (std::cos(angle) * u + std::sin(angle) * v) + std::sqrt(1 - r * r) * normal;
      // A flat triangle that stands for a round surface hides nothing from itself.
      const double above = glm::dot(direction, face);
      if (above < 0) direction -= 2 * above * face;
      if (const auto hit = rays_->closestHit(from, direction, 0, radius_))
        hidden += 1 - hit->distance / radius_;
    }
    return 1 - hidden / kRays;
  }

  double radius_;
  std::vector<std::vector<std::uint32_t>> indices_;
  std::vector<std::vector<dvec3>> normals_;
  std::unique_ptr<truth::RayScene> rays_;
};

struct Traced {
  Image open; // one channel
  std::vector<bool> covered;
};

Traced trace(const truth::Rendered& rendered) {
  const int width = rendered.window.width(), height = rendered.window.height();
  const World world(rendered.scene, rendered.time);
  const truth::Camera camera(rendered.scene, width, height);
  Traced traced{Image(width, height, 1), {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      bool covered = false;
      const double turn = 0.618034 * x + 0.754878 * y; // neighbours' rays lie between each other
      traced.open.at(x, y, 0) = float(world.open(camera, x, y, turn, covered));
      traced.covered.push_back(covered);
    }
  return traced;
}

/// Errors, of the occlusion as the window shows it (debug.picture 3), 0 to 1:
///   mean error where it is dark  mean of |found - wanted| over the pixels whose truth is below
///   0.9:
///                                a picture of 1 everywhere fails here, as it should
///   mean error                   the same over all surfaces
///   mean too dark                mean of max(wanted - found, 0) over all surfaces
///   mean too light               mean of max(found - wanted, 0) over all surfaces
truth::Answer judge(const truth::Rendered& rendered) {
  if (rendered.scene.at("debug").at("picture").get<int>() != 3)
    throw std::invalid_argument(
        "the occlusion's truth looks at the occlusion: set debug.picture to 3");
  const auto traced = truth::kept<Traced>(rendered, trace);
  double dark = 0, darkCount = 0, tooDark = 0, tooLight = 0, count = 0;
  Image difference(rendered.window.width(), rendered.window.height(), 3);
  for (int y = 0; y < difference.height(); ++y)
    for (int x = 0; x < difference.width(); ++x) {
      if (!traced->covered[std::size_t(y) * std::size_t(difference.width()) + std::size_t(x)])
        continue;
      const double wanted = double(traced->open.at(x, y, 0));
      const double apart = double(rendered.window.at(x, y, 0)) - wanted;
      ++count, (apart < 0 ? tooDark : tooLight) += std::abs(apart);
      if (wanted < kOpen) ++darkCount, dark += std::abs(apart);
      // Red: too dark, blue: too light; four times as strong.
      difference.at(x, y, apart < 0 ? 0 : 2) = std::min(4 * float(std::abs(apart)), 1.0f);
    }
  const auto share = [](double sum, double of) { return of > 0 ? sum / of : 0; };
  truth::Answer answer;
  answer.errors = {{"mean error where it is dark", share(dark, darkCount)},
                   {"mean error", share(tooDark + tooLight, count)},
                   {"mean too dark", share(tooDark, count)},
                   {"mean too light", share(tooLight, count)}};
  answer.truth = traced->open;
  answer.rendered = firstChannels(rendered.window, 3);
  answer.difference = difference;
  return answer;
}

GGRADE_TRUTH("ssao", judge);

} // namespace
