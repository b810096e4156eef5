#pragma once
/// \file
/// The world of post (world.hpp) and its light (object.frag, tone.frag) for rays, in double
/// precision: what is seen along any ray at any time. Of textures what they stand for, without
/// mipmaps: squares with sharp edges, and letters between whose texels lies a straight line.

#include "truth/scene.hpp"

#include <gg/mesh_data.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace post_truth {

using namespace ggrade;
using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using nlohmann::json;
using truth::number;

/// What the program draws in one colour. The things' numbers are those of their order.
struct Thing {
  enum Kind { ground, wire, board, ripples, slowBall, fastBox, lamp };
  Kind kind;
  dvec3 color;
  dmat4 model{1}; ///< world from model
};

/// Does it move by itself?
inline bool moves(Thing::Kind kind) {
  return kind >= Thing::slowBall;
}

inline double swing(double time, double period, double phase = 0) {
  return std::sin(2 * std::numbers::pi * (std::fmod(time / period, 1.0) + phase));
}

inline std::vector<Thing> thingsAt(const json& scene, double time) {
  const dmat4 world(1);
  const dvec3 up(0, 1, 0), forward(0, 0, 1);
  const auto at = [&](const dvec3& position, const dvec3& size) {
    return glm::scale(glm::translate(world, position), size);
  };
  const double t = number(scene, "/motion/speed") * time;
  const double thick = number(scene, "/wires/thickness");
  std::vector<Thing> all;
  all.push_back({Thing::ground, dvec3(1), glm::scale(world, dvec3(number(scene, "/ground/size")))});
  constexpr int kWires = 25;
  for (int i = 0; i < kWires; ++i) {
    const dmat4 turned = glm::rotate(glm::translate(world, dvec3(-1.7, 1.15, -1.2)),
                                     2 * std::numbers::pi * i / kWires, forward);
    all.push_back(
        {Thing::wire, dvec3(0.05, 0.05, 0.08),
         glm::scale(glm::translate(turned, dvec3(0, 0.3, 0)), dvec3(thick, 0.75, thick))});
  }
  const dmat4 board = glm::rotate(glm::translate(world, dvec3(1.75, 0.95, -1.3)), -0.35, up);
  all.push_back(
      {Thing::board, dvec3(1),
       glm::scale(glm::rotate(board, std::numbers::pi / 2, dvec3(1, 0, 0)), dvec3(1.7, 1, 1.2))});
  all.push_back({Thing::ripples, {0.35, 0.45, 0.75}, at({0.55, 0.45, 0.9}, dvec3(0.45))});
  all.push_back({Thing::slowBall, {0.8, 0.3, 0.2}, at({0.9 * swing(t, 5), 0.5, -0.2}, dvec3(0.5))});
  all.push_back({Thing::fastBox,
                 {0.25, 0.65, 0.3},
                 glm::rotate(at({-1.6 * swing(t, 1.4), 0.02, 0.6}, {0.5, 0.8, 0.5}), 0.5, up)});
  all.push_back({Thing::lamp,
                 {1, 0.85, 0.5},
                 at({1.5 * swing(t, 2.2), 1.75 + 0.35 * swing(t, 1.1), 0.3 * swing(t, 2.2, 0.25)},
                    dvec3(0.09))});
  return all;
}

/// The program's ball, of flat triangles as there.
inline gg::MeshData ball() {
  constexpr int kAround = 48, kUp = 24;
  gg::MeshData mesh;
  for (int j = 0; j <= kUp; ++j)
    for (int i = 0; i <= kAround; ++i) {
      const double a = 2 * std::numbers::pi * i / kAround;
      const double b = std::numbers::pi * (double(j) / kUp - 0.5);
      mesh.positions.emplace_back(std::cos(b) * std::sin(a), std::sin(b),
                                  std::cos(b) * std::cos(a));
    }
  mesh.normals = mesh.positions;
  const auto index = [&](int i, int j) { return std::uint32_t(j * (kAround + 1) + i); };
  for (int j = 0; j < kUp; ++j)
    for (int i = 0; i < kAround; ++i)
      for (const std::uint32_t k : {index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j),
                                    index(i + 1, j + 1), index(i, j + 1)})
        mesh.indices.push_back(k);
  return mesh;
}

