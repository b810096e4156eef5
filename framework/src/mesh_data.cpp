#include <gg/mesh_data.hpp>

#include <algorithm>
#include <cmath>

#include "words/words.hpp"
#include <gg/error.hpp>
#include <gg/text_file.hpp>
#include <glm/geometric.hpp>

namespace gg {

namespace {

// Any unit vector at a right angle to the unit vector `n`.
glm::vec3 perpendicular(const glm::vec3& n) {
  const glm::vec3 axis = std::abs(n.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  return glm::normalize(glm::cross(axis, n));
}

} // namespace

void standOnFloor(MeshData& mesh) {
  glm::vec3 lowest = mesh.positions.front(), highest = lowest;
  for (const glm::vec3& p : mesh.positions) {
    lowest = glm::min(lowest, p);
    highest = glm::max(highest, p);
  }
  const glm::vec3 extent = highest - lowest;
  const float widest = std::max({extent.x, extent.y, extent.z});
  const float scale = 1 / (extent.y > 1e-3f * widest ? extent.y : widest);
  const glm::vec3 foot((lowest.x + highest.x) / 2, lowest.y, (lowest.z + highest.z) / 2);
  for (glm::vec3& p : mesh.positions) p = (p - foot) * scale;
}

// Lengyel 2001, "Computing Tangent Space Basis Vectors for an Arbitrary Mesh".
void computeTangents(MeshData& mesh) {
  const std::size_t count = mesh.positions.size();
  std::vector<glm::vec3> alongU(count, glm::vec3(0)), alongV(count, glm::vec3(0));
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
    const glm::vec3 e1 = mesh.positions[b] - mesh.positions[a];
    const glm::vec3 e2 = mesh.positions[c] - mesh.positions[a];
    const glm::vec2 d1 = mesh.uvs[b] - mesh.uvs[a], d2 = mesh.uvs[c] - mesh.uvs[a];
    const float determinant = d1.x * d2.y - d2.x * d1.y;
    if (determinant == 0) continue;
    const glm::vec3 u = (e1 * d2.y - e2 * d1.y) / determinant;
    const glm::vec3 v = (e2 * d1.x - e1 * d2.x) / determinant;
    for (std::uint32_t vertex : {a, b, c}) {
      alongU[vertex] += u;
      alongV[vertex] += v;
    }
  }
  mesh.tangents.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3& n = mesh.normals[i];
    const glm::vec3 t = alongU[i] - n * glm::dot(n, alongU[i]);
    const float length = glm::length(t);
    const glm::vec3 tangent = length > 1e-20f ? t / length : perpendicular(n);
    const float handedness = glm::dot(glm::cross(n, tangent), alongV[i]) < 0 ? -1.0f : 1.0f;
    mesh.tangents[i] = glm::vec4(tangent, handedness);
  }
}

MeshData loadMeshData(const std::string& name, const std::string& folder) {
  if (name == "torus_knot") return torusKnot();
  if (name == "box") return box();
  if (name == "plane") return plane(1, 1);
  const std::filesystem::path file = fromUtf8(folder) / fromUtf8(name);
  if (!std::filesystem::exists(file))
    throw FileError(
        say("mesh \"{}\": not torus_knot, box or plane, and no OBJ file {}", name, toUtf8(file)));
  MeshData mesh = readObj(toUtf8(file));
  standOnFloor(mesh);
  return mesh;
}

} // namespace gg
