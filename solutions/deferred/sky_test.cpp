// The sky and its picture: values, directions, and how much light the sun's disc has.

#include "sky.hpp"

#include <gmock/gmock.h>

namespace {

using glm::dvec3;
using glm::vec3;

void expectNear(const dvec3& found, const dvec3& wanted, double by) {
  EXPECT_LE(glm::length(found - wanted), by)
      << found.x << " " << found.y << " " << found.z << " instead of " << wanted.x << " "
      << wanted.y << " " << wanted.z;
}

/// A sun in +x, so that its glow reaches neither the zenith nor what lies towards -x.
Sky simple() {
  Sky sky;
  sky.zenith = {1, 2, 3}, sky.horizon = {5, 4, 3}, sky.ground = {0.5f, 0.25f, 0.125f};
  sky.sunDirection = {1, 0, 0}, sky.sunRadiance = {1000, 2000, 3000};
  return sky;
}

TEST(Sky, GoesFromZenithToHorizonAndEndsThere) {
  expectNear(skyRadiance(simple(), {0, 1, 0}), {1, 2, 3}, 1e-6);
  expectNear(skyRadiance(simple(), {-1, 0, 0}), {5, 4, 3}, 1e-6);
  expectNear(skyRadiance(simple(), {0, 0.5f, std::sqrt(0.75f)}), {1.5, 2.25, 3}, 1e-6);
  expectNear(skyRadiance(simple(), {0, -1e-6f, 1}), {0.5, 0.25, 0.125}, 1e-6);
  expectNear(skyRadiance(simple(), {1, -1e-6f, 0}), {0.5, 0.25, 0.125}, 1e-6); // no glow
}

TEST(Sky, GlowsAboutTheSun) {
  expectNear(skyRadiance(simple(), {1, 0, 0}), {7.5, 6, 4.5}, 1e-5);
  const float c = std::sqrt(0.5f); // c^8 = 1/16
  expectNear(skyRadiance(simple(), {c, 0, c}), dvec3(5, 4, 3) * (1 + 0.5 / 16), 1e-5);
}

TEST(Sky, TheSunsDiscHasItsRadius) {
  for (const float radius : {1e-3f, 0.00465f, 0.5f})
    for (const vec3& towards : {vec3(0.48f, 0.6f, 0.64f), vec3(0, 1, 0), vec3(0, 0, -1)}) {
      Sky sky = simple();
      sky.sunDirection = towards, sky.sunRadius = radius;
      const vec3 aside = glm::normalize(glm::cross(towards, vec3(0.36f, -0.48f, 0.8f)));
      const auto brightness = [&](float angle) {
        const vec3 at = std::cos(angle) * towards + std::sin(angle) * aside;
        return radiance(sky, at).x - skyRadiance(sky, at).x;
      };
      EXPECT_FLOAT_EQ(brightness(0), 1000);
      EXPECT_NEAR(brightness(0.999f * radius), 1000, 0.01);
      EXPECT_EQ(brightness(1.001f * radius), 0);
      EXPECT_EQ(brightness(3.14159f), 0) << "opposite";
    }
}

TEST(EnvironmentMap, DirectionsAreAsDescribed) {
  expectNear(directionOf({0.5, 0.5}), {0, 0, -1}, 1e-6);
  expectNear(directionOf({0.75, 0.5}), {1, 0, 0}, 1e-6);
  expectNear(directionOf({0.25, 0.5}), {-1, 0, 0}, 1e-6);
  expectNear(directionOf({0, 0.5}), {0, 0, 1}, 1e-6);
  expectNear(directionOf({0.3, 0}), {0, 1, 0}, 1e-6);
  expectNear(directionOf({0.3, 1}), {0, -1, 0}, 1e-6);
  for (double u = 0.01; u < 1; u += 0.07)
    for (double v = 0.01; v < 1; v += 0.07) {
      const glm::dvec2 back = uvOf(dvec3(directionOf({u, v})));
      EXPECT_NEAR(back.x, u, 1e-5);
      EXPECT_NEAR(back.y, v, 1e-5);
    }
}

TEST(EnvironmentMap, TexelsAreTheSkyAtTheirMiddles) {
  Sky sky = simple();
  sky.sunRadiance = vec3(0);
  const EnvironmentMap map = environmentMap(sky, 64);
  ASSERT_EQ(map.height, 32);
  ASSERT_EQ(map.texels.size(), 64u * 32);
  expectNear(map.texels[15 * 64 + 16], skyRadiance(sky, directionOf({16.5 / 64, 15.5 / 32})), 1e-6);
  expectNear(map.texels[20 * 64 + 63], sky.ground, 1e-6);
}

TEST(EnvironmentMap, TexelsCoverTheSphere) {
  for (const int width : {2, 16, 1000}) {
    const EnvironmentMap map{width, width / 2, {}};
    double sum = 0;
    for (int y = 0; y < map.height; ++y) sum += width * solidAngle(map, y);
    EXPECT_NEAR(sum, 4 * std::numbers::pi, 1e-9);
  }
}

// Also where the disc is much smaller than a texel, lies on a pole, or on the picture's edge.
TEST(EnvironmentMap, HasAllOfTheSunsLightAndWhereItIs) {
  for (const vec3& towards : {vec3(0.48f, 0.6f, 0.64f), vec3(0, 1, 0), vec3(0, 0, 1),
                              vec3(0, -0.6f, 0.8f), vec3(-0.8f, 0.6f, 0)})
    for (const float radius : {0.00465f, 0.3f})
      for (const int width : {2, 32, 512}) {
        Sky sky = simple();
        sky.sunDirection = towards, sky.sunRadius = radius;
        const EnvironmentMap with = environmentMap(sky, width);
        sky.sunRadiance = vec3(0);
        const EnvironmentMap without = environmentMap(sky, width);
        dvec3 light(0), middle(0);
        for (std::size_t i = 0; i < with.texels.size(); ++i) {
          const int x = int(i) % width, y = int(i) / width;
          const dvec3 share = dvec3(with.texels[i] - without.texels[i]) * solidAngle(with, y);
          light += share;
          middle += share.x * dvec3(directionOf({(x + 0.5) / width, (y + 0.5) / with.height}));
        }
        const double whole = 2 * std::numbers::pi * (1 - std::cos(double(radius)));
        expectNear(light / whole, {1000, 2000, 3000}, 0.5);
        if (width > 2) { // within a texel's diagonal, but for the poles
          EXPECT_LT(glm::length(glm::normalize(middle) - dvec3(towards)),
                    1.5 * std::numbers::pi / with.height);
        }
      }
}

// A large disc: inside the texels have the sun's radiance, outside nothing of it.
TEST(EnvironmentMap, TheDiscIsFilledEvenly) {
  Sky sky = simple();
  sky.sunDirection = {0.48f, 0.6f, 0.64f}, sky.sunRadius = 0.1f;
  const EnvironmentMap map = environmentMap(sky, 512);
  int inside = 0;
  for (std::size_t i = 0; i < map.texels.size(); ++i) {
    const vec3 at = directionOf({(int(i) % 512 + 0.5) / 512, (int(i) / 512 + 0.5) / 256});
    const float angle = std::acos(std::clamp(glm::dot(at, sky.sunDirection), -1.0f, 1.0f));
    const float sun = map.texels[i].x - skyRadiance(sky, at).x;
    if (angle < 0.085f) {
      EXPECT_NEAR(sun, 1000, 50);
      ++inside;
    }
    if (angle > 0.115f) {
      EXPECT_NEAR(sun, 0, 1e-3);
    }
  }
  EXPECT_GT(inside, 100);
}

} // namespace
