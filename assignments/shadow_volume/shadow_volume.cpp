// shadow_volume: what stands in the Cornell box throws hard shadows, found by counting.
//
// The passes of one frame, all into the window:
//   ambient   everything, in the light that comes from all sides   -> colour and depth
//   volume    the shadow volume: nothing is seen, it is counted    -> stencil
//   light     everything again: adds the lamp's light, but not to what lies in a volume

#include "cornell.hpp"
#include "counting.hpp"

#include <gg/gg.hpp>
#include <gg/platform.hpp>
#include <gg/text_file.hpp>

#include <optional>

namespace {

// What is drawn: the walls and what stands between them, the caster.
struct World {
  std::vector<std::pair<gg::Mesh, glm::vec3>> walls; // with their colours; room space
  gg::Mesh caster;
  glm::mat4 room;   // world from room space
  glm::mat4 placed; // world from the caster's model space
};

// The mesh that the scene names.
gg::MeshData casterMesh(const gg::Scene& scene) {
  const std::string& name = scene.text("mesh");
  if (name == "none") return {};
  if (name == "blocks") return blocks();
  return gg::loadMeshData(name, gg::toUtf8(gg::programFolder()));
}

// World from the model space of the caster, whose foot is in the origin there.
glm::mat4 placeCaster(const gg::Scene& scene, const glm::mat4& room, const gg::Mesh& mesh) {
  const glm::vec3 size = mesh.highest() - mesh.lowest();
  // As high as the tall block or, if it is wide, so wide that the room holds it.
  const float fit =
      std::min(3.3f / std::max(size.y, 0.1f), 3.6f / std::max({size.x, size.z, 0.1f}));
  glm::mat4 placed = glm::translate(room, kMiddle + glm::vec3(0, scene.real("caster.lift"), 0));
  placed = glm::rotate(placed, scene.real("caster.turn"), {0, 1, 0});
  return scene.text("mesh") == "blocks" ? placed : glm::scale(placed, glm::vec3(fit));
}

World makeWorld(const gg::Scene& scene, const gg::MeshData& caster) {
  World world{{}, caster, glm::scale(glm::mat4(1), glm::vec3(scene.real("room.scale"))), {}};
  for (const Wall& wall : walls()) world.walls.emplace_back(wall.mesh, wall.color);
  world.placed = placeCaster(scene, world.room, world.caster);
  return world;
}

// Where the lamp is: it circles slowly about the light's position, in the horizontal plane.
//   time: seconds;  returns world space
glm::vec3 lampAt(const gg::Scene& scene, double time) {
  const double period = scene.number("orbit.period");
  const auto angle = static_cast<float>(6.283185307 * std::fmod(time, period) / period);
  return glm::vec3(scene.light.position) +
         scene.real("orbit.radius") * glm::vec3(std::cos(angle), 0, std::sin(angle));
}

// Draws walls and caster with `program`.
//   projection: clip from eye;  view: eye from world
void drawWorld(const gg::Program& program, const glm::mat4& projection, const glm::mat4& view,
               const World& world, const gg::UniformBuffer<gg::Material>& material,
               const gg::Scene& scene) {
  const auto draw = [&](const gg::Mesh& mesh, const glm::mat4& model, const char* name,
                        const glm::vec3& color) {
    gg::Material own = scene.material(name);
    own.ambient *= glm::vec4(color, 1);
    own.diffuse *= glm::vec4(color, 1);
    material.load(own);
    program.set("uProjection", projection);
    program.set("uView", view);
    program.set("uModel", model);
    program.set("uNormal", gg::cofactor(view * model));
    mesh.draw();
  };
  program.use();
  for (const auto& [mesh, color] : world.walls) draw(mesh, world.room, "wall", color);
  draw(world.caster, world.placed, "caster", kWhite);
}

} // namespace

void app(const gg::Scene& scene) {
  gg::Window window("shadow_volume", scene.size);
  requireStencil();

  const gg::Program objectProgram({"object.vert", "object.frag"});
  const gg::Program volumeProgram({"volume.vert", "volume.frag"});
  const gg::UniformBuffer<gg::Light> light(gg::kLightBinding);
  const gg::UniformBuffer<gg::Material> material(gg::kMaterialBinding);

  gg::MeshData mesh = casterMesh(scene);
  std::vector<std::string> warnings;
  ClosedMesh caster = closedMesh(mesh, warnings);
  if (scene.integer("quality.search") == 1) caster.edges = sharedEdges(caster.faces);
  for (const std::string& warning : warnings)
    std::fprintf(stderr, "mesh %s: %s\n", scene.text("mesh").c_str(), warning.c_str());
  const World world = makeWorld(scene, mesh);

  // What a scene can't show isn't made.
  const bool silhouettes = scene.integer("quality.edges") == 1;
  std::vector<ClosedMesh> parts; // one, but for hundreds of things over each other
  if (showsShadow(scene, caster)) parts = countableParts(caster);
  std::vector<VolumeBuffer> volumes(parts.size());
  std::optional<CountMemory> memory;
  if (parts.size() > 1) memory.emplace();
  if (!silhouettes)
    for (std::size_t i = 0; i < parts.size(); ++i) volumes[i].load(shadowVolume(parts[i]));
  std::optional<glm::vec3> loadedFor; // the light that the silhouettes in `volumes` belong to

  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glClearColor(scene.background.r, scene.background.g, scene.background.b, 1);

  while (window) {
    const glm::mat4 projection = scene.camera.projection(window.aspect()); // clip from eye
    const glm::mat4 view = scene.camera.view();                            // eye from world
    const glm::vec3 lamp = lampAt(scene, glfwGetTime());
    gg::Light lit = scene.light;
    lit.position = glm::vec4(lamp, 1);
    light.load(lit.in(view));
    // TODO(shadow_volume.2): the volume is worked out in the caster's own space: where is the lamp
    //   there? Given: `lamp`, in world space, and world.placed, world from the caster's space. Then
    //   the shader, volume.vert.
    glm::vec3 lampModel(0);

    if (silhouettes && loadedFor != lampModel) {
      for (std::size_t i = 0; i < parts.size(); ++i)
        volumes[i].load(silhouetteVolume(parts[i], lampModel));
      loadedFor = lampModel;
    }
    volumeProgram.set("uProjection", projection);
    volumeProgram.set("uView", view);
    volumeProgram.set("uModel", world.placed);
    volumeProgram.set("uLight", lampModel);

    // Pass "ambient": sets every pixel's colour and depth.
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    objectProgram.set("uAmbient", true);
    objectProgram.set("uDirect", false);
    drawWorld(objectProgram, projection, view, world, material, scene);

    // Pass "volume": counts, in the stencil buffer.
    volumePass(volumes, memory, volumeProgram, scene);

    // Pass "light": the same surfaces again, so the same depths; what they reflect is added.
    glDepthFunc(GL_EQUAL);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    if (!volumes.empty()) beginLight();
    objectProgram.set("uAmbient", false);
    objectProgram.set("uDirect", true);
    drawWorld(objectProgram, projection, view, world, material, scene);
    if (!volumes.empty()) endLight();
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);

    // To look at: the volumes in white and orange, as long as V is held down.
    if (scene.flag("debug.volume") || glfwGetKey(window.handle(), GLFW_KEY_V) == GLFW_PRESS) {
      glDepthFunc(GL_LEQUAL);
      glDisable(GL_CULL_FACE);
      volumeProgram.use();
      for (const VolumeBuffer& volume : volumes) volume.draw();
      glEnable(GL_CULL_FACE);
      glDepthFunc(GL_LESS);
    }

    window.swapBuffers();
  }
}
