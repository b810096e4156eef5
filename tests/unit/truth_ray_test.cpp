#include "truth/ray.hpp"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace ggrade::truth;
using glm::dvec3;

namespace {

constexpr double kPi = std::numbers::pi;

/// A square of side 2 in y = `height` that faces up.
Triangles square(double height) {
  return {{{-1, height, 1}, {1, height, 1}, {1, height, -1}, {-1, height, -1}}, {0, 1, 2, 0, 2, 3}};
}

/// A ball of radius 1 about `middle`, of 2 * `rings` segments.
Triangles ball(const dvec3& middle, std::uint32_t rings) {
  Triangles mesh;
  const std::uint32_t row = 2 * rings + 1;
  for (std::uint32_t i = 0; i <= rings; ++i)
    for (std::uint32_t j = 0; j < row; ++j) {
      const double polar = kPi * i / rings, angle = 2 * kPi * (j % (row - 1)) / (row - 1);
      mesh.positions.push_back(middle + dvec3(std::sin(polar) * std::cos(angle), std::cos(polar),
                                              -std::sin(polar) * std::sin(angle)));
    }
  for (std::uint32_t i = 0; i < rings; ++i)
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
      const std::uint32_t a = i * row + j, b = a + row;
      for (const std::uint32_t v : {a, b, b + 1, a, b + 1, a + 1}) mesh.indices.push_back(v);
    }
  return mesh;
}

dvec3 randomDirection(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return glm::normalize(dvec3(normal(random), normal(random), normal(random)));
}

TEST(TruthRay, MeetsAPlaneWhereItIsInDoublePrecision) {
  const RayScene scene({square(0.3)});
  const dvec3 origin(0.123456789, 2.7, -0.2), direction(0.1, -3, 0.05);
  const auto hit = scene.closestHit(origin, direction);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance, 0.8, 1e-14) << "in lengths of the direction: (2.7 - 0.3) / 3";
  EXPECT_EQ(hit->mesh, 0u);
  EXPECT_NEAR(glm::distance(hit->normal, dvec3(0, 1, 0)), 0, 1e-15);
  EXPECT_NEAR(hit->weights.x + hit->weights.y + hit->weights.z, 1, 1e-15);
  // The weights give back the point.
  const Triangles mesh = square(0.3);
  dvec3 point(0);
  for (int k = 0; k < 3; ++k)
    point += hit->weights[k] * mesh.positions[mesh.indices[3 * hit->triangle + std::uint32_t(k)]];
  EXPECT_NEAR(glm::distance(point, origin + 0.8 * direction), 0, 1e-14);
}

TEST(TruthRay, FindsTheNearestOfSeveralMeshesWithinARange) {
  const RayScene scene({square(0), square(1), square(2)});
  const dvec3 above(0.1, 5, 0.2), down(0, -1, 0);
  EXPECT_EQ(scene.closestHit(above, down)->mesh, 2u);
  EXPECT_EQ(scene.closestHit(above, down, 3.5)->mesh, 1u);
  EXPECT_FALSE(scene.closestHit(above, down, 0, 2.9));
  EXPECT_FALSE(scene.closestHit(above, -down));
  EXPECT_FALSE(scene.closestHit(dvec3(1.001, 5, 0), down)) << "beside the square";
}

TEST(TruthRay, SeesFrontFacesAloneWhenAsked) {
  const RayScene scene({square(0), square(-1)});
  const dvec3 below(0.1, -5, 0.2), up(0, 1, 0);
  EXPECT_EQ(scene.closestHit(below, up)->mesh, 1u);
  EXPECT_FALSE(scene.closestHit(below, up, 0, 100, Faces::front));
  EXPECT_EQ(scene.closestHit(-below, -up, 0, 100, Faces::front)->mesh, 0u);
}

TEST(TruthRay, MeetsABallWhereTheFormulaSays) {
  const std::uint32_t kRings = 200;
  const RayScene scene({ball({3, 1, -2}, kRings)});
  const double sagitta = 2 * (1 - std::cos(kPi / kRings / 2)); // how far a facet lies inside
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const dvec3 direction = randomDirection(random);
    const dvec3 origin = dvec3(3, 1, -2) - 4.0 * direction + 0.3 * randomDirection(random);
    const double along = glm::dot(dvec3(3, 1, -2) - origin, direction);
    const double beside = glm::distance(origin + along * direction, dvec3(3, 1, -2));
    const double expected = along - std::sqrt(1 - beside * beside);
    const auto hit = scene.closestHit(origin, direction);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, expected, 1.2 * sagitta);
    EXPECT_NEAR(glm::dot(hit->normal, origin + hit->distance * direction - dvec3(3, 1, -2)), 1,
                2 * sagitta);
  }
}

TEST(TruthRay, NoRayLeavesAClosedMesh) {
  const RayScene scene({ball({0, 0, 0}, 40)});
  std::mt19937 random(2);
  for (int i = 0; i < 100000; ++i) {
    const dvec3 direction = randomDirection(random);
    ASSERT_TRUE(scene.occluded({0, 0, 0}, direction, 1.001)) << i;
    ASSERT_FALSE(scene.occluded({0, 0, 0}, direction, 0.99)) << i;
  }
}

TEST(TruthRay, OcclusionEndsAtTheDistanceWhateverTheDirectionsLength) {
  const RayScene scene({square(2)});
  EXPECT_TRUE(scene.occluded({0.1, 0, 0.2}, {0, 1, 0}, 2.001));
  EXPECT_FALSE(scene.occluded({0.1, 0, 0.2}, {0, 1, 0}, 1.999));
  EXPECT_TRUE(scene.occluded({0.1, 0, 0.2}, {0, 10, 0}, 2.001));
  EXPECT_FALSE(scene.occluded({0.1, 0, 0.2}, {0, 10, 0}, 1.999));
}

TEST(TruthRay, EmptyMeshesKeepTheirNumber) {
  const RayScene scene({Triangles{}, square(0)});
  EXPECT_EQ(scene.closestHit({0.1, 1, 0.2}, {0, -1, 0})->mesh, 1u);
  EXPECT_FALSE(RayScene({}).closestHit({0, 1, 0}, {0, -1, 0}));
}

TEST(TruthRay, RefusesACornerThatIsNotThere) {
  Triangles mesh = square(0);
  mesh.indices[4] = 4;
  EXPECT_THAT([&] { RayScene{{mesh}}; },
              testing::ThrowsMessage<std::invalid_argument>(
                  testing::HasSubstr("a corner that its mesh doesn't have")));
}

} // namespace
