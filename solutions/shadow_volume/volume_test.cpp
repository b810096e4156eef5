// The volume's mesh, without OpenGL: is it closed, and does it hold what lies in shadow?

#include "cornell.hpp"
#include "volume.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <cmath>
#include <map>
#include <random>

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

namespace {

/// A mesh of these triangles, each with vertices of its own.
gg::MeshData soup(const std::vector<std::array<glm::vec3, 3>>& triangles) {
  gg::MeshData mesh;
  for (const auto& triangle : triangles)
    for (const glm::vec3& corner : triangle) {
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.push_back(corner);
    }
  return mesh;
}

void turnOver(gg::MeshData& mesh, std::size_t triangle) {
  std::swap(mesh.indices[3 * triangle], mesh.indices[3 * triangle + 1]);
}

void drop(gg::MeshData& mesh, std::size_t triangle) {
  const auto first = mesh.indices.begin() + static_cast<std::ptrdiff_t>(3 * triangle);
  mesh.indices.erase(first, first + 3);
}

void add(gg::MeshData& mesh, const gg::MeshData& other, const glm::vec3& at) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const glm::vec3& p : other.positions) mesh.positions.push_back(p + at);
  for (const std::uint32_t i : other.indices) mesh.indices.push_back(first + i);
}

const glm::vec3 kA(0, 0, 0), kB(1, 0, 0), kC(0, 1, 0), kD(0, 0, 1), kE(0, -1, 0);

/// A strip that is turned over once on its way round: no winding is consistent.
gg::MeshData moebius() {
  constexpr int kSteps = 9;
  const auto at = [](int i, float side) {
    const float turn = 6.2831853f * static_cast<float>(i % kSteps) / kSteps;
    if (i >= kSteps) side = -side;
    const float out = 1 + side * std::cos(turn / 2);
    return glm::vec3(out * std::cos(turn), side * std::sin(turn / 2), out * std::sin(turn));
  };
  std::vector<std::array<glm::vec3, 3>> triangles;
  for (int i = 0; i < kSteps; ++i) {
    triangles.push_back({at(i, -0.3f), at(i + 1, -0.3f), at(i + 1, 0.3f)});
    triangles.push_back({at(i, -0.3f), at(i + 1, 0.3f), at(i, 0.3f)});
  }
  return soup(triangles);
}

struct Sample {
  const char* name;
  gg::MeshData mesh;
};

std::vector<Sample> samples() {
  std::vector<Sample> all;
  const auto sample = [&](const char* name, gg::MeshData mesh) -> gg::MeshData& {
    return all.emplace_back(name, std::move(mesh)).mesh;
  };
  sample("box", gg::box());
  sample("blocks", blocks());
  sample("torus knot", gg::torusKnot(24, 6));
  drop(sample("a box without its top's half", gg::box()), 9);
  sample("one triangle", soup({{kA, kB, kC}}));
  sample("two triangles back to back", soup({{kA, kB, kC}, {kA, kC, kB}}));
  sample("three fins at an edge", soup({{kA, kB, kC}, {kA, kB, kD}, {kB, kA, kE}}));
  add(sample("boxes that share an edge", gg::box()), gg::box(), {1, 0, 1});
  turnOver(sample("a box with a triangle turned over", gg::box()), 4);
  sample("Moebius strip", moebius());
  gg::MeshData& inverted = sample("a box inside out", gg::box());
  for (std::size_t i = 0; i < 12; ++i) turnOver(inverted, i);
  add(sample("a triangle twice", gg::box()),
      soup({{glm::vec3(-0.5f, 0, 0.5f), {0.5f, 0, 0.5f}, {0.5f, 1, 0.5f}}}), {});
  add(sample("a triangle with two equal corners", gg::box()), soup({{kA, kA, kC}}), {0, 1, 0});
  // On one side only, the edge from A to B has a corner in the middle; a thin triangle fills in.
  const glm::vec3 middle(0.5f, 0, 0);
  sample("a corner within an edge", soup({{kA, kC, kB},
                                          {kA, middle, kD},
                                          {middle, kB, kD},
                                          {kA, kD, kC},
                                          {kB, kC, kD},
                                          {kA, kB, middle}}));
  sample("zeroes of both signs",
         soup({{kA, kC, kB}, {kA, kB, kD}, {-kA, kD, -0.0f + kC}, {kB, kC, kD}}));
  for (const float scale : {1e-4f, 1e6f})
    for (glm::vec3& p : sample(scale < 1 ? "a tiny box" : "a huge box", gg::box()).positions)
      p *= scale;
  return all;
}

