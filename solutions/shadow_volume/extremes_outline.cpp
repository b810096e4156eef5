// The outline of the blocks' shadow on the floor in closed form: the polygon of their corners, seen
// from the lamp and projected onto the floor (all in double precision, no rays). The picture must
// have it to the pixel.

#include "drawn.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace extremes;
using glm::dvec2, glm::dvec3;

namespace {

constexpr int kSide = 401;                    // pixels
constexpr dvec3 kEye(0, 12, 2.796);           // above the middle of the floor, looking down
constexpr double kReach = 2.9;                // of the picture, to each side of the middle
constexpr double kPixel = 2 * kReach / kSide; // on the floor

using Corners = std::vector<dvec3>;

/// "Cornell Box Data", millimetres; x = 0 in the middle, units of 100 mm.
std::vector<Corners> blocks() {
  std::vector<Corners> all;
  const auto block = [&](const std::vector<dvec2>& base, double height) {
    Corners& corners = all.emplace_back();
    for (const dvec2& p : base)
      for (const double y : {0.0, height})
        corners.emplace_back(p.x / 100 - 2.764, y / 100, p.y / 100);
  };
  block({{130, 65}, {82, 225}, {240, 272}, {290, 114}}, 165);
  block({{423, 247}, {265, 296}, {314, 456}, {472, 406}}, 330);
  return all;
}

double cross(const dvec2& a, const dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

/// A convex polygon, counterclockwise.
class Hull {
public:
  /// Of what hides the floor (x and z) from `from`, which is above all corners.
  Hull(const Corners& corners, const dvec3& from) {
    std::vector<dvec2> points;
    for (const dvec3& p : corners) {
      const double far = from.y / (from.y - p.y);
      points.emplace_back(from.x + far * (p.x - from.x), from.z + far * (p.z - from.z));
    }
    // Gift wrapping (Jarvis 1973): the next corner has all others on its left.
    std::size_t at = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
      if (points[i].x < points[at].x) at = i;
    const std::size_t start = at;
    do {
      corners_.push_back(points[at]);
      std::size_t next = (at + 1) % points.size();
      for (std::size_t i = 0; i < points.size(); ++i)
        if (cross(points[next] - points[at], points[i] - points[at]) < 0) next = i;
      at = next;
    } while (at != start);
  }

  /// How deep a point is inside; below 0: at least so far outside.
  double depth(const dvec2& p) const {
    double least = 1e300;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const dvec2 side = corners_[(i + 1) % corners_.size()] - corners_[i];
      least = std::min(least, cross(side, p - corners_[i]) / glm::length(side));
    }
    return least;
  }

private:
  std::vector<dvec2> corners_;
};

/// The floor at a pixel's centre. Up in the picture is z; the camera's right is -x.
dvec2 floorAt(int x, int y) {
  return {-(x + 0.5 - kSide / 2.0) * kPixel, kEye.z - (y + 0.5 - kSide / 2.0) * kPixel};
}

/// Nothing but ambient light: 0.2 of the floor's red.
bool dark(const Image& image, int x, int y) {
  return std::abs(image.at(x, y, 0) * 255 - 0.2 * 0.73 * 255) < 1.5;
}

void expectOutline(const Image& image, const dvec3& lamp) {
  std::vector<Hull> shadows, hidden;
  for (const Corners& block : blocks()) {
    shadows.emplace_back(block, lamp);
    hidden.emplace_back(block, kEye);
  }
  int inside = 0, outside = 0, wrong = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const dvec2 p = floorAt(x, y);
      if (std::abs(p.x) > 2.764 - kPixel || std::abs(p.y - 2.796) > 2.796 - kPixel) continue;
      bool isDark = false, isNear = false, isSeen = true;
      for (const Hull& hull : shadows) {
        isDark = isDark || hull.depth(p) > 0;
        isNear = isNear || std::abs(hull.depth(p)) <= kPixel;
      }
      for (const Hull& hull : hidden) isSeen = isSeen && hull.depth(p) < -kPixel;
      if (isNear || !isSeen) continue;
      ++(isDark ? inside : outside);
      wrong += dark(image, x, y) != isDark;
    }
  EXPECT_EQ(wrong, 0) << "of " << inside + outside << ", lamp at " << lamp.x << ' ' << lamp.y << ' '
                      << lamp.z;
  EXPECT_GT(inside, 5000);
  EXPECT_GT(outside, 15000);
}

class Outline : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(ShadowVolume, Outline, testing::Values(0, 1)); // quality.method

TEST_P(Outline, IsThePolygonOfTheProjectedCorners) {
  const json bright = {{"ambient", {0.2, 0.2, 0.2}}, {"diffuse", {20, 20, 20}}};
  const json all = {{"size", {kSide, kSide}},
                    {"light", bright},
                    {"quality", {{"method", GetParam()}}},
                    {"camera",
                     {{"position", {kEye.x, kEye.y, kEye.z}},
                      {"target", {kEye.x, 0, kEye.z}},
                      {"up", {0, 0, 1}},
                      {"fov", 2 * std::atan(kReach / kEye.y)},
                      {"near", 1},
                      {"far", 20}}}};
  struct Circle {
    dvec3 middle;
    double radius;
  };
  for (const auto& [middle, radius] :
       {Circle{{0, 5.2, 2.8}, 2}, Circle{{-0.3, 3.9, 2.5}, 1}, Circle{{2, 60, 5}, 30}}) {
    json scene = all;
    scene["light"]["position"] = {middle.x, middle.y, middle.z};
    scene["orbit"] = {{"radius", radius}, {"period", 7}};
    const std::vector<double> times = {0, 1, 2, 3, 4, 5, 6};
    const Drawn drawn = draw("shadow_volume", sceneOf("shadow_volume", {}, scene), times);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const double angle = 2 * std::numbers::pi * times[i] / 7;
      expectOutline(drawn.frames[i], middle + radius * dvec3(std::cos(angle), 0, std::sin(angle)));
    }
  }
}

} // namespace
