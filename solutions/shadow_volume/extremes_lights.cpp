// Eyes and lamps at odd places: in volumes, in the planes of their sides, in faces, edges,
// vertices.

#include "extremes_room.hpp"

#include <array>

using namespace shadow_volume_extremes;

namespace {

json vec(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

/// An eye within the room.
json eyeAt(const glm::dvec3& position, const glm::dvec3& target, json scene = room()) {
  scene["camera"] = {{"position", vec(position)},
                     {"target", vec(target)},
                     {"up", {0, 1, 0}},
                     {"near", 0.02},
                     {"far", 20},
                     {"fov", 1.4}};
  return scene;
}

bool isInVolume(const json& scene) {
  const Room asked(scene, 0, 8, 8);
  return asked.isHidden(asked.camera.eye);
}

class Eye : public testing::TestWithParam<json> {
protected:
  /// z-fail, drawn in the way that the test has.
  Counts right(json scene, std::size_t most = 0) const {
    scene["quality"].update(GetParam());
    return expectRight(scene, {0}, "", most);
  }
};
INSTANTIATE_TEST_SUITE_P(ShadowVolume, Eye,
                         testing::Values(json{{"edges", 0}}, json{{"edges", 1}},
                                         json{{"passes", 2}}),
                         nameOfQuality);

TEST_P(Eye, InAVolume) {
  const json scene = eyeAt({0.3, 0.8, 5.4}, {-1.6, 1, 1.5});
  ASSERT_TRUE(isInVolume(scene));
  const Counts counts = right(scene);
  EXPECT_GT(counts.lit, 1000u);
  EXPECT_GT(counts.dark, 500u);
  // The lecture's way is wrong all over here: the test can tell.
  json before = scene;
  before["quality"]["method"] = 0;
  const Counts wrong = countsOf(before, 0, draw("shadow_volume", before, {0}).frames[0]);
  EXPECT_GT(wrong.wrong(), wrong.judged() / 2);
}

TEST_P(Eye, InTwoVolumes) {
  // The lamp is low at the left; the tall block stands in the short one's shadow.
  json scene = room();
  scene["light"]["position"] = {-2.5, 0.9, 0.5};
  scene = eyeAt({2.3, 0.5, 4.6}, {0, 1.5, 1}, scene);
  ASSERT_TRUE(isInVolume(scene));
  EXPECT_GT(right(scene).dark, 1000u);
}

TEST_P(Eye, AtTheLampSeesNoShadow) {
  const Counts counts = right(eyeAt({0, 5.2, 0.9}, {0, 0, 2.8}));
  EXPECT_GT(counts.lit, 10000u);
  EXPECT_EQ(counts.dark, 0u);
}

TEST_P(Eye, InThePlaneOfAVolumesSide) {
  // The box reaches from -1.65 to 1.65 and up to 3.3: behind its upper edge, on the way of the
  // light, and in the middle of the edge, and right in the line of light through its corner.
  json scene = room({{"mesh", "box"}});
  scene["light"]["position"] = {0, 5, 2.796};
  const glm::dvec3 lamp(0, 5, 2.796);
  for (const double z : {0.0, 0.7, 1.65})
    for (const double far : {1.0, 1.2, 1.5}) {
      const glm::dvec3 edge(1.65, 3.3, 2.796 - z);
      // Sides are seen as lines. A pixel that has its centre in one, to a part of the rasteriser's
      // 1/256 pixel, may count it or not.
      const Counts counts = right(eyeAt(lamp + far * (edge - lamp), {-1, 0, 0.4}, scene), 1);
      EXPECT_GT(counts.judged(), 800u) << z << ' ' << far;
    }
}

TEST_P(Eye, InThePlaneOfAFace) {
  // Of the box's top, and of its side.
  json scene = room({{"mesh", "box"}});
  scene["light"]["position"] = {0.4, 5, 2};
  EXPECT_GT(right(eyeAt({2.4, 3.3, 0.3}, {-1, 2, 3}, scene)).dark, 500u);
  EXPECT_GT(right(eyeAt({1.65, 2, 0.2}, {0, 1, 3}, scene)).dark, 500u);
}

TEST_P(Eye, InsideASolid) {
  // Its faces are seen from behind, so not at all: the rest of the room is.
  const Counts counts = right(eyeAt({1, 1, 3.5}, {-1, 1, 1}));
  EXPECT_GT(counts.lit, 1000u);
  EXPECT_GT(counts.dark, 1000u);
}

TEST_P(Eye, OutsideTheRoom) {
  // Walls are not seen from behind.
  const Counts counts = right(eyeAt({6, 7, -3}, {0, 1, 2.8}));
  EXPECT_GT(counts.lit, 1000u);
  EXPECT_GT(counts.dark, 100u);
}

/// Where a lamp can be.
struct Place {
  const char* name;
  glm::dvec3 position;
  bool lights = true; ///< anything that is seen
};
void PrintTo(const Place& place, std::ostream* out) {
  *out << place.name;
}

class Lamp : public testing::TestWithParam<Place> {};

/// Corners of the tall block's top, in the world.
const glm::dvec3 kA(1.466, 3.3, 2.47), kB(-0.114, 3.3, 2.96);

INSTANTIATE_TEST_SUITE_P(
    ShadowVolume, Lamp,
    testing::Values(
        Place{"InTheTopsPlane", {2.4, 3.3, 1}}, Place{"OnTheTop", {0.9, 3.3, 3.4}},
        Place{"InASidesPlane", kB + 1.4 * (kB - kA) + glm::dvec3(0, 0.6, 0)},
        Place{"OnASide", (kA + kB) / 2.0 - glm::dvec3(0, 1.5, 0)},
        Place{"InAnEdge", (kA + kB) / 2.0},
        Place{"NextToAVertex", kA + glm::dvec3(-0.01, 0.02, 0.01)},
        Place{"InAnEdgesLine", kA + 0.5 * (kA - kB)}, Place{"AtTheCeiling", {0.3, 5.488, 2}},
        Place{"AtTheBackWall", {-1.5, 4, 5.592}}, Place{"AtTheFloor", {-0.2, 0, 0.3}},
        Place{"AtAWall", {2.764, 2, 1.5}}, Place{"InTheRoomsCorner", {-2.764, 5.488, 5.592}},
        Place{"JustOverTheFloor", {-0.2, 1e-4, 0.3}}, Place{"BelowTheFloor", {0.5, -2, 1}},
        Place{"BehindAWall", {-6, 4, 2}}, Place{"ASunFarAway", {3e4, 7e4, -5e4}},
        Place{"InASolid", {1, 1, 3.5}, false}, Place{"InTheOtherSolid", {-1, 0.8, 1.6}, false}),
    [](const auto& info) { return std::string(info.param.name); });

TEST_P(Lamp, IsRight) {
  json scene = room();
  scene["light"]["position"] = vec(GetParam().position);
  Counts sum;
  for (const json& quality : {json{{"edges", 0}}, json{{"edges", 1}}}) {
    scene["quality"].update(quality);
    for (const json& view : {scene, eyeAt({-2.2, 4.5, 0.5}, {0.6, 1, 3.4}, scene)}) {
      const Counts counts = expectRight(view);
      sum.lit += counts.lit, sum.dark += counts.dark;
    }
  }
  EXPECT_GT(sum.dark, 1000u);
  if (GetParam().lights)
    EXPECT_GT(sum.lit, 4000u);
  else
    EXPECT_EQ(sum.lit, 0u);
}

// A lamp in a vertex, or in an edge between two upright faces: there, what is lit jumps with the
// last bit of its position, which is rounded. The whole picture must be that of one of the lamps
// around.
TEST(Lamps, InACornerShineAsOneNextToIt) {
  // All vertices of the blocks' tops, as the program rounds them, and the middle of an edge.
  std::vector<glm::dvec3> corners = {kA - glm::dvec3(0, 2, 0)};
  for (const auto& [x, z, height] : {std::array{130, 65, 165},
                                     {82, 225, 165},
                                     {240, 272, 165},
                                     {290, 114, 165},
                                     {423, 247, 330},
                                     {265, 296, 330},
                                     {314, 456, 330},
                                     {472, 406, 330}}) {
    const float depth = float(z) / 100 - 2.796f;
    corners.emplace_back(float(x) / 100 - 2.764f, float(height) / 100, depth + 2.796f);
  }
  for (const glm::dvec3& corner : corners) {
    json scene = room();
    scene["light"]["position"] = vec(corner);
    const Image image = draw("shadow_volume", scene, {0}).frames.at(0);
    std::size_t least = image.pixelCount();
    int wrong = 0;
    for (int i = 0; i < 27; ++i) {
      const glm::dvec3 aside(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      scene["light"]["position"] = vec(corner + 1e-4 * aside);
      const Counts counts = countsOf(scene, 0, image);
      EXPECT_GT(counts.judged(), 3000u);
      least = std::min(least, counts.wrong());
      wrong += counts.wrong() > 0;
    }
    EXPECT_EQ(least, 0u) << corner.x << ' ' << corner.y << ' ' << corner.z;
    EXPECT_GT(wrong, 5) << "they are not all the same";
  }
}

TEST(Lamps, PassThroughABlock) {
  // From the air before the tall block through its side, its inside and out again.
  json scene = room({{"orbit", {{"radius", 1.5}, {"period", 16}}}});
  scene["light"]["position"] = {0.92, 2, 2};
  std::vector<double> times;
  for (int i = 0; i < 16; ++i) times.push_back(i);
  for (const int edges : {0, 1}) {
    scene["quality"]["edges"] = edges;
    const Counts counts = expectRight(scene, times);
    EXPECT_GT(counts.lit, 20000u);
    EXPECT_GT(counts.dark, 20000u);
  }
}

} // namespace
