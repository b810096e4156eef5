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

// The object's own colour: six that can be told apart.
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
    const glm::mat4 projection = scene.camera.projection(window.aspect()); // clip from eye
    const glm::mat4 view = scene.camera.view();                            // eye from world
    const bool mirror = showsReflection(scene, projection * view);
    const bool glows = bloom && showsBloom(scene);

    // Pass "shadow": the objects' depths as the light sees them, into the shadow map.
    LightCamera camera;
    if (shadowMap) {
      if (shadowMap->size == 0)
        makeShadowMap(*shadowMap, scene.integer("quality.shadow_size"), depthFormat(scene));
      camera = lightCamera(glm::vec3(scene.light.position), objectsBox(scene, object));

      // TODO(shadow.3): draw the objects into the shadow map.
      //   Given:  `shadowMap`, `camera`, drawObjects(), and shadowMap->program to draw with.
      //   Do:     bind its framebuffer, set the viewport to its size, clear the depth, draw the
      //           objects with the light's projection and view; then the window and its viewport.
      //   Expect: the picture doesn't change yet.                     (shadow.md, step 3)
      // BEGIN SOLUTION(shadow.3)
      glBindFramebuffer(GL_FRAMEBUFFER, shadowMap->framebuffer);
      glViewport(0, 0, shadowMap->size, shadowMap->size);
      glClear(GL_DEPTH_BUFFER_BIT);
      // END SOLUTION(shadow.3)
      // BEGIN SOLUTION(shadow.6)
      if (scene.integer("quality.shadow_bias") == 2) {
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(2.5f, 4.0f);
      }
      // END SOLUTION(shadow.6)
      // BEGIN SOLUTION(shadow.3)
      shadowMap->program.use();
      drawObjects(shadowMap->program, camera.projection, camera.view, object, material, scene,
                  time);
      // END SOLUTION(shadow.3)
      // BEGIN SOLUTION(shadow.6)
      glDisable(GL_POLYGON_OFFSET_FILL);
      // END SOLUTION(shadow.6)
      // BEGIN SOLUTION(shadow.3)
      glBindFramebuffer(GL_FRAMEBUFFER, 0);
      glViewport(0, 0, window.width(), window.height());
      // END SOLUTION(shadow.3)
    }

    // What the shaders need to ask the shadow map (shadow.glsl).
    for (const gg::Program* program : {&objectProgram, &mirrorProgram, &tileProgram}) {
      program->set("uShadow", shadowMap.has_value());
      program->set("uLightClipFromWorld", camera.projection * camera.view);
      program->set("uLightWorld", glm::vec3(scene.light.position));
      program->set("uShadowBias", scene.integer("quality.shadow_bias"));
      program->set("uPcfRadius", scene.integer("quality.pcf_radius"));
      program->set("uShadowTexel", 2 / (std::min(camera.projection[0][0], camera.projection[1][1]) *
                                        static_cast<float>(scene.integer("quality.shadow_size"))));
      program->set("uShadowMap", 1); // texture unit
    }
    // TODO(shadow.4): bind the shadow map's depth texture to unit 1 (then unit 0 again), and
    //   ask it in shadow.glsl.
    // BEGIN SOLUTION(shadow.4)
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, shadowMap ? shadowMap->depth : 0);
    glActiveTexture(GL_TEXTURE0);
    // END SOLUTION(shadow.4)

    // Pass "mirror": the objects as the floor sees them, into the framebuffer object.
    if (mirror) {
      if (reflection.size == 0)
        makeReflection(reflection, scene.integer("quality.mirror_size"),
                       bloom ? lightFormat(scene) : GL_RGBA8);

      // TODO(mirror.2): draw into the framebuffer object instead of the window.
      //   Given:  `reflection`.
      //   Do:     bind its framebuffer, set the viewport to its size, clear colour and depth.
      //           Below, at the end of the pass: bind the window (0), set its viewport again.
      //   Expect: the picture still doesn't change.                   (mirror.md, step 2)
      // BEGIN SOLUTION(mirror.2)
      glBindFramebuffer(GL_FRAMEBUFFER, reflection.framebuffer);
      glViewport(0, 0, reflection.size, reflection.size);
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      // END SOLUTION(mirror.2)

      // TODO(mirror.5): a mirror turns every triangle round: cull the front faces here, the back
      //   faces again below, and negate the normal in mirror.vert.
      //   Expect: solid objects in the floor, lit like the real ones. (mirror.md, step 5)
      // BEGIN SOLUTION(mirror.5)
      glCullFace(GL_FRONT);
      // END SOLUTION(mirror.5)

      // TODO(mirror.6): clip away what lies below the floor: enable GL_CLIP_DISTANCE0 here,
      //   disable it below, and write gl_ClipDistance[0] in mirror.vert.
      //   Expect: sunken objects no longer stick out of the floor.    (mirror.md, step 6)
      // BEGIN SOLUTION(mirror.6)
      const bool clip = scene.integer("quality.mirror_clip") > 0;
      mirrorProgram.set("uClip", clip);
      if (clip) glEnable(GL_CLIP_DISTANCE0);
      // END SOLUTION(mirror.6)

      // TODO(mirror.4): draw the objects mirrored at the plane y = 0.
      //   Given:  `projection`, `view`, drawObjects(), `mirrorProgram`, `light`.
      //   Do:     the mirrored view is the view times a scale of (1, -1, 1); load the light in the
      //           space of that view (scene.light.in(...)); draw with `mirrorProgram`.
      //   Expect: coloured shapes appear in the floor, inside out.    (mirror.md, step 4)
      // BEGIN SOLUTION(mirror.4)
      const glm::mat4 mirroredView = view * glm::scale(glm::mat4(1), glm::vec3(1, -1, 1));
      light.load(scene.light.in(mirroredView));
      mirrorProgram.use();
      drawObjects(mirrorProgram, projection, mirroredView, object, material, scene, time);
      // END SOLUTION(mirror.4)

      // TODO(mirror.6) and TODO(mirror.5) end here, then TODO(mirror.2).
      // BEGIN SOLUTION(mirror.6)
      glDisable(GL_CLIP_DISTANCE0);
      // END SOLUTION(mirror.6)
      // BEGIN SOLUTION(mirror.5)
      glCullFace(GL_BACK);
      // END SOLUTION(mirror.5)
      // BEGIN SOLUTION(mirror.2)
      glBindFramebuffer(GL_FRAMEBUFFER, 0);
      glViewport(0, 0, window.width(), window.height());
      // END SOLUTION(mirror.2)
    }

    // With bloom the scene goes into a framebuffer object of its own, not into the window.
    if (bloom) {
      const glm::ivec2 size(window.width(), window.height());
      if (bloom->size != size) {
        makeScene(*bloom, size, lightFormat(scene));
        if (glows)
          makeLevels(*bloom, scene.integer("quality.bloom_levels"), lightFormat(scene),
                     scene.integer("quality.bloom_edge") == 0 ? GL_CLAMP_TO_EDGE
                                                              : GL_MIRRORED_REPEAT);
      }
      // TODO(bloom.2): bind the scene's framebuffer (its size is the window's: so is the viewport).
      //   Then the composite pass in bloom.hpp.                       (bloom.md, step 2)
      // BEGIN SOLUTION(bloom.2)
      glBindFramebuffer(GL_FRAMEBUFFER, bloom->framebuffer);
      // END SOLUTION(bloom.2)
    }

    // Pass "objects".
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    light.load(scene.light.in(view));
    objectProgram.use();
    drawObjects(objectProgram, projection, view, object, material, scene, time);

    // Pass "floor".
    tileProgram.use();
    tileProgram.set("uProjection", projection);
    tileProgram.set("uView", view);
    tileProgram.set("uTilesPerUnit", scene.real("floor.tiles_per_unit"));
    tileProgram.set("uViewport", glm::vec2(window.width(), window.height()));
    tileProgram.set("uMirror", mirror);
    tileProgram.set("uBlurSigma", scene.real("mirror.blur"));
    tileProgram.set("uBlurSamples", scene.integer("quality.blur_samples"));
    tileProgram.set("uReflection", 0); // texture unit
    // TODO(mirror.3): let the floor sample the reflection: bind its colour texture to unit 0 here,
    //   and read it in tile.frag.
    //   Expect: the floor takes on the tint of the background.        (mirror.md, step 3)
    // BEGIN SOLUTION(mirror.3)
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, reflection.color);
    // END SOLUTION(mirror.3)
    material.load(scene.material("floor"));
    rectangle.draw();

    // Passes "bright", "down", "up" and "composite".
    if (bloom) {
      const int filter = scene.integer("quality.bloom_filter");
      glDisable(GL_DEPTH_TEST);
      glActiveTexture(GL_TEXTURE0);
      if (glows) {
        glBindSampler(0, bloom->sampler);
        brightPass(*bloom, scene.real("bloom.threshold"));
        downPasses(*bloom, filter);
        upPasses(*bloom, filter);
        glBindSampler(0, 0);
      }
      compositePass(*bloom, {window.width(), window.height()}, glows, filter);
      glEnable(GL_DEPTH_TEST);
    }

    window.swapBuffers();
  }
}
