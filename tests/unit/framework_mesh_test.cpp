#include <gg/mesh_data.hpp>

#include <cmath>
#include <set>

#include "framework_temporary_folder.hpp"
#include "framework_throws.hpp"
#include <gg/error.hpp>
#include <gg/math.hpp>
#include <gmock/gmock.h>

namespace {

constexpr double kPi = 3.14159265358979;

glm::dvec3 corner(const gg::MeshData& mesh, std::size_t index) {
  return glm::dvec3(mesh.positions[mesh.indices[index]]);
}

// Volume by the divergence theorem: positive if front faces look outward.
double volume(const gg::MeshData& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    sum += glm::dot(corner(mesh, i), glm::cross(corner(mesh, i + 1), corner(mesh, i + 2))) / 6;
  return sum;
}

double area(const gg::MeshData& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::dvec3 a = corner(mesh, i);
    sum += glm::length(glm::cross(corner(mesh, i + 1) - a, corner(mesh, i + 2) - a)) / 2;
  }
  return sum;
}

struct Bounds {
  glm::vec3 lowest, highest;
};
Bounds bounds(const gg::MeshData& mesh) {
  Bounds result{mesh.positions.front(), mesh.positions.front()};
  for (const glm::vec3& p : mesh.positions) {
    result.lowest = glm::min(result.lowest, p);
    result.highest = glm::max(result.highest, p);
  }
  return result;
}

void expectNear(const glm::vec3& actual, const glm::vec3& expected, float tolerance = 1e-5f) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << "component " << i;
}

void expectWellFormed(const gg::MeshData& mesh) {
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
  ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
  ASSERT_EQ(mesh.indices.size() % 3, 0u);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3 tangent(mesh.tangents[i]);
    EXPECT_NEAR(glm::length(mesh.normals[i]), 1, 1e-5);
    EXPECT_NEAR(glm::length(tangent), 1, 1e-5);
    EXPECT_NEAR(glm::dot(tangent, mesh.normals[i]), 0, 1e-4);
    EXPECT_EQ(std::abs(mesh.tangents[i].w), 1);
  }
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    ASSERT_LT(mesh.indices[i], mesh.positions.size());
    const glm::dvec3 a = corner(mesh, i);
    const glm::dvec3 face =
        glm::normalize(glm::cross(corner(mesh, i + 1) - a, corner(mesh, i + 2) - a));
    for (int k = 0; k < 3; ++k)
      EXPECT_GT(glm::dot(face, glm::dvec3(mesh.normals[mesh.indices[i + k]])), 0.8);
  }
}

// The middle of each ring of a knot's tube.
std::vector<glm::dvec3> centerLine(const gg::MeshData& knot, int along, int around) {
  std::vector<glm::dvec3> centers;
  for (int i = 0; i < along; ++i) {
    glm::dvec3 sum(0);
    for (int j = 0; j < around; ++j) sum += glm::dvec3(knot.positions[i * (around + 1) + j]);
    centers.push_back(sum / static_cast<double>(around));
  }
  return centers;
}

// Gauss's double integral over a closed curve: it changes its sign in the mirror, and no turn or
// shift changes it.
double writhe(const std::vector<glm::dvec3>& curve) {
  const std::size_t n = curve.size();
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      if (i == j) continue;
      const glm::dvec3 a = curve[(i + 1) % n] - curve[(i + n - 1) % n];
      const glm::dvec3 b = curve[(j + 1) % n] - curve[(j + n - 1) % n];
      const glm::dvec3 r = curve[i] - curve[j];
      sum += glm::dot(glm::cross(a, b), r) / 4 / std::pow(glm::length(r), 3);
    }
  }
  return sum / (4 * kPi);
}

