// What is drawn: a ground, and on it a turning ring of objects.
#pragma once

#include <gg/gg.hpp>

// Materials, by the number that identifies them in the G-buffer; 0 is where nothing is.
inline constexpr std::array kMaterials{"ground", "matt", "gloss", "metal"};

struct Objects {
  gg::Mesh ground;
  std::array<gg::Mesh, 3> shapes; // the scene's mesh, a sphere, a box
};

// A sphere that stands on y = 0, 1 high. The normals are those of the true sphere.
inline gg::MeshData sphere() {
  constexpr std::uint32_t kColumns = 48, kRows = 24;
  gg::MeshData mesh;
  for (std::uint32_t row = 0; row <= kRows; ++row)
    for (std::uint32_t column = 0; column <= kColumns; ++column) {
      const glm::vec2 uv(column / float(kColumns), row / float(kRows));
      const float turn = 6.2831853f * uv.x, down = 3.1415927f * (1 - uv.y);
      const glm::vec3 normal(std::sin(down) * std::sin(turn), std::cos(down),
                             std::sin(down) * std::cos(turn));
      mesh.positions.push_back(0.5f * normal + glm::vec3(0, 0.5f, 0));
      mesh.normals.push_back(normal);
      mesh.uvs.push_back(uv);
    }
  for (std::uint32_t row = 0; row < kRows; ++row)
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const std::uint32_t a = row * (kColumns + 1) + column, b = a + kColumns + 1;
      for (const std::uint32_t corner : {a, a + 1, b + 1, a, b + 1, b})
        mesh.indices.push_back(corner);
    }
  gg::computeTangents(mesh);
  return mesh;
}

inline Objects makeObjects(const gg::Scene& scene) {
  const float size = scene.real("ground.size");
  return {gg::plane(size, size), {gg::loadMesh(scene.text("mesh")), sphere(), gg::box()}};
}

// Object i of the ring, counted from 0. Nine in a row have every shape in every material.
inline std::size_t shapeOf(int i) {
  return static_cast<std::size_t>(i % 3);
}
inline const char* materialOf(int i) {
  return kMaterials[std::size_t(1 + (i + i / 3) % 3)];
}

// The object's own colour: eight that can be told apart. The material's is multiplied by it.
inline glm::vec3 colorOf(int i) {
  const int k = i + 1;
  return {(k & 1) * 0.4f + 0.4f, (k & 2) * 0.2f + 0.4f, (k & 4) * 0.1f + 0.4f};
}

// Is there anything of a material that `is` true of?
//   is: takes a gg::Material
template <class Predicate> bool anyMaterial(const gg::Scene& scene, Predicate is) {
  if (scene.flag("debug.draw_all_passes") || is(scene.material("ground"))) return true;
  for (int i = 0; i < std::min(scene.integer("ring.count"), 3); ++i)
    if (is(scene.material(materialOf(i)))) return true;
  return false;
}

// Draws ground and ring with `program`.
//   projection: clip from eye;  view: eye from world;  time: seconds
inline void drawObjects(const gg::Program& program, const glm::mat4& projection,
                        const glm::mat4& view, const Objects& objects,
                        const gg::UniformBuffer<gg::Material>& material, const gg::Scene& scene,
                        double time) {
  program.use();
  program.set("uProjection", projection);
  program.set("uView", view);
  const auto draw = [&](const gg::Mesh& mesh, const glm::mat4& model, const std::string& name,
                        const glm::vec3& color, int id) {
    gg::Material own = scene.material(name);
    own.ambient *= glm::vec4(color, 1);
    own.diffuse *= glm::vec4(color, 1);
    material.load(own);
    program.set("uModel", model);
    program.set("uNormal", gg::cofactor(model));
    program.set("uObjectId", id);
    const auto* const found = std::find(kMaterials.begin(), kMaterials.end(), name);
    program.set("uMaterialId", 1 + static_cast<int>(found - kMaterials.begin()));
    mesh.draw();
  };
  draw(objects.ground, glm::mat4(1), "ground", glm::vec3(1), 1);

  const int count = scene.integer("ring.count");
  const double period = scene.number("ring.period");
  const double turns = std::fmod(time, period) / period; // 0 to 1
  for (int i = 0; i < count; ++i) {
    const auto angle = static_cast<float>(6.283185307179586 * (double(i) / count + turns));
    glm::mat4 model = glm::rotate(glm::mat4(1), angle, {0, 1, 0});
    model = glm::translate(model, {0, 0, scene.real("ring.radius")});
    model = glm::scale(model, glm::vec3(scene.real("ring.scale")));
    draw(objects.shapes[shapeOf(i)], model, materialOf(i), colorOf(i), 2 + i);
  }
}
