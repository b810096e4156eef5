// Which faces of a mesh meet in which edge; and any mesh as a closed one.
//
// A shadow volume must be closed: along every edge as many faces must run one way as the other.
// Not every mesh is, so it is put right first:
//   1. Corners at equal positions are one point; -0 equals 0. (Nearly equal ones are not: a radius
//      would have to know how small the mesh's parts are, and melts those that are smaller.)
//   2. A triangle with two equal corners covers nothing: it is left out. One with three corners in
//      a line stays, because its neighbours meet in it.
//   3. A triangle that is there twice, the same way round, is drawn once. The other way round it
//      is the back of a thin sheet, and stays.
//   4. Where an edge has more faces running one way than the other, the mesh is open, or turned
//      over. Then all triangles that hang together with it get a back: themselves, turned round.
//      Whichever side of such a sheet the light is on, one of the two faces it, and throws the
//      shadow.
//   5. A mesh that is inside out is turned round: in the volume, not in the picture.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numeric>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include <gg/mesh_data.hpp>
#include <glm/geometric.hpp>

using Face = std::array<std::uint32_t, 3>; // three points, counterclockwise

// Half-edge 3 * f + k runs along face f from its corner k to the next corner.
inline std::uint32_t nextCorner(std::uint32_t half) {
  return half % 3 == 2 ? half - 2 : half + 1;
}

// Two half-edges between the same two points, in opposite directions.
struct Edge {
  std::uint32_t one, other;
};

// A mesh whose every half-edge is in exactly one edge.
struct ClosedMesh {
  std::vector<glm::vec3> points; // no two are equal
  std::vector<Face> faces;
  std::vector<Edge> edges;
};

namespace detail {

inline std::string show(const glm::vec3& p) {
  char text[64];
  std::snprintf(text, sizeof(text), "(%g %g %g)", double(p.x), double(p.y), double(p.z));
  return text;
}

inline std::string andMore(std::size_t count) {
  return count < 2 ? "" : " and " + std::to_string(count - 1) + " more";
}

// Rule 1: the points, in ascending order, and which of them each vertex is.
inline std::vector<std::uint32_t> weld(const gg::MeshData& mesh, std::vector<glm::vec3>& points) {
  std::vector<std::tuple<float, float, float, std::uint32_t>> sorted;
  for (const glm::vec3& p : mesh.positions) sorted.emplace_back(p.x, p.y, p.z, sorted.size());
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::uint32_t> pointOf(sorted.size());
  for (const auto& [x, y, z, vertex] : sorted) {
    if (points.empty() || points.back() != glm::vec3(x, y, z)) points.emplace_back(x, y, z);
    pointOf[vertex] = static_cast<std::uint32_t>(points.size() - 1);
  }
  return pointOf;
}

// Rules 2 and 3: takes triangles out of the mesh; returns the faces that are left, in its order.
inline std::vector<Face> takeOutRepeats(gg::MeshData& mesh, const std::vector<glm::vec3>& points,
                                        const std::vector<std::uint32_t>& pointOf,
                                        std::vector<std::string>& warnings) {
  std::vector<Face> faces(mesh.indices.size() / 3);
  std::vector<std::pair<Face, std::uint32_t>> sorted; // lowest point first; the face's number
  std::vector<bool> out(faces.size());
  std::vector<std::uint32_t> thin, again;
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    Face face;
    for (std::uint32_t k = 0; k < 3; ++k) face[k] = pointOf[mesh.indices[3 * i + k]];
    faces[i] = face;
    if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) thin.push_back(i);
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    sorted.emplace_back(face, i);
  }
  for (const std::uint32_t i : thin) out[i] = true;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i].first == sorted[i - 1].first && !out[sorted[i].second])
      again.push_back(sorted[i].second);
  for (const std::uint32_t i : again) out[i] = true;

  const auto warn = [&](const std::vector<std::uint32_t>& which, const char* why) {
    if (which.empty()) return;
    const Face& first = faces[*std::min_element(which.begin(), which.end())];
    warnings.push_back("triangle " + show(points[first[0]]) + " " + show(points[first[1]]) + " " +
                       show(points[first[2]]) + andMore(which.size()) + why);
  };
  warn(thin, ": two corners are the same point; left out");
  warn(again, ": is there more than once; drawn once");

  std::size_t left = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (out[i]) continue;
    for (std::size_t k = 0; k < 3; ++k) mesh.indices[3 * left + k] = mesh.indices[3 * i + k];
    faces[left++] = faces[i];
  }
  faces.resize(left);
  mesh.indices.resize(3 * left);
  return faces;
}