TEST(TorusKnot, StandsOnTheFloorOneHighInTheMiddle) {
  const gg::MeshData knot = gg::torusKnot();
  expectWellFormed(knot);
  const Bounds b = bounds(knot);
  EXPECT_NEAR(b.lowest.y, 0, 1e-6);
  EXPECT_NEAR(b.highest.y, 1, 1e-6);
  EXPECT_NEAR(b.lowest.x, -b.highest.x, 1e-6);
  EXPECT_NEAR(b.lowest.z, -b.highest.z, 1e-6);
}

// A tube of radius r and length L has volume pi r^2 L and area 2 pi r L (Pappus), whatever its
// curve; the curve's length is the integral of sqrt(9 + 4 (2 + cos 3t)^2).
TEST(TorusKnot, IsATubeOfTheRightLength) {
  const gg::MeshData knot = gg::torusKnot(1200, 120);
  const double v = volume(knot), a = area(knot);
  double length = 0;
  const int steps = 10000;
  for (int i = 0; i < steps; ++i) {
    const double radius = 2 + std::cos(3 * 2 * kPi * i / steps);
    length += std::sqrt(9 + 4 * radius * radius) * 2 * kPi / steps;
  }
  EXPECT_GT(v, 0);
  EXPECT_NEAR((a * a / (4 * kPi * v)) / (2 * v / a) / (length / 0.62), 1, 2e-3);
}

TEST(TorusKnot, IsNotItsOwnMirrorImage) {
  const int along = 400, around = 8;
  std::vector<glm::dvec3> curve = centerLine(gg::torusKnot(along, around), along, around);
  const double own = writhe(curve);
  for (glm::dvec3& p : curve) p.y = -p.y;
  const double mirrored = writhe(curve);
  EXPECT_GT(std::abs(own), 3); // an ideal trefoil's is 3.4
  EXPECT_NEAR(mirrored, -own, 1e-9);
}

TEST(TorusKnot, TangentsFollowU) {
  const int along = 300, around = 40, row = around + 1;
  const gg::MeshData knot = gg::torusKnot(along, around);
  for (int i = 1; i < along; i += 7) {
    for (int j = 1; j < around; j += 3) {
      const int at = i * row + j;
      const glm::vec3 alongU = knot.positions[at + row] - knot.positions[at - row];
      const glm::vec3 alongV = knot.positions[at + 1] - knot.positions[at - 1];
      const glm::vec3 tangent(knot.tangents[at]);
      EXPECT_GT(glm::dot(glm::normalize(alongU), tangent), 0.999);
      const glm::vec3 bitangent = knot.tangents[at].w * glm::cross(knot.normals[at], tangent);
      EXPECT_GT(glm::dot(glm::normalize(alongV), bitangent), 0.7);
    }
  }
}

TEST(TorusKnot, NeedsThreeSegments) {
  EXPECT_THROW(gg::torusKnot(2, 8), std::invalid_argument);
  EXPECT_THROW(gg::torusKnot(8, 2), std::invalid_argument);
  expectWellFormed(gg::box());
}

TEST(Box, HasVolumeOneAndAreaSix) {
  const gg::MeshData box = gg::box();
  expectWellFormed(box);
  EXPECT_NEAR(volume(box), 1, 1e-6);
  EXPECT_NEAR(area(box), 6, 1e-6);
  EXPECT_EQ(box.positions.size(), 24u);
  const Bounds b = bounds(box);
  expectNear(b.lowest, {-0.5, 0, -0.5});
  expectNear(b.highest, {0.5, 1, 0.5});
}

TEST(Plane, FacesUpAndCarriesUv) {
  const gg::MeshData plane = gg::plane(4, 2);
  expectWellFormed(plane);
  EXPECT_NEAR(area(plane), 8, 1e-5);
  for (std::size_t i = 0; i < plane.positions.size(); ++i) {
    const glm::vec3& p = plane.positions[i];
    EXPECT_EQ(p.y, 0);
    EXPECT_EQ(plane.normals[i], glm::vec3(0, 1, 0));
    EXPECT_EQ(plane.tangents[i], glm::vec4(1, 0, 0, 1));
    EXPECT_NEAR(plane.uvs[i].x, p.x / 4 + 0.5, 1e-6);
    EXPECT_NEAR(plane.uvs[i].y, -p.z / 2 + 0.5, 1e-6);
  }
}

