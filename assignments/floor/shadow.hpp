// The shadow map, the light's camera, and whether a shadow can be seen.
#pragma once

#include <gg/gg.hpp>

// The shadow map: depths as the light sees them.
struct ShadowMap {
  gg::Program program{{"object.vert", "shadow.frag"}};
  gg::Texture depth;
  gg::Framebuffer framebuffer;
  GLsizei size = 0; // pixels, width and height
};

// TODO(shadow.1): make the shadow map.
//   Given:  `size` (pixels), `format` (GL_DEPTH_COMPONENT24 or the like) and the names in `map`.
//   Do:     storage for `depth` (linear filter, clamp to edge, GL_TEXTURE_COMPARE_MODE
//           GL_COMPARE_REF_TO_TEXTURE, GL_TEXTURE_COMPARE_FUNC GL_LEQUAL); attach it; no colours:
//           draw buffer and read buffer GL_NONE; throw unless complete; bind the window again.
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
//   Do:     a view (glm::lookAt) from the light to the box's middle, and a projection whose field
//           of view, near and far planes just enclose the corners in that view.
//   Expect: the picture doesn't change yet.                             (shadow.md, step 2)
inline LightCamera lightCamera(const glm::vec3& light, const std::array<glm::vec3, 8>& corners) {
  LightCamera camera;
  return camera;
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