struct HalfEdge {
  std::uint64_t points; // the lower one in the upper half, the higher one in the lower half
  std::uint32_t index;
  bool up; // does it run from the lower to the higher one?
};

// Calls `visit` with the half-edges between each two points: those that run down, then those that
// run up; and how many run down. Sorting numbers brings together what meets, in O(n log n) steps;
// comparing every face with every other takes O(n^2).
template <class Visit> void forEachEdge(const std::vector<Face>& faces, Visit visit) {
  std::vector<HalfEdge> all(3 * faces.size());
  for (std::uint32_t half = 0; half < all.size(); ++half) {
    const std::uint64_t from = faces[half / 3][half % 3];
    const std::uint64_t to = faces[half / 3][nextCorner(half) % 3];
    all[half] = {std::min(from, to) << 32 | std::max(from, to), half, from < to};
  }
  std::sort(all.begin(), all.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.points, a.up, a.index) < std::tie(b.points, b.up, b.index);
  });
  for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
    std::size_t down = 0;
    for (; end < all.size() && all[end].points == all[i].points; ++end) down += !all[end].up;
    visit(std::span<const HalfEdge>(&all[i], end - i), down);
  }
}

// For every face, a number that is the same for all that hang together.
inline std::vector<std::uint32_t> shells(const std::vector<Face>& faces) {
  std::vector<std::uint32_t> towards(faces.size()); // a face of the same shell with a lower number
  std::iota(towards.begin(), towards.end(), 0U);
  const auto lowest = [&](std::uint32_t face) {
    while (towards[face] != face) face = towards[face] = towards[towards[face]];
    return face;
  };
  forEachEdge(faces, [&](std::span<const HalfEdge> meeting, std::size_t) {
    for (const HalfEdge& half : meeting) {
      const std::uint32_t a = lowest(meeting[0].index / 3), b = lowest(half.index / 3);
      towards[std::max(a, b)] = std::min(a, b);
    }
  });
  for (std::uint32_t face = 0; face < faces.size(); ++face) towards[face] = lowest(face);
  return towards;
}

// Rule 4.
inline void addBacks(std::vector<Face>& faces, const std::vector<glm::vec3>& points,
                     std::vector<std::string>& warnings) {
  std::vector<std::uint32_t> unequal; // a half-edge of each edge that is not closed
  std::string first;
  forEachEdge(faces, [&](std::span<const HalfEdge> meeting, std::size_t down) {
    const std::size_t up = meeting.size() - down;
    if (up == down) return;
    if (unequal.empty())
      first = "edge " + show(points[meeting[0].points >> 32]) + " " +
              show(points[meeting[0].points & 0xffffffff]) + ", with " + std::to_string(up) +
              " of its faces one way round and " + std::to_string(down) + " the other";
    unequal.push_back(meeting[0].index);
  });
  if (unequal.empty()) return;
  const std::vector<std::uint32_t> shell = shells(faces);
  std::vector<bool> open(faces.size());
  for (const std::uint32_t half : unequal) open[shell[half / 3]] = true;
  const std::size_t count = faces.size();
  for (std::size_t i = 0; i < count; ++i)
    if (open[shell[i]]) faces.push_back({faces[i][0], faces[i][2], faces[i][1]});
  warnings.push_back(first + ";" + andMore(unequal.size()) +
                     ": the mesh is open or turned over there; in the shadow volume, " +
                     std::to_string(faces.size() - count) + " triangles get a back");
}

