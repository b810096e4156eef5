#include <gg/camera.hpp>

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

namespace {

void expectNear(const glm::vec3& actual, const glm::vec3& expected, float tolerance = 1e-5f) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << "component " << i;
}

gg::Camera looking(const glm::vec3& position, const glm::vec3& target,
                   const glm::vec3& up = {0, 1, 0}) {
  gg::Camera camera;
  camera.position = position;
  camera.target = target;
  camera.up = up;
  return camera;
}

// A direction of the world as the eye sees it: x right, y up, z toward the viewer.
glm::vec3 seen(const gg::Camera& camera, const glm::vec3& direction) {
  return glm::mat3(camera.view()) * direction;
}

TEST(Camera, ProjectionMapsTheViewVolumeToTheCube) {
  gg::Camera camera;
  camera.fov = 1.2f;
  camera.near = 0.5f;
  camera.far = 20;
  const glm::mat4 projection = camera.projection(2);
  const float h = 0.5f * std::tan(0.6f); // half the height of the near plane
  const glm::vec4 nearCorner = projection * glm::vec4(2 * h, h, -0.5f, 1);
  expectNear(glm::vec3(nearCorner) / nearCorner.w, {1, 1, -1});
  const glm::vec4 farCorner = projection * glm::vec4(-2 * h * 40, -h * 40, -20, 1);
  expectNear(glm::vec3(farCorner) / farCorner.w, {-1, -1, 1});
}

TEST(Camera, ViewPutsTheEyeInTheOriginAndTheTargetAhead) {
  const gg::Camera camera = looking({1, 2, 3}, {1, 2, -2});
  expectNear(glm::vec3(camera.view() * glm::vec4(1, 2, 3, 1)), {0, 0, 0});
  expectNear(glm::vec3(camera.view() * glm::vec4(1, 2, -2, 1)), {0, 0, -5});
  expectNear(glm::vec3(camera.view() * glm::vec4(2, 3, 3, 1)), {1, 1, 0});
}

TEST(Camera, LookingStraightDownHasMinusZOnTop) {
  const gg::Camera camera = looking({0, 5, 0}, {0, 0, 0});
  expectNear(seen(camera, {0, -1, 0}), {0, 0, -1});
  expectNear(seen(camera, {0, 0, -1}), {0, 1, 0});
  expectNear(seen(camera, {1, 0, 0}), {1, 0, 0});
}

TEST(Camera, LookingStraightDownContinuesATiltedLook) {
  const gg::Camera down = looking({0, 5, 0}, {0, 0, 0});
  const gg::Camera tilted = looking({0, 5, 0.01f}, {0, 0, 0});
  for (const glm::vec3 axis : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)})
    expectNear(seen(down, axis), seen(tilted, axis), 0.01f);
}

TEST(Camera, LookingStraightUpHasPlusZOnTop) {
  const gg::Camera camera = looking({0, 0, 0}, {0, 5, 0});
  expectNear(seen(camera, {0, 1, 0}), {0, 0, -1});
  expectNear(seen(camera, {0, 0, 1}), {0, 1, 0});
}

TEST(Camera, AnyUpAlongTheViewIsReplaced) {
  const gg::Camera camera = looking({0, 0, 9}, {0, 0, 0}, {0, 0, -7});
  expectNear(seen(camera, {0, 1, 0}), {0, 1, 0});
  for (const glm::vec3 direction :
       {glm::vec3(1, 0, 0), glm::vec3(1, 1, 1), glm::vec3(-1, 4, 0.5f)}) {
    const glm::mat3 view(looking({0, 0, 0}, direction, direction).view());
    EXPECT_NEAR(glm::determinant(view), 1, 1e-4);
  }
}

TEST(Camera, FarFromTheOriginTheViewStaysARotation) {
  const glm::mat4 view = looking({1e7f, 1e7f, 1e7f}, {1e7f, 1e7f, 1e7f - 8}).view();
  EXPECT_NEAR(glm::determinant(glm::mat3(view)), 1, 1e-5);
  expectNear(glm::mat3(view) * glm::vec3(0, 0, -1), {0, 0, -1});
}

} // namespace