ClosedMesh closed(gg::MeshData mesh) {
  std::vector<std::string> warnings;
  return closedMesh(mesh, warnings);
}

std::vector<std::string> warnings(gg::MeshData mesh) {
  std::vector<std::string> lines;
  closedMesh(mesh, lines);
  return lines;
}

/// As volume.vert has it: does the vertex stay in place?
bool stays(const VolumeVertex& vertex, const glm::vec3& light) {
  return glm::dot(vertex.plane, glm::vec4(light, 1)) >= 0;
}

/// How often more the volume's triangles run along some directed edge than against it, at most; 0:
/// it is closed.
///   inPlace: does a vertex stay, or go to infinity?
template <class InPlace> int imbalance(const VolumeMesh& volume, InPlace inPlace) {
  using Place = std::tuple<float, float, float, bool>;
  const auto place = [&](std::uint32_t index) {
    const VolumeVertex& vertex = volume.vertices.at(index);
    return Place(vertex.position.x, vertex.position.y, vertex.position.z, inPlace(index));
  };
  std::map<std::pair<Place, Place>, int> excess;
  for (std::size_t i = 0; i < volume.indices.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const Place from = place(volume.indices[i + k]), to = place(volume.indices[i + (k + 1) % 3]);
      ++excess[{from, to}];
      --excess[{to, from}];
    }
  int worst = 0;
  for (const auto& [edge, count] : excess) worst = std::max(worst, count);
  return worst;
}

std::vector<glm::vec3> lightsAround(const ClosedMesh& mesh, std::mt19937& random) {
  glm::vec3 low = mesh.points.front(), high = low;
  for (const glm::vec3& p : mesh.points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  std::vector<glm::vec3> lights = {(low + high) / 2.0f}; // inside, or in a face
  for (std::size_t i = 0; i < std::min<std::size_t>(mesh.points.size(), 4); ++i)
    lights.push_back(mesh.points[i]); // in a corner, so in the planes of faces
  lights.push_back(mesh.points.front() + 3.0f * (mesh.points.back() - mesh.points.front()));
  std::uniform_real_distribution<float> anywhere(-1.5f, 2.5f);
  for (int i = 0; i < 20; ++i)
    lights.push_back(low + (high - low + 1e-3f * glm::length(high - low)) *
                               glm::vec3(anywhere(random), anywhere(random), anywhere(random)));
  return lights;
}

class Volumes : public testing::TestWithParam<Sample> {};
INSTANTIATE_TEST_SUITE_P(ShadowVolume, Volumes, testing::ValuesIn(samples()), [](const auto& info) {
  std::string name = info.param.name;
  for (char& c : name)
    if (c == ' ' || c == '\'') c = '_';
  return name;
});

TEST_P(Volumes, AreClosedForEveryLight) {
  const ClosedMesh mesh = closed(GetParam().mesh);
  const VolumeMesh volume = shadowVolume(mesh);
  std::mt19937 random(1);
  for (const glm::vec3& light : lightsAround(mesh, random)) {
    EXPECT_EQ(imbalance(volume, [&](auto i) { return stays(volume.vertices[i], light); }), 0)
        << light.x << " " << light.y << " " << light.z;
    const VolumeMesh outline = silhouetteVolume(mesh, light);
    EXPECT_EQ(imbalance(outline, [&](auto i) { return stays(outline.vertices[i], light); }), 0)
        << "silhouette, " << light.x << " " << light.y << " " << light.z;
  }
}

// Whatever rounding says of a face that the light is in the plane of.
TEST_P(Volumes, AreClosedWhicheverFacesStay) {
  const VolumeMesh volume = shadowVolume(closed(GetParam().mesh));
  std::mt19937 random(2);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<bool> stay(volume.vertices.size() / 3);
    for (std::size_t i = 0; i < stay.size(); ++i) stay[i] = random() % 2;
    ASSERT_EQ(imbalance(volume, [&](auto i) { return bool(stay[i / 3]); }), 0);
  }
}

