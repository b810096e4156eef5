// The Cornell box's truth in scenes that can be worked out by hand, and its judge on pictures that
// are changed by a known amount.

#include "../../solutions/shadow_volume/truth_room.hpp"

#include "assignment/assignment.hpp"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>

#include <cmath>
#include <random>

using namespace shadow_volume_truth;

namespace {

json sceneWith(const json& change = json::object()) {
  json scene = readJson(GGRADE_SOURCE_DIR "/assignments/shadow_volume/scene.json");
  scene.merge_patch(change);
  return scene;
}

/// In the space of a box of side 3.3 that stands in the middle of the room, 0.4 above the floor,
/// turned by 0.3: the box is -1 to 1 there.
dvec3 inBox(const dvec3& p) {
  const double c = std::cos(0.3), s = std::sin(0.3), x = p.x, z = p.z - 5.592 / 2;
  return dvec3(c * x - s * z, p.y - 0.4 - 1.65, s * x + c * z) / 1.65;
}

const json kBox = {{"mesh", "box"}, {"caster", {{"lift", 0.4}, {"turn", 0.3}}}};

/// Does the segment touch the box of -1 to 1 (Kay and Kajiya 1986), and by how much of its length?
double within(const dvec3& from, const dvec3& to) {
  double enters = 0, leaves = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double step = to[axis] - from[axis];
    const double a = (-1 - from[axis]) / step, b = (1 - from[axis]) / step;
    enters = std::max(enters, std::min(a, b)), leaves = std::min(leaves, std::max(a, b));
  }
  return leaves - enters;
}

TEST(TruthRoom, WhatABoxHidesIsInItsShadow) {
  std::mt19937 random(1);
  const auto between = [&](double low, double high) {
    return low + (high - low) * double(random()) / 0x1p32;
  };
  const auto place = [&] {
    const double x = between(-2.7, 2.7), y = between(0, 5.4);
    return dvec3(x, y, between(0, 5.5));
  };
  int hidden = 0, inside = 0;
  for (int i = 0; i < 20; ++i) {
    const dvec3 lamp = place();
    json scene = sceneWith(kBox);
    scene["light"]["position"] = {lamp.x, lamp.y, lamp.z};
    scene["orbit"]["radius"] = 0;
    const Room room(scene, 0, 8, 8);
    for (int k = 0; k < 500; ++k) {
      const dvec3 point = place();
      const double length = within(inBox(point), inBox(lamp));
      if (std::abs(length) < 1e-4 || length == 1) continue; // in an edge; both inside
      ASSERT_EQ(room.isHidden(point), length > 0) << i << ' ' << k;
      hidden += length > 0;
      const dvec3 local = glm::abs(inBox(point));
      const bool isIn = std::max({local.x, local.y, local.z}) < 1;
      ASSERT_EQ(room.isInCaster(point), isIn) << i << ' ' << k;
      inside += isIn;
    }
  }
  EXPECT_GT(hidden, 2000);
  EXPECT_LT(hidden, 8000);
  EXPECT_GT(inside, 1000);
}

TEST(TruthRoom, BlocksStandWhereTheyArePublished) {
  const Room room(sceneWith(), 0, 8, 8);
  // Published millimetres; x = 0 is the middle here, one unit is 100 mm.
  const auto at = [](double x, double y, double z) {
    return dvec3(x / 100 - 2.764, y / 100, z / 100);
  };
  EXPECT_TRUE(room.isInCaster(at(186, 160, 169)));  // the short one's middle, near its top
  EXPECT_FALSE(room.isInCaster(at(186, 170, 169))); // and over it
  EXPECT_TRUE(room.isInCaster(at(368, 325, 351)));
  EXPECT_FALSE(room.isInCaster(at(368, 335, 351)));
  EXPECT_TRUE(room.isInCaster(at(131, 100, 69))); // next to the short one's corner
  EXPECT_FALSE(room.isInCaster(at(129, 100, 61)));
}

TEST(TruthRoom, SeesWallsFromInsideAlone) {
  json scene = sceneWith({{"mesh", "none"}});
  const auto middle = [&](const dvec3& from, const dvec3& to) {
    scene["camera"]["position"] = {from.x, from.y, from.z};
    scene["camera"]["target"] = {to.x, to.y, to.z};
    scene["camera"]["near"] = 0.1;
    return Room(scene, 0, 3, 3).seen(1, 1);
  };
  const dvec3 eye(0.3, 2, 1);
  EXPECT_EQ(middle(eye, {0.3, 0, 1}).id, 1); // floor
  EXPECT_EQ(middle(eye, {0.3, 6, 1}).id, 2); // ceiling
  EXPECT_EQ(middle(eye, {0.3, 2, 9}).id, 3); // back
  EXPECT_EQ(middle(eye, {9, 2, 1}).id, 4);   // left, which is +x
  EXPECT_EQ(middle(eye, {-9, 2, 1}).id, 5);  // right
  EXPECT_EQ(middle(eye, {0.3, 2, -9}).id, kNothing);
  EXPECT_NEAR(middle(eye, {9, 2, 1}).position.x, 2.764, 1e-12);
  EXPECT_NEAR(middle(eye, {0.3, 2, 9}).position.z, 5.592, 1e-12);
  EXPECT_EQ(middle({0, 9, 2}, {0, 0, 2.0001}).id, 1) << "through the ceiling";
}

