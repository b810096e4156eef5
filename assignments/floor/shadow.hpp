// The shadow map, the light's camera, the pass that draws depths, and whether a shadow can be seen.
#pragma once

#include <gg/gg.hpp>

#include <functional>

// Draws all objects: draw(program, projection, view).
//   projection: clip from eye;  view: eye from world
using Draw = std::function<void(const gg::Program& program, const glm::mat4& projection,
                                const glm::mat4& view)>;

// The shadow map: depths as the light sees them.
struct ShadowMap {
  gg::Program program{{"object.vert", "shadow.frag"}};
  gg::Texture depth;
  gg::Framebuffer framebuffer;
  GLsizei size = 0; // pixels, width and height
};

// TODO(shadow.1): make the shadow map.
//   Given:  `size` (pixels), `format` (GL_DEPTH_COMPONENT24 or the like) and the names in `map`.
//   Goal:   `framebuffer` is complete, with `depth` alone, which compares when it is sampled; if it
//           isn't, std::runtime_error is thrown. Afterwards the window is bound.
//   Expect: the picture doesn't change yet.                             (shadow.md, step 1)
inline void makeShadowMap(ShadowMap& map, GLsizei size, GLenum format) {
  map.size = size;
}

// How the light sees the world.
struct LightCamera {
  glm::mat4 projection{1}; // the light's clip space from its eye space
  glm::mat4 view{1};       // the light's eye space from world
};

// TODO(shadow.2): a camera at the light that sees all objects.
//   Given:  `light`, the light's position, and `corners`, the corners of a box around the objects
//           (corner 0 is opposite to corner 7); both in world space.
//   Goal:   it looks from the light to the box's middle, and its field of view, near and far planes
//           just enclose the corners.
//   Expect: the picture doesn't change yet.                             (shadow.md, step 2)
inline LightCamera lightCamera(const glm::vec3& light, const std::array<glm::vec3, 8>& corners) {
  LightCamera camera;
  return camera;
}

// TODO(shadow.3): draw the objects into the shadow map, and come back to the window.
//   Given:  `map`, and map.program to draw with; `camera`, the light's; draw(); `window`, the
//           window's size (pixels).
//   Goal:   these three functions leave in the map the depths of this frame and no other; what is
//           drawn after them covers all of the window.
//   Expect: the picture doesn't change yet.                             (shadow.md, step 3)
inline void beginShadowPass(const ShadowMap& map) {
}

inline void drawDepths(const ShadowMap& map, const LightCamera& camera, const Draw& draw) {
}

inline void endShadowPass(const glm::ivec2& window) {
}

// TODO(shadow.4): let the shaders ask the shadow map, through texture unit 1.
//   Given:  `depth`, its texture; 0 if this scene has no shadows.
//   Goal:   it is bound there, and unit 0 is the active one again. Then ask it in shadow.glsl.
//   Expect: see there.                                                  (shadow.md, step 4)
inline void bindShadowMap(GLuint depth) {
}

// TODO(shadow.6): bonus: move the depths away from the light while they are drawn.
//   Given:  `bias`, the scene's shadow_bias: only if it is 2. The other biases are in shadow.glsl.
//   Goal:   between these two functions, by more where a triangle is steep; after them all is as
//           before.                                                     (shadow.md, step 6)
inline void beginOffset(int bias) {
}

inline void endOffset() {
}

// The pass "shadow": the objects' depths as the light sees them, into the shadow map. It is made of
// TODO(shadow.3) and TODO(shadow.6).
//   window: its size, pixels;  bias: the scene's shadow_bias
inline void shadowPass(const ShadowMap& map, const LightCamera& camera, const glm::ivec2& window,
                       int bias, const Draw& draw) {
  beginShadowPass(map);
  beginOffset(bias);
  drawDepths(map, camera, draw);
  endOffset();
  endShadowPass(window);
}

// Tells a program what it needs to ask the shadow map (shadow.glsl).
inline void setShadow(const gg::Program& program, const gg::Scene& scene, bool shadow,
                      const LightCamera& camera) {
  program.set("uShadow", shadow);
  program.set("uLightClipFromWorld", camera.projection * camera.view);
  program.set("uLightWorld", glm::vec3(scene.light.position));
  program.set("uShadowBias", scene.integer("quality.shadow_bias"));
  program.set("uPcfRadius", scene.integer("quality.pcf_radius"));
  program.set("uShadowTexel", 2 / (std::min(camera.projection[0][0], camera.projection[1][1]) *
                                   static_cast<float>(scene.integer("quality.shadow_size"))));
  program.set("uShadowMap", 1); // texture unit
}

// Can this scene show a shadow? Not if the effect is off, there are no objects, or the light has
// nothing that a shadow could take away.
inline bool showsShadow(const gg::Scene& scene) {
  if (!scene.flag("effects.shadow")) return false;
  if (scene.flag("debug.draw_all_passes")) return true;
  const bool lit = glm::vec3(scene.light.diffuse) != glm::vec3(0) ||
                   glm::vec3(scene.light.specular) != glm::vec3(0);
  return lit && scene.integer("ring.count") > 0;
}

// What depths are stored in: quality.shadow_bits.
inline GLenum depthFormat(const gg::Scene& scene) {
  const int bits = scene.integer("quality.shadow_bits");
  return bits > 24   ? GL_DEPTH_COMPONENT32F
         : bits > 16 ? GL_DEPTH_COMPONENT24
                     : GL_DEPTH_COMPONENT16;
}
