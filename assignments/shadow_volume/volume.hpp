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