TEST_P(Volumes, HaveFourTimesTheFaces) {
  const ClosedMesh mesh = closed(GetParam().mesh);
  EXPECT_EQ(2 * mesh.edges.size(), 3 * mesh.faces.size());
  const VolumeMesh volume = shadowVolume(mesh);
  EXPECT_EQ(volume.vertices.size(), 3 * mesh.faces.size());
  EXPECT_EQ(volume.indices.size(), 3 * 4 * mesh.faces.size());
}

/// How many times the triangles wind round a point (van Oosterom and Strackee 1983, solid angles).
double winding(const VolumeMesh& volume, const glm::dvec3& light, const glm::dvec3& point) {
  const auto place = [&](std::uint32_t index) {
    const VolumeVertex& vertex = volume.vertices[index];
    const glm::dvec3 p(vertex.position);
    // As near to infinity as this sum needs.
    return (stays(vertex, glm::vec3(light)) ? p : p + 1e5 * (p - light)) - point;
  };
  double sum = 0;
  for (std::size_t i = 0; i < volume.indices.size(); i += 3) {
    const glm::dvec3 a = place(volume.indices[i]), b = place(volume.indices[i + 1]),
                     c = place(volume.indices[i + 2]);
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    sum += 2 *
           std::atan2(glm::dot(a, glm::cross(b, c)), la * lb * lc + glm::dot(a, b) * lc +
                                                         glm::dot(b, c) * la + glm::dot(c, a) * lb);
  }
  return sum / (4 * 3.14159265358979);
}

/// Does a triangle of the mesh as it was given lie between the two points?
bool isHidden(const gg::MeshData& mesh, const glm::dvec3& light, const glm::dvec3& point) {
  const glm::dvec3 along = point - light;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const glm::dvec3 a(mesh.positions[mesh.indices[i]]), b(mesh.positions[mesh.indices[i + 1]]),
        c(mesh.positions[mesh.indices[i + 2]]);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double slope = glm::dot(normal, along);
    if (slope == 0) continue;
    const double t = glm::dot(normal, a - light) / slope;
    if (t <= 0 || t >= 1) continue;
    const glm::dvec3 hit = light + t * along;
    if (glm::dot(glm::cross(b - a, hit - a), normal) >= 0 &&
        glm::dot(glm::cross(c - b, hit - b), normal) >= 0 &&
        glm::dot(glm::cross(a - c, hit - c), normal) >= 0)
      return true;
  }
  return false;
}

