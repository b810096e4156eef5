// What is drawn: a ground, and on a turntable a mesh among boxes that touch it and each other.
#pragma once

#include <gg/gg.hpp>

struct Box {
  glm::vec3 foot; // where it stands, turntable space
  glm::vec3 size; // width, height, depth
  float turn;     // about its upright axis, radians
  glm::vec3 color;
};

inline constexpr std::array<Box, 6> kBoxes{{
    {{-0.95f, 0, -0.20f}, {0.70f, 1.10f, 0.70f}, 0.3f, {0.85f, 0.55f, 0.45f}},
    {{0.95f, 0, -0.35f}, {0.90f, 0.50f, 0.90f}, -0.2f, {0.55f, 0.70f, 0.85f}},
    {{0.90f, 0.50f, -0.30f}, {0.45f, 0.45f, 0.45f}, 0.5f, {0.90f, 0.85f, 0.60f}},
    {{0.55f, 0, 0.75f}, {0.50f, 0.30f, 0.50f}, 0.9f, {0.60f, 0.80f, 0.60f}},
    {{-0.40f, 0, 0.80f}, {0.30f, 0.60f, 0.30f}, -0.4f, {0.80f, 0.65f, 0.85f}},
    {{0.10f, 0, -0.95f}, {1.10f, 0.80f, 0.25f}, 0.1f, {0.75f, 0.75f, 0.75f}},
}};
inline constexpr glm::vec3 kMeshColor{0.9f, 0.8f, 0.7f};
inline constexpr float kMeshScale = 1.3f;

struct StillLife {
  gg::Mesh ground, mesh, box;
};

inline StillLife makeStillLife(const gg::Scene& scene) {
  const float size = scene.real("ground.size");
  return {gg::plane(size, size), gg::loadMesh(scene.text("mesh")), gg::box()};
}

// Draws all of it with `program`.
//   projection: clip from eye;  view: eye from world;  time: seconds
inline void drawStillLife(const gg::Program& program, const glm::mat4& projection,
                          const glm::mat4& view, const StillLife& life,
                          const gg::UniformBuffer<gg::Material>& material, const gg::Scene& scene,
                          double time) {
  program.use();
  program.set("uProjection", projection);
  program.set("uView", view);
  const auto draw = [&](const gg::Mesh& mesh, const glm::mat4& model, const char* name,
                        const glm::vec3& color) {
    gg::Material own = scene.material(name);
    own.ambient *= glm::vec4(color, 1);
    own.diffuse *= glm::vec4(color, 1);
    material.load(own);
    program.set("uModel", model);
    program.set("uNormal", gg::cofactor(view * model));
    mesh.draw();
  };
  draw(life.ground, glm::mat4(1), "ground", glm::vec3(1));

  const double period = scene.number("turntable.period");
  const auto angle = static_cast<float>(6.283185307179586 * std::fmod(time, period) / period);
  const glm::mat4 turntable = glm::rotate(glm::mat4(1), angle, {0, 1, 0}); // world from its space
  draw(life.mesh, glm::scale(turntable, glm::vec3(kMeshScale)), "object", kMeshColor);
  for (const Box& box : kBoxes) {
    const glm::mat4 placed = glm::rotate(glm::translate(turntable, box.foot), box.turn, {0, 1, 0});
    draw(life.box, glm::scale(placed, box.size), "object", box.color);
  }
}
