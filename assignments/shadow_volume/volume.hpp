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
//   Do:     for every face, three vertices with its own plane: half-edge h then starts at vertex h.
//           For every edge, two triangles between its half-edges. They have no area yet. Along each
//           half-edge they run against its face.
//   Expect: with V held down the blocks are white.             (README.md, step 1)
inline VolumeMesh shadowVolume(const ClosedMesh& mesh) {
  VolumeMesh volume;
  return volume;
}

// TODO(shadow_volume.6): bonus: the same volume with rectangles only where it has a side.
//   Given:  `mesh`, and `light`, the light's position in the mesh's space.
//   Do:     each point twice: with the plane (0, 0, 0, 1), which has every light in front of it,
//           and with (0, 0, 0, -1). Faces towards the light take the first, the others the second;
//           edges between one of each, the silhouette, get a rectangle, all others nothing.
//   Expect: nothing changes, but far fewer triangles are drawn.  (README.md, step 6)
inline VolumeMesh silhouetteVolume(const ClosedMesh& mesh, const glm::vec3& light) {
  VolumeMesh volume;
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
  return edges;
}