TEST(ComputeTangents, KnowsMirroredUv) {
  gg::MeshData plane = gg::plane(2, 2);
  for (glm::vec2& uv : plane.uvs) uv.x = -uv.x;
  gg::computeTangents(plane);
  for (const glm::vec4& t : plane.tangents) EXPECT_EQ(t, glm::vec4(-1, 0, 0, -1));
}

TEST(ComputeTangents, FindsAnyWhereUvSaysNothing) {
  gg::MeshData box = gg::box();
  for (glm::vec2& uv : box.uvs) uv = {0.5, 0.5};
  gg::computeTangents(box);
  expectWellFormed(box);
}

TEST(StandOnFloor, MakesThingsOneHighAndFlatThingsOneWide) {
  gg::MeshData box = gg::box();
  for (glm::vec3& p : box.positions) p = p * glm::vec3(2, 4, 6) + glm::vec3(10, -3, 7);
  gg::standOnFloor(box);
  expectNear(bounds(box).lowest, {-0.25, 0, -0.75});
  expectNear(bounds(box).highest, {0.25, 1, 0.75});
  gg::MeshData plane = gg::plane(8, 2);
  gg::standOnFloor(plane);
  expectNear(bounds(plane).highest, {0.5, 0, 0.125});
}

TEST(LoadMeshData, KnowsNamesAndFiles) {
  const TemporaryFolder folder;
  folder.write("tri.obj", "v 0 5 0\nv 2 5 0\nv 0 7 0\nf 1 2 3\n");
  const std::string here = folder.path().string();
  EXPECT_EQ(gg::loadMeshData("torus_knot", here).positions, gg::torusKnot().positions);
  EXPECT_EQ(gg::loadMeshData("box", here).indices, gg::box().indices);
  EXPECT_EQ(gg::loadMeshData("plane", here).positions, gg::plane(1, 1).positions);
  expectNear(bounds(gg::loadMeshData("tri.obj", here)).highest, {0.5, 1, 0});
  EXPECT_EQ(messageOf<gg::FileError>([&] { gg::loadMeshData("cube", here); }),
            "mesh \"cube\": not torus_knot, box or plane, and no OBJ file " + here + "/cube");
}

TEST(Cofactor, TakesCrossProductsAlong) {
  glm::mat4 m = glm::rotate(glm::mat4(1), 0.7f, {1, 2, 3});
  m = glm::scale(m, {2, 0.5f, 3});
  const glm::vec3 a(1, 2, -1), b(0.5f, -1, 4);
  expectNear(glm::cross(glm::mat3(m) * a, glm::mat3(m) * b), gg::cofactor(m) * glm::cross(a, b));
  const glm::mat3 expected =
      glm::determinant(glm::mat3(m)) * glm::transpose(glm::inverse(glm::mat3(m)));
  for (int i = 0; i < 3; ++i) expectNear(gg::cofactor(m)[i], expected[i], 1e-4f);
}

TEST(Cofactor, TurnsRoundInAMirrorAndKeepsOutOfDivisions) {
  const glm::mat4 mirror = glm::scale(glm::mat4(1), {1, -1, 1});
  expectNear(gg::cofactor(mirror) * glm::vec3(1, 0, 0), {-1, 0, 0});
  expectNear(gg::cofactor(mirror) * glm::vec3(0, 1, 0), {0, 1, 0});
  const glm::mat4 flat = glm::scale(glm::mat4(1), {1, 0, 1}); // has no inverse
  expectNear(gg::cofactor(flat) * glm::vec3(0, 1, 0), {0, 1, 0});
}

} // namespace