TEST_P(Volumes, HoldWhatTheMeshHidesFromTheLight) {
  const gg::MeshData& original = GetParam().mesh;
  const ClosedMesh mesh = closed(original);
  const VolumeMesh volume = shadowVolume(mesh);
  glm::vec3 low = mesh.points.front(), high = low;
  for (const glm::vec3& p : mesh.points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const glm::vec3 middle = (low + high) / 2.0f;
  const float size = glm::length(high - low);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(-1, 1);
  const auto anywhere = [&] { return glm::vec3(unit(random), unit(random), unit(random)); };
  int hidden = 0;
  constexpr int kPoints = 400;
  for (int i = 0; i < kPoints; ++i) {
    const glm::vec3 light = middle + size * (glm::vec3(0.13f, 0.9f, 0.21f) + 0.3f * anywhere());
    // Behind the mesh, from the light, so that about half of the points are hidden.
    const glm::vec3 point = middle + (middle - light) + 1.2f * size * anywhere();
    const double count = winding(volume, light, point);
    EXPECT_NEAR(count, std::round(count), 1e-3);
    const bool isIn = isHidden(original, light, point);
    EXPECT_EQ(count > 0.5, isIn) << count;
    hidden += isIn;
  }
  EXPECT_GT(hidden, kPoints / 50);
  EXPECT_LT(hidden, kPoints * 49 / 50);
}

TEST(ShadowVolume, OfABox) {
  const VolumeMesh volume = shadowVolume(closed(gg::box()));
  EXPECT_THAT(volume.vertices, SizeIs(36));
  EXPECT_THAT(volume.indices, SizeIs(36 + 6 * 18));
  // From above, the silhouette is the top's outline: 4 edges. From a corner's direction it has 6.
  EXPECT_THAT(silhouetteVolume(closed(gg::box()), {0, 5, 0}).indices, SizeIs(36 + 6 * 4));
  EXPECT_THAT(silhouetteVolume(closed(gg::box()), {5, 5, 5}).indices, SizeIs(36 + 6 * 6));
}

// At infinity it would be a line, and the volume open.
TEST(ShadowVolume, AFaceWithTheLightInItStays) {
  const ClosedMesh mesh = closed(gg::box());
  const VolumeMesh volume = silhouetteVolume(mesh, {0.2f, 1, 0.1f});
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    const bool top = face / 2 == 4;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(stays(volume.vertices[volume.indices[3 * face + k]], {0.2f, 1, 0.1f}), top) << face;
  }
}

TEST(ShadowVolume, APlaneIsPositiveInFrontOfItsFace) {
  const ClosedMesh mesh = closed(soup({{kA, kB, kC}}));
  const VolumeMesh volume = shadowVolume(mesh);
  ASSERT_THAT(volume.vertices, SizeIs(6)); // the triangle and its back
  EXPECT_TRUE(stays(volume.vertices[0], {5, -3, 0.01f}));
  EXPECT_FALSE(stays(volume.vertices[0], {5, -3, -0.01f}));
  EXPECT_FALSE(stays(volume.vertices[3], {5, -3, 0.01f}));
}

/// Every half-edge in one edge, with another that runs the other way.
void expectPaired(const std::vector<Edge>& edges, const std::vector<Face>& faces) {
  std::vector<int> times(3 * faces.size());
  const auto from = [&](std::uint32_t half) { return faces[half / 3][half % 3]; };
  for (const Edge& edge : edges) {
    EXPECT_EQ(from(edge.one), from(nextCorner(edge.other)));
    EXPECT_EQ(from(edge.other), from(nextCorner(edge.one)));
    ++times[edge.one], ++times[edge.other];
  }
  EXPECT_THAT(times, testing::Each(1));
}

TEST(SharedEdges, PairEveryHalfEdgeOfAClosedMesh) {
  gg::MeshData touching = gg::box(); // two boxes that share an edge, in which four faces meet
  add(touching, gg::box(), {1, 1, 0});
  for (const gg::MeshData& mesh : {gg::box(), blocks(), touching, gg::torusKnot()}) {
    const ClosedMesh known = closed(mesh);
    const std::vector<Edge> found = sharedEdges(known.faces);
    EXPECT_EQ(found.size(), known.edges.size());
    expectPaired(found, known.faces);
  }
}

