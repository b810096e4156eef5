// floor: objects hop in a ring over a chequered floor. The floor reflects them, they throw shadows,
// and what glows is surrounded by its light.
//
// The passes of one frame, each drawn only if the scene can show it:
//   shadow     the objects' depths, seen from the light   -> a depth texture
//   mirror     the objects, as the floor sees them        -> a framebuffer object
//   objects    the objects themselves                     -> the window; with bloom, the scene's
//   floor      the floor, adding the reflection              framebuffer object
//   bright     the scene's bright parts                   -> bloom level 0, half as large
//   down       each level from the next larger one        -> bloom levels 1, 2, ...
//   up         each level adds the next smaller one       -> bloom levels ..., 1, 0
//   composite  the scene and bloom level 0                -> the window
//
// shadow.hpp, mirror.hpp and bloom.hpp hold the passes of a part each, and all that you write in
// C++.

#include "bloom.hpp"
#include "mirror.hpp"
#include "shadow.hpp"

#include <gg/gg.hpp>

#include <optional>

namespace {

constexpr float kPi = 3.14159265f;

// Corners of a box around all objects, wherever they hop; world space.
std::array<glm::vec3, 8> objectsBox(const gg::Scene& scene, const gg::Mesh& mesh) {
  const float scale = scene.real("ring.scale");
  const glm::vec3 size = glm::max(glm::abs(mesh.lowest()), glm::abs(mesh.highest())) * scale;
  const float reach = scene.real("ring.radius") + glm::length(glm::vec2(size.x, size.z));
  const float low = scene.real("ring.base") + mesh.lowest().y * scale;
  const float high = scene.real("ring.base") + scene.real("ring.hop") + mesh.highest().y * scale;
  std::array<glm::vec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = {i & 1 ? reach : -reach, i & 2 ? high : low, i & 4 ? reach : -reach};
  return corners;
}

// The object's own colour: eight that can be told apart.
glm::vec3 objectColor(int i) {
  return {(i & 1) * 0.4f + 0.4f, (i & 2) * 0.2f + 0.4f, (i & 4) * 0.1f + 0.4f};
}

// Draws the ring of hopping objects with `program`; every other one glows.
//   projection: clip from eye;  view: eye from world;  time: seconds
void drawObjects(const gg::Program& program, const glm::mat4& projection, const glm::mat4& view,
                 const gg::Mesh& mesh, const gg::UniformBuffer<gg::Material>& material,
                 const gg::Scene& scene, double time) {
  const int count = scene.integer("ring.count");
  const double cycle = scene.number("ring.cycle");
  const float t = static_cast<float>(std::fmod(time, cycle) / cycle); // 0 to 1, once a cycle
  const float h = std::fmod(36.0f * t, 2.0f) - 1.0f;
  const float height = scene.real("ring.base") + scene.real("ring.hop") * (1.0f - h * h);
  for (int i = 1; i <= count; ++i) {
    const float angle = kPi * (2.0f * i / count - 4.0f * t);
    glm::mat4 model = glm::rotate(glm::mat4(1), angle, {0, 1, 0});
    model = glm::translate(model, {0, height, scene.real("ring.radius")});
    model = glm::scale(model, glm::vec3(scene.real("ring.scale")));

    gg::Material own = scene.material("object");
    own.ambient *= glm::vec4(objectColor(i), 1);
    own.diffuse *= glm::vec4(objectColor(i), 1);
    material.load(own);

    program.set("uProjection", projection);
    program.set("uView", view);
    program.set("uModel", model);
    program.set("uNormal", gg::cofactor(view * model));
    // Squared: a deeper hue, which stays visible in what shines white.
    program.set("uGlow", i % 2 == 0 ? glm::vec3(0)
                                    : scene.real("ring.glow") * objectColor(i) * objectColor(i));
    mesh.draw();
  }
}

} // namespace

void app(const gg::Scene& scene) {
  gg::Window window("floor", scene.size);

  const gg::Program objectProgram({"object.vert", "object.frag"});
  const gg::Program mirrorProgram({"mirror.vert", "object.frag"});
  const gg::Program tileProgram({"tile.vert", "tile.frag"});

  const gg::Mesh object = gg::loadMesh(scene.text("mesh"));
  const gg::Mesh rectangle = gg::plane(scene.real("floor.width"), scene.real("floor.depth"));
  const gg::UniformBuffer<gg::Light> light(gg::kLightBinding);
  const gg::UniformBuffer<gg::Material> material(gg::kMaterialBinding);
  Reflection reflection;
  // What a scene can't show isn't made.
  std::optional<ShadowMap> shadowMap;
  std::optional<Bloom> bloom;
  if (showsShadow(scene)) shadowMap.emplace();
  if (scene.flag("effects.bloom")) bloom.emplace();

  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glClearColor(scene.background.r, scene.background.g, scene.background.b, 1);

  while (window) {
    const double time = glfwGetTime();
    const glm::ivec2 size(window.width(), window.height());                // pixels
    const glm::mat4 projection = scene.camera.projection(window.aspect()); // clip from eye
    const glm::mat4 view = scene.camera.view();                            // eye from world
    const bool mirror = showsReflection(scene, projection * view);
    const bool glows = bloom && showsBloom(scene);
    const Draw draw = [&](const gg::Program& program, const glm::mat4& clipFromEye,
                          const glm::mat4& eyeFromWorld) {
      drawObjects(program, clipFromEye, eyeFromWorld, object, material, scene, time);
    };

    LightCamera camera;
    if (shadowMap) {
      if (shadowMap->size == 0)
        makeShadowMap(*shadowMap, scene.integer("quality.shadow_size"), depthFormat(scene));
      camera = lightCamera(glm::vec3(scene.light.position), objectsBox(scene, object));
      shadowPass(*shadowMap, camera, size, scene.integer("quality.shadow_bias"), draw);
    }
    for (const gg::Program* program : {&objectProgram, &mirrorProgram, &tileProgram})
      setShadow(*program, scene, shadowMap.has_value(), camera);
    bindShadowMap(shadowMap ? shadowMap->depth : 0);

    if (mirror) {
      if (reflection.size == 0)
        makeReflection(reflection, scene.integer("quality.mirror_size"),
                       bloom ? lightFormat(scene) : GL_RGBA8);
      mirrorPass(reflection, size, mirrorProgram, projection, view, light, scene, draw);
    }

    // With bloom the scene goes into a framebuffer object of its own, not into the window.
    if (bloom) {
      if (bloom->size != size) makeBloom(*bloom, size, scene, glows);
      beginScene(*bloom);
    }

    // Pass "objects".
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    light.load(scene.light.in(view));
    objectProgram.use();
    draw(objectProgram, projection, view);

    // Pass "floor".
    tileProgram.use();
    tileProgram.set("uProjection", projection);
    tileProgram.set("uView", view);
    tileProgram.set("uTilesPerUnit", scene.real("floor.tiles_per_unit"));
    tileProgram.set("uViewport", glm::vec2(size));
    tileProgram.set("uMirror", mirror);
    tileProgram.set("uBlurSigma", scene.real("mirror.blur"));
    tileProgram.set("uBlurSamples", scene.integer("quality.blur_samples"));
    tileProgram.set("uReflection", 0); // texture unit
    sampleReflection(reflection);
    material.load(scene.material("floor"));
    rectangle.draw();

    if (bloom) bloomPasses(*bloom, size, scene, glows);

    window.swapBuffers();
  }
}
