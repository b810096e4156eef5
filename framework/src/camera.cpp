#include <gg/camera.hpp>

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace gg {

namespace {

// Sine of the angle between `up` and the view direction below which `up` says nothing.
constexpr double kParallel = 1e-5;

glm::dvec3 usableUp(const glm::dvec3& forward, const glm::dvec3& up) {
  if (glm::length(glm::cross(forward, glm::normalize(up))) > kParallel) return up;
  if (std::abs(forward.y) > 0.5) return {0, 0, forward.y < 0 ? -1 : 1};
  return {0, 1, 0};
}

} // namespace

glm::mat4 Camera::projection(float aspect) const {
  return glm::mat4(glm::perspective<double>(fov, aspect, near, far));
}

// In double precision: far from the origin, float would lose what tells the two points apart.
glm::mat4 Camera::view() const {
  const glm::dvec3 eye(position), center(target);
  const glm::dvec3 forward = glm::normalize(center - eye);
  return glm::mat4(glm::lookAt(eye, center, usableUp(forward, glm::dvec3(up))));
}

} // namespace gg