inline const gg::MeshData& meshOf(Thing::Kind kind) {
  static const gg::MeshData plane = gg::plane(1, 1), box = gg::box(), round = ball();
  if (kind == Thing::ground || kind == Thing::board) return plane;
  return kind == Thing::wire || kind == Thing::fastBox ? box : round;
}

/// The texel of the letters' image, row 0 at the bottom.
inline double letter(int x, int y) {
  static constexpr const char* kRows[] = {
      " ####  ####  ####   ##   ####  ##### ", //
      "#     #      #   # #  #  #   # #     ", //
      "#     #      #   # #  #  #   # #     ", //
      "#  ## #  ### ####  ####  #   # ####  ", //
      "#   # #    # # #   #  #  #   # #     ", //
      "#   # #    # #  #  #  #  #   # #     ", //
      " ###   ####  #   # #  #  ####  ##### ", //
  };
  const int column = x - 3, row = 27 - y;
  const bool inside = column >= 0 && column < 74 && row >= 0 && row < 14;
  return (inside && kRows[row / 2][column / 2] == '#' ? 240.0 : 40.0) / 255;
}

/// What the pattern of a thing takes of its light, at texture coordinates.
inline double pattern(Thing::Kind kind, const dvec2& uv, double groundSize) {
  if (kind == Thing::ground) {
    const dvec2 square = glm::floor(2.0 * groundSize * uv);
    return (std::fmod(square.x + square.y, 2.0) == 0 ? 217.0 : 51.0) / 255;
  }
  if (kind != Thing::board) return 1;
  const dvec2 at = uv * dvec2(80, 40) - 0.5, first = glm::floor(at), share = at - first;
  const auto texel = [&](int i, int j) {
    return letter((int(first.x) + i + 80) % 80, (int(first.y) + j + 40) % 40);
  };
  return glm::mix(glm::mix(texel(0, 0), texel(1, 0), share.x),
                  glm::mix(texel(0, 1), texel(1, 1), share.x), share.y);
}

/// What is seen along a ray.
struct Sight {
  int thing = -1; ///< -1: the background
  dvec3 face{0};  ///< normal of the flat triangle
  double depth = 0;
  dvec3 light{0}; ///< linear
};

/// The world at a moment, seen by the camera of that moment.
class World {
public:
  ///   width, height: of the window, pixels
  World(const json& scene, double time, int width, int height)
      : camera_(turned(scene, time), width, height), things_(thingsAt(scene, time)),
        objects_(place(things_)), matt_(scene, "matt"), glitter_(scene, "glitter"),
        lamp_(truth::vector(scene, "/light/position")),
        background_(truth::vector(scene, "/background")),
        brightness_(number(scene, "/lamp/brightness")), groundSize_(number(scene, "/ground/size")) {
    for (const Thing& thing : things_) modelFromWorld_.push_back(glm::inverse(thing.model));
  }

  const truth::Camera& camera() const { return camera_; }
  Thing::Kind kindOf(int thing) const { return things_[std::size_t(thing)].kind; }

  /// Through a place in the window, pixels from its top left corner.
  Sight through(double x, double y) const {
    const dvec3 ray = camera_.forward + (2 * x / camera_.width - 1) * camera_.right +
                      (1 - 2 * y / camera_.height) * camera_.up;
    const truth::Surface surface = objects_.first(camera_.eye, ray, camera_.near, camera_.far);
    Sight sight;
    sight.light = background_;
    if (surface.id < 0) return sight;
    sight.thing = surface.id;
    sight.face = surface.face;
    sight.depth = glm::dot(surface.position - camera_.eye, camera_.forward);
    sight.light = glm::min(lightOf(surface), dvec3(65504)); // as a half float
    return sight;
  }

private:
  /// The scene with its camera on its way around the target.
  static json turned(json scene, double time) {
    const double angle = 0.5 * std::sin(2 * number(scene, "/motion/turn") * time);
    const dvec3 target = truth::vector(scene, "/camera/target");
    const dvec3 eye =
        target + truth::aboutY(truth::vector(scene, "/camera/position") - target, angle);
    scene["camera"]["position"] = {eye.x, eye.y, eye.z};
    return scene;
  }

