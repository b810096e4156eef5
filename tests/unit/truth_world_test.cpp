// The floor's world in scenes that can be worked out by hand.

#include "../../solutions/floor/truth_world.hpp"

#include "assignment/assignment.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace floor_truth;
using glm::dvec2;

namespace {

json sceneWith(const json& change = json::object()) {
  json scene = readJson(GGRADE_SOURCE_DIR "/assignments/floor/scene.json");
  scene.merge_patch(change);
  return scene;
}

/// One box of side 1 that stands in the middle.
const json kBox = {{"mesh", "box"},
                   {"ring", {{"count", 1}, {"radius", 0}, {"hop", 0}, {"base", 0}, {"scale", 1}}}};

Surface floorAt(double x, double z) {
  return {kFloor, {x, 0, z}, {0, 1, 0}, {0, 1, 0}};
}

double cross(const dvec2& a, const dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

/// The convex hull, counterclockwise (Andrew's monotone chain).
std::vector<dvec2> hullOf(std::vector<dvec2> points) {
  std::ranges::sort(points, [](const dvec2& a, const dvec2& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  });
  std::vector<dvec2> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = hull.size();
    for (const dvec2& p : points) {
      while (hull.size() >= start + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::ranges::reverse(points);
  }
  return hull;
}

TEST(TruthWorld, ABoxShadowsThePolygonOfItsProjectedCorners) {
  json scene = sceneWith(kBox);
  scene["effects"]["shadow"] = true;
  for (const dvec3 light : {dvec3(1.5, 5, 3), dvec3(6, 1.7, 2), dvec3(-2, 9, 0.1)}) {
    scene["light"]["position"] = {light.x, light.y, light.z};
    const World world(scene, 0, 64, 48);
    // At time 0 the only object is turned by a whole turn.
    std::vector<dvec2> corners;
    for (int i = 0; i < 8; ++i) {
      const dvec3 corner(i & 1 ? 0.5 : -0.5, i & 2 ? 1 : 0, i & 4 ? 0.5 : -0.5);
      const double far = light.y / (light.y - corner.y);
      corners.emplace_back(light.x + far * (corner.x - light.x),
                           light.z + far * (corner.z - light.z));
    }
    const std::vector<dvec2> hull = hullOf(corners);
    int inside = 0, outside = 0;
    for (double x = -3; x < 3; x += 0.0173)
      for (double z = -3; z < 3; z += 0.0191) {
        double nearest = 1e9; // signed distance from the polygon's sides, positive inside
        for (std::size_t i = 0; i < hull.size(); ++i) {
          const dvec2 side = hull[(i + 1) % hull.size()] - hull[i];
          nearest = std::min(nearest, cross(side, dvec2(x, z) - hull[i]) / glm::length(side));
        }
        // The box stands on the floor: right under it a point is in its face.
        if (std::abs(nearest) < 1e-4 || std::max(std::abs(x), std::abs(z)) < 0.5001) continue;
        ++(nearest > 0 ? inside : outside);
        ASSERT_EQ(world.inShadow(floorAt(x, z)), nearest > 0) << x << " " << z;
      }
    EXPECT_GT(inside, 100);
    EXPECT_GT(outside, 1000);
  }
}

TEST(TruthWorld, AnEdgeCutsASegmentFromARoundLight) {
  json scene = sceneWith(kBox);
  const dvec2 light(4, 5);
  const double radius = 0.3;
  scene["light"]["position"] = {light.x, light.y, 0};
  const World world(scene, 0, 64, 48);
  int partly = 0;
  for (double x = -2.2; x < -1.2; x += 0.01) {
    // In the plane z = 0: the box's highest point as seen from x, and how far the line over it
    // passes from the light's middle, in radii.
    double hidden = -1;
    for (const dvec2 corner : {dvec2(-0.5, 1), dvec2(0.5, 1)}) {
      const dvec2 over = corner - dvec2(x, 0), middle = light - dvec2(x, 0);
      const double along = glm::dot(middle, middle) / glm::dot(over, middle);
      const dvec2 at = along * over;
      hidden = std::max(hidden, cross(middle, at) / glm::length(middle) / radius);
    }
    const double h = std::clamp(hidden, -1.0, 1.0);
    const double share = 0.5 - (h * std::sqrt(1 - h * h) + std::asin(h)) / std::numbers::pi;
    EXPECT_NEAR(world.shareOfLight(floorAt(x, 0), radius), share, 0.015) << x;
    partly += share > 0.02 && share < 0.98;
  }
  EXPECT_GT(partly, 10);
}

TEST(TruthWorld, WhatLiesBehindTheLightShadesNothing) {
  json scene = sceneWith(kBox);
  scene["light"]["position"] = {0, 2, 0.3};
  scene["ring"]["base"] = 3;
  EXPECT_FALSE(World(scene, 0, 64, 48).inShadow(floorAt(0.1, 0.2)));
  scene["ring"]["base"] = 0.5;
  EXPECT_TRUE(World(scene, 0, 64, 48).inShadow(floorAt(0.1, 0.2)));
}

TEST(TruthWorld, AReflectionLiesWhereTheMirroredPointDoes) {
  json scene = sceneWith();
  scene["effects"]["mirror"] = true;
  const World world(scene, 0.4, 160, 120);
  const dvec3 eye(0, 3.4, 7);
  int found = 0;
  for (int y = 0; y < world.height; ++y)
    for (int x = 0; x < world.width; ++x) {
      const Seen seen = world.seen(x, y);
      if (seen.surface.id != kFloor || seen.reflected.id == kNothing) continue;
      ++found;
      // The eye, the point of the floor and the mirror image lie on one line, in this order.
      const dvec3 image = seen.reflected.position * dvec3(1, -1, 1);
      const dvec3 toFloor = glm::normalize(seen.surface.position - eye);
      EXPECT_NEAR(glm::distance(toFloor, glm::normalize(image - eye)), 0, 1e-9);
      EXPECT_GT(glm::distance(image, eye), glm::distance(seen.surface.position, eye) - 1e-9);
      EXPECT_GE(seen.reflected.position.y, -1e-6);
      // And what is seen there faces the floor's point.
      EXPECT_LT(glm::dot(seen.reflected.face, seen.reflected.position - seen.surface.position), 0);
    }
  EXPECT_GT(found, 500);
}

TEST(TruthWorld, ABoxReflectsItsSideUpsideDown) {
  // A camera straight in front, level with nothing: a point at height h and its image at -h.
  json scene = sceneWith(kBox);
  scene["effects"]["mirror"] = true;
  scene["camera"] = {{"position", {0, 0.5, 4}},     {"target", {0, 0.5, 0}}, {"up", {0, 1, 0}},
                     {"fov", std::numbers::pi / 2}, {"near", 0.1},           {"far", 50}};
  const World world(scene, 0, 400, 400);
  // At the front face's depth, 3.5, a pixel is 2 * 3.5 / 400 high.
  const double pixel = 2 * 3.5 / 400;
  const auto rowOf = [&](double height) { return int(200 - (height - 0.5) / pixel); };
  const Seen top = world.seen(200, rowOf(0.95)), foot = world.seen(200, rowOf(0.05));
  EXPECT_EQ(top.surface.id, 1);
  EXPECT_NEAR(top.surface.position.y, 0.95, pixel);
  EXPECT_NEAR(top.surface.position.z, 0.5, 1e-12);
  EXPECT_EQ(foot.surface.id, 1);
  const Seen mirrored = world.seen(200, rowOf(-0.95));
  EXPECT_EQ(mirrored.surface.id, kFloor);
  EXPECT_EQ(mirrored.reflected.id, 1);
  EXPECT_NEAR(mirrored.reflected.position.y, 0.95, pixel);
  EXPECT_NEAR(mirrored.reflected.position.z, 0.5, 1e-12);
  EXPECT_EQ(world.seen(200, rowOf(-1.05)).reflected.id, kNothing);
}

TEST(TruthWorld, WhatLiesBelowTheFloorHasNoReflection) {
  json scene = sceneWith(kBox);
  scene["effects"]["mirror"] = true;
  scene["ring"]["base"] = -0.6;
  scene["camera"]["position"] = {0, 3, 3};
  const World world(scene, 0, 120, 90);
  int reflected = 0;
  for (const Seen& seen : look(world)) {
    if (seen.reflected.id == kNothing) continue;
    ++reflected;
    EXPECT_GE(seen.reflected.position.y, -1e-6);
    EXPECT_LE(seen.reflected.position.y, 0.4 + 1e-6);
  }
  EXPECT_GT(reflected, 100);
}

TEST(TruthWorld, TheFloorIsLitAsTheFormulaSays) {
  json scene = sceneWith();
  scene["ring"]["count"] = 0;
  scene["camera"]["position"] = {0.25, 4, 0.25};
  scene["camera"]["target"] = {0.25, 0, 0.25};
  scene["light"] = {{"position", {0.25, 4, 0.25}},
                    {"ambient", {0.2, 0.2, 0.2}},
                    {"diffuse", {0.5, 0.6, 0.7}},
                    {"specular", {0.1, 0.2, 0.3}}};
  scene["materials"]["floor"] = {{"ambient", {1, 1, 1}},
                                 {"diffuse", {0.5, 0.5, 0.5}},
                                 {"specular", {0.5, 0.5, 0.5}},
                                 {"shininess", 30}};
  const World world(scene, 0, 101, 101);
  // Straight down: everything is along the normal. Tile (0,0) is light, (-1,0) dark.
  const dvec3 color = world.color(floorAt(0.25, 0.25), {0, 1, 0}, 1);
  EXPECT_NEAR(color.x, 0.9 * (0.2 + 0.25) + 0.05, 1e-12);
  EXPECT_NEAR(color.z, 0.9 * (0.2 + 0.35) + 0.15, 1e-12);
  const dvec3 shadow = world.color(floorAt(0.25, 0.25), {0, 1, 0}, 0);
  EXPECT_NEAR(shadow.x, 0.9 * 0.2, 1e-12);
  EXPECT_NEAR(world.color(floorAt(-0.25, 0.25), {0, 1, 0}, 0).x, 0.6 * 0.2, 1e-12);
  EXPECT_NEAR(world.color(floorAt(-0.25, -0.25), {0, 1, 0}, 0).x, 0.9 * 0.2, 1e-12);
  // 4 to the side: light at 45 degrees, halfway at 22.5 for an eye straight above.
  const dvec3 slanted = world.color(floorAt(4.25, 0.25), {0, 1, 0}, 1);
  EXPECT_NEAR(slanted.x,
              0.9 * (0.2 + 0.25 * std::sqrt(0.5)) +
                  0.05 * std::pow(std::cos(std::numbers::pi / 8), 30),
              1e-12);
  // The middle pixel is that point.
  EXPECT_NEAR(glm::distance(world.seen(50, 50).surface.position, dvec3(0.25, 0, 0.25)), 0, 1e-9);
}

TEST(TruthWorld, ObjectsStandOnTheRingAndGlow) {
  json scene = sceneWith({{"mesh", "box"}, {"light", {{"position", {0, 50, 0}}}}});
  scene["ring"] = {{"count", 4},   {"radius", 2}, {"hop", 0.5}, {"base", 0.1},
                   {"scale", 0.2}, {"cycle", 10}, {"glow", 3}};
  scene["camera"] = {{"position", {0, 9, 0}},
                     {"target", {0, 0, 0}},
                     {"up", {0, 0, -1}},
                     {"fov", 0.6},
                     {"near", 1},
                     {"far", 20}};
  // A hop takes 1/18 of a cycle: a quarter of one later the objects are 3/4 of a hop high.
  const double t = 1 / 72.0;
  const World world(scene, 10 * t, 301, 301);
  for (int i = 1; i <= 4; ++i) {
    const double angle = std::numbers::pi * (2.0 * i / 4 - 4 * t);
    const dvec3 top(2 * std::sin(angle), 0.1 + 0.375 + 0.2, 2 * std::cos(angle));
    // A pixel is 2 tan(0.3) / 301 wide at distance 1; the top is 9 - y away.
    const double pixel = 2 * std::tan(0.3) / 301 * (9 - top.y);
    const Seen seen = world.seen(int(150.5 + top.x / pixel), int(150.5 + top.z / pixel));
    ASSERT_EQ(seen.surface.id, i);
    EXPECT_NEAR(seen.surface.position.y, top.y, 1e-6);
    EXPECT_NEAR(glm::distance(seen.surface.normal, dvec3(0, 1, 0)), 0, 1e-9);
    const dvec3 own((i & 1) * 0.4 + 0.4, (i & 2) * 0.2 + 0.4, (i & 4) * 0.1 + 0.4);
    const dvec3 dark = world.color(seen.surface, seen.toEye, 0);
    const double glow = i % 2 == 1 ? 3 : 0;
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(dark[c], 0.9 * 0.25 * own[c] + glow * own[c] * own[c], 1e-9) << i;
  }
}

TEST(TruthWorld, NothingBelowOrBesideTheFloorShowsIt) {
  json scene = sceneWith();
  scene["effects"]["mirror"] = true;
  scene["ring"]["count"] = 0;
  scene["camera"]["position"] = {0, -1, 5};
  for (const Seen& seen : look(World(scene, 0, 20, 15))) {
    EXPECT_EQ(seen.surface.id, kNothing);
    EXPECT_EQ(seen.reflected.id, kNothing);
  }
}

TEST(TruthWorld, ALineBetweenTilesIsNotJudged) {
  const World world(sceneWith(), 0, 8, 6);
  EXPECT_TRUE(world.onTileLine(floorAt(0, 0.3)));
  EXPECT_TRUE(world.onTileLine(floorAt(0.2, -1.5000001)));
  EXPECT_FALSE(world.onTileLine(floorAt(0.2, 0.3)));
  Surface object = floorAt(0, 0);
  object.id = 1;
  EXPECT_FALSE(world.onTileLine(object));
}

TEST(TruthWorld, NamesTheKeyThatIsMissing) {
  json scene = sceneWith();
  scene["ring"].erase("hop");
  EXPECT_THAT([&] { World(scene, 0, 8, 6); },
              testing::ThrowsMessage<json::exception>(testing::HasSubstr("hop")));
}

} // namespace