// Rule 5. The sum of the tetrahedra between a point and each face is the volume that a closed mesh
// encloses; inside out it is negative.
inline void turnRight(std::vector<Face>& faces, const std::vector<glm::vec3>& points,
                      std::vector<std::string>& warnings) {
  double sum = 0, size = 0;
  for (const Face& face : faces) {
    const glm::dvec3 origin(points[0]), a(points[face[0]]), b(points[face[1]]), c(points[face[2]]);
    const double volume = glm::dot(a - origin, glm::cross(b - origin, c - origin));
    sum += volume;
    size += std::abs(volume);
  }
  if (sum >= -1e-6 * size) return; // sheets enclose nothing
  for (Face& face : faces) std::swap(face[1], face[2]);
  warnings.push_back("the mesh is inside out; in the shadow volume, it is turned round");
}

} // namespace detail

// Puts the mesh right by the rules above: takes triangles out of `mesh` itself (2 and 3), and
// returns it closed. `warnings` say in a line a rule what was done, and where first.
inline ClosedMesh closedMesh(gg::MeshData& mesh, std::vector<std::string>& warnings) {
  ClosedMesh closed;
  const std::vector<std::uint32_t> pointOf = detail::weld(mesh, closed.points);
  closed.faces = detail::takeOutRepeats(mesh, closed.points, pointOf, warnings);
  detail::addBacks(closed.faces, closed.points, warnings);
  detail::turnRight(closed.faces, closed.points, warnings);
  detail::forEachEdge(closed.faces,
                      [&](std::span<const detail::HalfEdge> meeting, std::size_t down) {
                        for (std::size_t i = 0; i < down; ++i)
                          closed.edges.push_back({meeting[i].index, meeting[down + i].index});
                      });
  return closed;
}

// Splits a mesh into parts of which no pixel can be in more volumes than its stencil can count: one
// in 256 volumes would read 0, as one in none does. A ray leaves a closed shell as often as it
// enters it, each time through another face, so it can't be in more volumes than half of the faces.
// One part may use the stencil's eight bits; several, seven, because the eighth remembers the parts
// before. A shell stays whole: if it is so folded that more of its own layers lie over a pixel,
// they count modulo 256.
inline std::vector<ClosedMesh> countableParts(const ClosedMesh& mesh) {
  if (mesh.faces.size() / 2 <= 255) return {mesh};
  const std::vector<std::uint32_t> shell = detail::shells(mesh.faces);
  std::vector<std::size_t> facesOf(mesh.faces.size()); // of the shell of this number
  for (const std::uint32_t one : shell) ++facesOf[one];

  std::vector<ClosedMesh> parts(1);
  std::vector<std::size_t> partOf(mesh.faces.size()); // of the shell of this number
  std::vector<std::uint32_t> faceThere(mesh.faces.size());
  std::size_t volumes = 0; // of the last part, that a pixel can be in
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    if (shell[face] == face) { // its shell's first
      volumes += facesOf[face] / 2;
      if (volumes > 127 && !parts.back().faces.empty()) {
        parts.emplace_back();
        volumes = facesOf[face] / 2;
      }
      partOf[face] = parts.size() - 1;
    }
    std::vector<Face>& faces = parts[partOf[shell[face]]].faces;
    faceThere[face] = static_cast<std::uint32_t>(faces.size());
    faces.push_back(mesh.faces[face]);
  }
  const auto there = [&](std::uint32_t half) { return 3 * faceThere[half / 3] + half % 3; };
  for (const Edge& edge : mesh.edges)
    parts[partOf[shell[edge.one / 3]]].edges.push_back({there(edge.one), there(edge.other)});

  for (ClosedMesh& part : parts) { // each keeps the points that it uses
    std::vector<std::uint32_t> used;
    for (const Face& face : part.faces) used.insert(used.end(), face.begin(), face.end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (const std::uint32_t point : used) part.points.push_back(mesh.points[point]);
    for (Face& face : part.faces)
      for (std::uint32_t& point : face)
        point = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), point) -
                                           used.begin());
  }
  return parts;
}
