// The meshes that are made by formula.

#include <gg/mesh_data.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <glm/geometric.hpp>

namespace gg {

namespace {

constexpr double kTurn = 6.283185307179586;

constexpr double kStep = 1e-4; // of derivatives, in radians of the knot's parameter

// The trefoil's centre line winds twice round the z axis while it goes three times round a circle
// of radius 2. Turned by a quarter so that one lobe points up.
glm::dvec3 trefoil(double t) {
  const double radius = 2 + std::cos(3 * t);
  return {-radius * std::sin(2 * t), radius * std::cos(2 * t), std::sin(3 * t)};
}

// A point of the tube about it and its normal.
struct TubePoint {
  glm::dvec3 position, normal;
};

TubePoint tube(double t, double angle) {
  constexpr double kRadius = 0.62; // the strands of this trefoil are about 2 apart
  const glm::dvec3 center = trefoil(t);
  const glm::dvec3 forward = trefoil(t + kStep) - trefoil(t - kStep);
  // The frame hangs on the direction away from the circle, so it closes by itself.
  const glm::dvec3 circle(-2 * std::sin(2 * t), 2 * std::cos(2 * t), 0);
  const glm::dvec3 side = glm::normalize(glm::cross(center - circle, forward));
  const glm::dvec3 out = glm::normalize(glm::cross(forward, side));
  const glm::dvec3 normal = std::cos(angle) * out + std::sin(angle) * side;
  return {center + kRadius * normal, normal};
}

// The four corners of a face, counterclockwise, as two triangles.
void addFace(MeshData& mesh, const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const glm::vec3 normal = glm::normalize(glm::cross(u, v));
  const glm::vec4 tangent(glm::normalize(u), 1);
  for (const glm::vec2 uv : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
    mesh.positions.push_back(corner + u * uv.x + v * uv.y);
    mesh.normals.push_back(normal);
    mesh.uvs.push_back(uv);
    mesh.tangents.push_back(tangent);
  }
  for (std::uint32_t i : {0, 1, 2, 0, 2, 3}) mesh.indices.push_back(first + i);
}

} // namespace

MeshData torusKnot(int along, int around) {
  if (along < 3 || around < 3) throw std::invalid_argument("torusKnot: at least 3 segments");
  MeshData mesh;
  for (int i = 0; i <= along; ++i) {
    const double t = kTurn * (i % along) / along;
    for (int j = 0; j <= around; ++j) {
      const double angle = kTurn * (j % around) / around;
      const TubePoint point = tube(t, angle);
      const glm::dvec3 onward = tube(t + kStep, angle).position - tube(t - kStep, angle).position;
      mesh.positions.emplace_back(point.position);
      mesh.normals.emplace_back(point.normal);
      mesh.uvs.emplace_back(static_cast<float>(i) / static_cast<float>(along),
                            static_cast<float>(j) / static_cast<float>(around));
      mesh.tangents.emplace_back(glm::dvec4(glm::normalize(onward), 1));
    }
  }
  const auto row = static_cast<std::uint32_t>(around + 1);
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(along); ++i) {
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
      const std::uint32_t a = i * row + j, b = a + row;
      for (std::uint32_t v : {a, b, b + 1, a, b + 1, a + 1}) mesh.indices.push_back(v);
    }
  }

  standOnFloor(mesh);
  return mesh;
}

MeshData box() {
  MeshData mesh;
  constexpr float h = 0.5f;
  addFace(mesh, {-h, 0, h}, {1, 0, 0}, {0, 1, 0});  // front, +z
  addFace(mesh, {h, 0, -h}, {-1, 0, 0}, {0, 1, 0}); // back
  addFace(mesh, {h, 0, h}, {0, 0, -1}, {0, 1, 0});  // right, +x
  addFace(mesh, {-h, 0, -h}, {0, 0, 1}, {0, 1, 0}); // left
  addFace(mesh, {-h, 1, h}, {1, 0, 0}, {0, 0, -1}); // top
  addFace(mesh, {-h, 0, -h}, {1, 0, 0}, {0, 0, 1}); // bottom
  return mesh;
}

MeshData plane(float width, float depth) {
  MeshData mesh;
  addFace(mesh, {-width / 2, 0, depth / 2}, {width, 0, 0}, {0, 0, -depth});
  return mesh;
}

} // namespace gg