TEST(SharedEdges, OfAHundredThousandFacesTakeNoMinute) {
  std::vector<Face> faces; // a torus of 250 x 200 squares
  const auto at = [](std::uint32_t i, std::uint32_t k) { return i % 250 * 200 + k % 200; };
  for (std::uint32_t i = 0; i < 250; ++i)
    for (std::uint32_t k = 0; k < 200; ++k) {
      faces.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      faces.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<Edge> edges = sharedEdges(faces);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
  EXPECT_THAT(edges, SizeIs(150000));
}

TEST(ClosedMesh, NothingIsSaidOfAGoodMesh) {
  EXPECT_THAT(warnings(gg::box()), IsEmpty());
  EXPECT_THAT(warnings(blocks()), IsEmpty());
  EXPECT_THAT(warnings(gg::torusKnot()), IsEmpty());
  EXPECT_THAT(warnings(soup({{kA, kB, kC}, {kA, kC, kB}})), IsEmpty());
}

TEST(ClosedMesh, AnOpenMeshGetsBacks) {
  gg::MeshData mesh = gg::box();
  drop(mesh, 9); // half of the top
  EXPECT_THAT(
      warnings(mesh),
      ElementsAre("edge (-0.5 1 -0.5) (-0.5 1 0.5), with 0 of its faces one way round and 1 the "
                  "other; and 2 more: the mesh is open or turned over there; in the shadow "
                  "volume, 11 triangles get a back"));
  EXPECT_THAT(closed(mesh).faces, SizeIs(22));
}

TEST(ClosedMesh, OnlyWhatHangsTogetherGetsBacks) {
  gg::MeshData mesh = gg::box();
  add(mesh, gg::plane(1, 1), {3, 0, 0});
  EXPECT_THAT(warnings(mesh), ElementsAre(HasSubstr("2 triangles get a back")));
  EXPECT_THAT(closed(mesh).faces, SizeIs(12 + 4));
}

TEST(ClosedMesh, ATriangleThatIsThereTwiceIsLeftOutOnce) {
  gg::MeshData mesh = gg::box();
  add(mesh, mesh, {});
  std::vector<std::string> lines;
  EXPECT_THAT(closedMesh(mesh, lines).faces, SizeIs(12));
  EXPECT_THAT(lines,
              ElementsAre("triangle (-0.5 0 0.5) (0.5 0 0.5) (0.5 1 0.5) and 11 more: is there "
                          "more than once; drawn once"));
  EXPECT_EQ(mesh.indices, gg::box().indices);
}

TEST(ClosedMesh, ATriangleWithTwoEqualCornersIsLeftOut) {
  gg::MeshData mesh = gg::box();
  add(mesh, soup({{kA, kA, kC}, {kB, kC, kB}}), {2, 0, 0});
  std::vector<std::string> lines;
  EXPECT_THAT(closedMesh(mesh, lines).faces, SizeIs(12));
  EXPECT_THAT(lines,
              ElementsAre("triangle (2 0 0) (2 0 0) (2 1 0) and 1 more: two corners are the same "
                          "point; left out"));
  EXPECT_EQ(mesh.indices, gg::box().indices);
}

TEST(ClosedMesh, AMeshThatIsInsideOutIsTurnedRound) {
  gg::MeshData mesh = gg::box();
  for (std::size_t i = 0; i < 12; ++i) turnOver(mesh, i);
  std::vector<std::string> lines;
  const ClosedMesh turned = closedMesh(mesh, lines);
  EXPECT_THAT(turned.faces, SizeIs(12));
  EXPECT_THAT(lines,
              ElementsAre("the mesh is inside out; in the shadow volume, it is turned round"));
  EXPECT_NE(mesh.indices, gg::box().indices) << "what is seen stays";
  EXPECT_GT(winding(shadowVolume(turned), {0.3, 9, 0.2}, {0, 0.5, 0}), 0.5);
}

TEST(ClosedMesh, WeldsEqualPositionsOnly) {
  EXPECT_THAT(closed(soup({{kA, kB, kC}, {-kA, kC, kB}})).points, SizeIs(3)); // -0 is 0
  // As far apart as the lecture's radius of 0.0316 reaches, and much nearer: different points.
  const float least = std::nextafter(1.0f, 2.0f);
  EXPECT_THAT(closed(soup({{kA, kB, kC}, {kA, glm::vec3(least, 0, 0), kD}})).points, SizeIs(5));
}

TEST(ClosedMesh, OfNothingIsNothing) {
  EXPECT_THAT(closed({}).faces, IsEmpty());
  EXPECT_THAT(shadowVolume(closed({})).indices, IsEmpty());
}

TEST(CountableParts, AreOneForUpTo255Volumes) {
  gg::MeshData mesh;
  for (int i = 0; i < 42; ++i) add(mesh, gg::box(), {2 * i, 0, 0}); // 252
  EXPECT_THAT(countableParts(closed(mesh)), SizeIs(1));
  EXPECT_THAT(countableParts(closed(gg::torusKnot())), SizeIs(1)); // one shell
}

TEST(CountableParts, HaveUpTo127VolumesAndEveryFaceOnce) {
  gg::MeshData mesh;
  for (int i = 0; i < 43; ++i) add(mesh, gg::box(), {2 * i, 0, 0}); // 258
  const ClosedMesh whole = closed(mesh);
  const std::vector<ClosedMesh> parts = countableParts(whole);
  ASSERT_THAT(parts, SizeIs(3)); // of 21, 21 and 1 box
  EXPECT_THAT(parts[0].faces, SizeIs(21 * 12));
  EXPECT_THAT(parts[0].points, SizeIs(21 * 8));
  EXPECT_THAT(parts[2].edges, SizeIs(18));
  std::vector<std::array<glm::vec3, 3>> before, after;
  const auto list = [](const ClosedMesh& from, auto& to) {
    for (const Face& f : from.faces)
      to.push_back({from.points[f[0]], from.points[f[1]], from.points[f[2]]});
  };
  list(whole, before);
  for (const ClosedMesh& part : parts) {
    list(part, after);
    const VolumeMesh volume = shadowVolume(part);
    EXPECT_EQ(imbalance(volume, [&](auto i) { return stays(volume.vertices[i], {3, 9, 1}); }), 0);
  }
  EXPECT_EQ(before, after);
}

TEST(CountableParts, AFoldedShellStaysWhole) {
  gg::MeshData mesh = gg::torusKnot();
  add(mesh, gg::box(), {3, 0, 0});
  add(mesh, gg::box(), {6, 0, 0});
  const std::vector<ClosedMesh> parts = countableParts(closed(mesh));
  ASSERT_THAT(parts, SizeIs(2));
  EXPECT_THAT(parts[0].faces, SizeIs(5120));
  EXPECT_THAT(parts[1].faces, SizeIs(24));
}

TEST(Cornell, BlocksHaveThePublishedCorners) {
  const gg::MeshData mesh = blocks();
  const glm::vec3 origin(2.764f, 0, 2.796f); // of the model's space in the published one, 100 mm
  const auto has = [&](const glm::vec3& corner) {
    return std::any_of(mesh.positions.begin(), mesh.positions.end(), [&](const glm::vec3& p) {
      return glm::length(p + origin - corner) < 1e-4f;
    });
  };
  EXPECT_TRUE(has({1.30f, 1.65f, 0.65f}) && has({0.82f, 1.65f, 2.25f}) &&
              has({2.40f, 1.65f, 2.72f}) && has({2.90f, 1.65f, 1.14f}));
  EXPECT_TRUE(has({4.23f, 3.30f, 2.47f}) && has({2.65f, 3.30f, 2.96f}) &&
              has({3.14f, 3.30f, 4.56f}) && has({4.72f, 3.30f, 4.06f}));
}

// Each wall's normal points into the room, each block's out of it.
TEST(Cornell, FacesTheRightWay) {
  for (const Wall& wall : walls())
    for (std::size_t i = 0; i < wall.mesh.positions.size(); ++i)
      EXPECT_GT(
          glm::dot(wall.mesh.normals[i], kRoom * glm::vec3(0, 0.5f, 0.5f) - wall.mesh.positions[i]),
          0);
  EXPECT_GT(winding(shadowVolume(closed(blocks())), {0, 50, 0}, {1.0, -1.0, 0.6}),
            0.5); // under the tall one
}

} // namespace
