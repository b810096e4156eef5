// The Cornell box: five walls and two blocks.
//
// Dimensions and reflectances: Cornell University Program of Computer Graphics, "Cornell Box Data"
// (www.graphics.cornell.edu/online/box/data.html). The published room is in millimetres, x to the
// left of its camera and z into the room, its floor in y = 0; here one unit is 100 mm and x = 0 the
// middle. Its reflectances are spectra; here, the RGB that is usually taken for them.
#pragma once

#include <array>
#include <vector>

#include <gg/mesh_data.hpp>
#include <glm/geometric.hpp>

constexpr glm::vec3 kWhite(0.73f, 0.71f, 0.68f);
constexpr glm::vec3 kRed(0.63f, 0.06f, 0.05f);
constexpr glm::vec3 kGreen(0.14f, 0.45f, 0.09f);

constexpr glm::vec3 kRoom(5.528f, 5.488f, 5.592f); // width, height, depth
constexpr glm::vec3 kMiddle(0, 0, kRoom.z / 2);    // of the floor

struct Wall {
  gg::MeshData mesh; // room space
  glm::vec3 color;
};

// Adds a flat rectangle, corners counterclockwise.
inline void addRectangle(gg::MeshData& mesh, const std::array<glm::vec3, 4>& corners) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const glm::vec3 u = corners[1] - corners[0], v = corners[3] - corners[0];
  for (const glm::vec3& corner : corners) {
    mesh.positions.push_back(corner);
    mesh.normals.push_back(glm::normalize(glm::cross(u, v)));
    mesh.uvs.emplace_back(0);
    mesh.tangents.emplace_back(glm::normalize(u), 1);
  }
  for (std::uint32_t i : {0, 1, 2, 0, 2, 3}) mesh.indices.push_back(first + i);
}

// The walls, seen from inside: floor, ceiling, back, left, right. The room is open towards -z.
inline std::array<Wall, 5> walls() {
  const float x = kRoom.x / 2, y = kRoom.y, z = kRoom.z;
  std::array<Wall, 5> all;
  addRectangle(all[0].mesh, {{{x, 0, 0}, {-x, 0, 0}, {-x, 0, z}, {x, 0, z}}});
  addRectangle(all[1].mesh, {{{x, y, 0}, {x, y, z}, {-x, y, z}, {-x, y, 0}}});
  addRectangle(all[2].mesh, {{{x, 0, z}, {-x, 0, z}, {-x, y, z}, {x, y, z}}});
  addRectangle(all[3].mesh, {{{x, 0, 0}, {x, 0, z}, {x, y, z}, {x, y, 0}}});
  addRectangle(all[4].mesh, {{{-x, 0, z}, {-x, 0, 0}, {-x, y, 0}, {-x, y, z}}});
  for (Wall& wall : all) wall.color = kWhite;
  all[3].color = kRed;
  all[4].color = kGreen;
  return all;
}

// Adds an upright block.
//   base: corners of its bottom, x and z in published millimetres, counterclockwise from above
//   height: millimetres
inline void addBlock(gg::MeshData& mesh, const std::array<glm::vec2, 4>& base, float height) {
  const auto at = [&](std::size_t corner, float y) {
    return glm::vec3(base[corner].x, y, base[corner].y) / 100.0f -
           glm::vec3(kRoom.x / 2, 0, kRoom.z / 2);
  };
  addRectangle(mesh, {at(0, height), at(1, height), at(2, height), at(3, height)});
  addRectangle(mesh, {at(3, 0), at(2, 0), at(1, 0), at(0, 0)});
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    addRectangle(mesh, {at(i, 0), at(next, 0), at(next, height), at(i, height)});
  }
}

// The short and the tall block. The origin is the middle of the floor, as it is the foot of any
// other mesh that may stand there.
inline gg::MeshData blocks() {
  gg::MeshData mesh;
  addBlock(mesh, {{{130, 65}, {82, 225}, {240, 272}, {290, 114}}}, 165);
  addBlock(mesh, {{{423, 247}, {265, 296}, {314, 456}, {472, 406}}}, 330);
  return mesh;
}