  static truth::Objects place(const std::vector<Thing>& things) {
    std::vector<truth::Objects::Object> all;
    for (const Thing& thing : things) {
      truth::Objects::Object& placed = all.emplace_back();
      if (glm::determinant(thing.model) == 0) continue; // without any extent
      const gg::MeshData& mesh = meshOf(thing.kind);
      const glm::dmat3 forNormals = glm::transpose(glm::inverse(glm::dmat3(thing.model)));
      placed.triangles.indices = mesh.indices;
      for (const glm::vec3& p : mesh.positions)
        placed.triangles.positions.emplace_back(thing.model * dvec4(dvec3(p), 1));
      for (const glm::vec3& n : mesh.normals)
        placed.normals.push_back(glm::normalize(forNormals * dvec3(n)));
    }
    return truth::Objects(std::move(all));
  }

  /// The program adds ripples to the normal in eye space.
  dvec3 rippled(const dvec3& normal, const dvec3& model) const {
    const dvec3 right = glm::normalize(camera_.right), up = glm::normalize(camera_.up);
    const dvec3 wave =
        0.35 * glm::sin(90.0 * dvec3(model.y, model.z, model.x)) * glm::sin(61.0 * model);
    return glm::normalize(normal + wave.x * right + wave.y * up - wave.z * camera_.forward);
  }

  dvec3 lightOf(const truth::Surface& surface) const {
    const Thing& thing = things_[std::size_t(surface.id)];
    const dvec3 model(modelFromWorld_[std::size_t(surface.id)] * dvec4(surface.position, 1));
    const bool ripples = thing.kind == Thing::ripples;
    const dvec3 normal = ripples ? rippled(surface.normal, model) : surface.normal;
    const truth::Lit lit = (ripples ? glitter_ : matt_)
                               .lit(normal, glm::normalize(lamp_ - surface.position),
                                    glm::normalize(camera_.eye - surface.position));
    const double share = pattern(thing.kind, {model.x + 0.5, 0.5 - model.z}, groundSize_);
    const double emission = thing.kind == Thing::lamp ? brightness_ : 0;
    return share * thing.color * (lit.ambient + lit.diffuse) + lit.specular +
           emission * thing.color;
  }

  truth::Camera camera_;
  std::vector<Thing> things_;
  std::vector<dmat4> modelFromWorld_;
  truth::Objects objects_;
  truth::Material matt_, glitter_;
  dvec3 lamp_, background_; // the light's place, in the world
  double brightness_, groundSize_;
};

/// The light that the screen sends for light of any brightness, 0 to 1.
inline dvec3 toned(const dvec3& light) {
  return 1.0 - glm::exp(-glm::max(light, dvec3(0)));
}
/// And the sRGB number for that.
inline dvec3 encoded(const dvec3& light) {
  dvec3 shown;
  for (int c = 0; c < 3; ++c)
    shown[c] =
        light[c] <= 0.0031308 ? 12.92 * light[c] : 1.055 * std::pow(light[c], 1 / 2.4) - 0.055;
  return shown;
}

inline void set(Image& image, int x, int y, const dvec3& color) {
  for (int c = 0; c < 3; ++c) image.at(x, y, c) = float(color[c]);
}

/// How far two pixels are apart: the mean of their three differences.
inline double apart(const Image& a, const Image& b, int x, int y) {
  double sum = 0;
  for (int c = 0; c < 3; ++c) sum += std::abs(double(a.at(x, y, c)) - double(b.at(x, y, c)));
  return sum / 3;
}

} // namespace post_truth
