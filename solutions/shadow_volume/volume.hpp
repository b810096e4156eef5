// The shadow volume's mesh.
#pragma once

#include "edges.hpp"

#include <map>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

// What volume.vert gets of a vertex; both in the caster's model space.
struct VolumeVertex {
  glm::vec3 position;
  // The plane of the face that the vertex belongs to: its normal (any length), and what makes
  // dot(plane, vec4(q, 1)) positive for points q in front of the face, negative behind it.
  glm::vec4 plane;
};

// Triangles: three indices each.
struct VolumeMesh {
  std::vector<VolumeVertex> vertices;
  std::vector<std::uint32_t> indices;
};

// TODO(shadow_volume.1): the faces with vertices of their own, and a rectangle in every edge.
//   Given:  `mesh`: points, faces (three points each), edges (two half-edges each): edges.hpp.
//   Goal:   every face has three vertices of its own, with its plane, so that half-edge h starts at
//           vertex h. Two triangles fill every edge from one of its half-edges to the other; they
//           have no area yet. Along each half-edge they run against its face, as neighbours do.
//   Expect: with V held down the blocks are white.             (README.md, step 1)
inline VolumeMesh shadowVolume(const ClosedMesh& mesh) {
  VolumeMesh volume;
  // BEGIN SOLUTION(shadow_volume.1)
  for (const Face& face : mesh.faces) {
    const glm::vec3 a = mesh.points[face[0]], b = mesh.points[face[1]], c = mesh.points[face[2]];
    const glm::vec3 normal = glm::cross(b - a, c - a);
    for (const glm::vec3& corner : {a, b, c}) {
      volume.indices.push_back(static_cast<std::uint32_t>(volume.vertices.size()));
      volume.vertices.push_back({corner, glm::vec4(normal, -glm::dot(normal, a))});
    }
  }
  for (const Edge& edge : mesh.edges) {
    const std::uint32_t a = edge.one, b = nextCorner(a);   // from a to b along one face
    const std::uint32_t c = edge.other, d = nextCorner(c); // back, along the other
    for (const std::uint32_t vertex : {b, a, d, b, d, c}) volume.indices.push_back(vertex);
  }
  // END SOLUTION(shadow_volume.1)
  return volume;
}

// TODO(shadow_volume.6): bonus: the same volume with rectangles only where it has a side.
//   Given:  `mesh`, and `light`, the light's position in the mesh's space.
//   Goal:   volume.vert makes of it what it makes of the whole one: faces towards the light stay,
//           the others go to infinity, though a point is there twice at most. (The plane
//           (0, 0, 0, 1) has every light in front of it, (0, 0, 0, -1) none.) Only the edges of the
//           silhouette, between a face of each kind, have a rectangle.
//   Expect: nothing changes, but far fewer triangles are drawn.  (README.md, step 6)
inline VolumeMesh silhouetteVolume(const ClosedMesh& mesh, const glm::vec3& light) {
  VolumeMesh volume;
  // BEGIN SOLUTION(shadow_volume.6)
  for (const glm::vec3& point : mesh.points) {
    volume.vertices.push_back({point, glm::vec4(0, 0, 0, 1)});
    volume.vertices.push_back({point, glm::vec4(0, 0, 0, -1)});
  }
  for (const Face& face : mesh.faces) {
    const glm::vec3 a = mesh.points[face[0]], b = mesh.points[face[1]], c = mesh.points[face[2]];
    const bool lit = glm::dot(glm::cross(b - a, c - a), light - a) >= 0;
    for (const std::uint32_t point : face) volume.indices.push_back(2 * point + (lit ? 0 : 1));
  }
  for (const Edge& edge : mesh.edges) {
    const std::uint32_t a = volume.indices[edge.one], b = volume.indices[nextCorner(edge.one)];
    const std::uint32_t c = volume.indices[edge.other], d = volume.indices[nextCorner(edge.other)];
    if (a == d) continue; // both in place, or both at infinity
    for (const std::uint32_t vertex : {b, a, d, b, d, c}) volume.indices.push_back(vertex);
  }
  // END SOLUTION(shadow_volume.6)
  return volume;
}

// TODO(shadow_volume.7): bonus: find which faces meet in which edge, as closedMesh() does.
//   Given:  `faces` of a closed mesh: each half-edge has another that runs the other way between
//           the same two points. They are numbered as in edges.hpp, which has nextCorner().
//   Goal:   every half-edge is in exactly one edge, with such another one; and a mesh of 100,000
//           faces takes no minute.
//   Expect: the same shadows with "quality": { "search": 1 }.     (README.md, step 7)
inline std::vector<Edge> sharedEdges(const std::vector<Face>& faces) {
  std::vector<Edge> edges;
  // BEGIN SOLUTION(shadow_volume.7)
  // Half-edges that have not met another one yet, by the points from and to which they run.
  std::multimap<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> alone;
  for (std::uint32_t half = 0; half < 3 * faces.size(); ++half) {
    const Face& face = faces[half / 3];
    const std::uint32_t from = face[half % 3], to = face[nextCorner(half) % 3];
    const auto other = alone.find({to, from});
    if (other == alone.end()) {
      alone.insert({{from, to}, half});
    } else {
      edges.push_back({other->second, half});
      alone.erase(other);
    }
  }
  // END SOLUTION(shadow_volume.7)
  return edges;
}