TEST(TruthRoom, TheLampCirclesAndTheWallsAreLitAsTheFormulaSays) {
  json scene = sceneWith({{"mesh", "none"}, {"orbit", {{"radius", 1}, {"period", 8}}}});
  scene["light"] = {{"position", {0.5, 4, 2}},
                    {"ambient", {0.2, 0.2, 0.2}},
                    {"diffuse", {0.5, 0.6, 0.7}},
                    {"specular", {0.1, 0.2, 0.3}}};
  scene["materials"]["wall"]["specular"] = {0.5, 0.5, 0.5};
  scene["materials"]["wall"]["shininess"] = 30;
  scene["camera"]["position"] = {0.5, 4, 3}; // a quarter of a turn on, the lamp is there
  scene["camera"]["target"] = {0.5, 0, 3};
  const Room room(scene, 2, 11, 11);
  EXPECT_NEAR(glm::distance(room.lamp, dvec3(0.5, 4, 3)), 0, 1e-12);
  const Surface floor{1, {0.5, 0, 3}, {0, 1, 0}, {0, 1, 0}};
  EXPECT_NEAR(room.color(floor, 1).x, 0.73 * (0.2 + 0.5) + 0.05, 1e-12);
  EXPECT_NEAR(room.color(floor, 0).z, 0.68 * 0.2, 1e-12);
  // 4 to the side: light and eye at 45 degrees.
  const Surface left{4, {2.764, 4, 3}, {-1, 0, 0}, {-1, 0, 0}};
  EXPECT_NEAR(room.color(left, 1).y, 0.06 * (0.2 + 0.6) + 0.1, 1e-12) << "red";
  EXPECT_FALSE(room.isAverted(left));
  EXPECT_TRUE(room.isAverted({5, {3, 4, 3}, {1, 0, 0}, {1, 0, 0}}));
}

// The judge.

truth::Rendered rendered(const json& change = json::object()) {
  return {sceneWith(change), 0, Image(160, 120, 4), nullptr};
}

double error(const truth::Judgement& answer, const std::string& name) {
  for (const truth::Error& one : answer.errors)
    if (one.name == name) return one.value;
  ADD_FAILURE() << "no error is named " << name;
  return std::nan("");
}

truth::Judgement judged(const truth::Rendered& rendered) {
  return truth::judgeOf("shadow_volume")(rendered);
}

TEST(TruthRoom, TheTruthHasNoError) {
  for (const char* mesh : {"blocks", "torus_knot", "none"}) {
    truth::Rendered right = rendered({{"mesh", mesh}});
    right.window = judged(right).truth;
    const truth::Judgement answer = judged(right);
    EXPECT_EQ(answer.errors.at(0).name, "wrong pixels");
    for (const truth::Error& one : answer.errors) EXPECT_EQ(one.value, 0) << mesh << one.name;
  }
}

TEST(TruthRoom, WrongPixelsAreCountedBySide) {
  truth::Rendered lit = rendered();
  lit.window = judged(rendered({{"effects", {{"shadow", false}}}})).truth;
  EXPECT_EQ(error(judged(lit), "false light"), 1);
  EXPECT_EQ(error(judged(lit), "false shadow"), 0);
  const double share = error(judged(lit), "wrong pixels");
  EXPECT_GT(share, 0.01);
  EXPECT_LT(share, 0.5);
  const truth::Judgement dark = judged(rendered()); // black
  EXPECT_EQ(error(dark, "false light"), 0);
  EXPECT_EQ(error(dark, "false shadow"), 1);
  EXPECT_NEAR(error(dark, "wrong pixels"), 1 - share, 1e-12);
}

TEST(TruthRoom, AnEdgeMayMoveByOnePixelAndNotByThree) {
  const Image right = judged(rendered()).truth;
  const auto moved = [&](int by) {
    truth::Rendered other = rendered();
    other.window = right;
    for (int y = 0; y < right.height(); ++y)
      for (int x = by; x < right.width(); ++x)
        for (int c = 0; c < 3; ++c) other.window.at(x, y, c) = right.at(x - by, y, c);
    return error(judged(other), "wrong pixels");
  };
  EXPECT_EQ(moved(1), 0);
  EXPECT_GT(moved(3), 0.01);
}

TEST(TruthRoom, ColoursThatAreNeitherAreStrange) {
  truth::Rendered other = rendered();
  const auto shadows = shadowsOf(other);
  other.window = shadows.picture;
  EXPECT_EQ(count(shadows, other.window).strange, 0u);
  for (float& value : other.window.values()) value = value == 1 ? 0 : 1 - value;
  const Counts counts = count(shadows, other.window);
  EXPECT_GT(counts.strange, counts.judged() / 2);
}

} // namespace
