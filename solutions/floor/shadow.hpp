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
  // BEGIN SOLUTION(shadow.1)
  glBindTexture(GL_TEXTURE_2D, map.depth);
  glTexImage2D(GL_TEXTURE_2D, 0, format, size, size, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);

  glBindFramebuffer(GL_FRAMEBUFFER, map.framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, map.depth, 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("the shadow map's framebuffer object is not complete");
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  // END SOLUTION(shadow.1)
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
  // BEGIN SOLUTION(shadow.2)
  const glm::vec3 middle = (corners[0] + corners[7]) / 2.0f;
  // So near to the middle that no direction can be told (the squares of tiny numbers are 0, and
  // 0 / 0 is NaN), or that it means nothing: look down.
  const bool amid = glm::distance(light, middle) < 1e-3f * glm::distance(corners[0], corners[7]);
  const glm::vec3 along = amid ? glm::vec3(0, -1, 0) : glm::normalize(middle - light);
  const glm::vec3 up = std::abs(along.y) > 0.99f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
  camera.view = glm::lookAt(light, light + along, up);
  const float farthest = glm::distance(corners[0], corners[7]) + glm::distance(light, middle);
  const float nearest = 1e-3f * farthest; // a light among the objects sees nothing nearer
  float near = farthest, far = nearest, right = 1e-6f, top = 1e-6f; // the latter at distance 1
  for (const glm::vec3& corner : corners) {
    const glm::vec3 at = glm::vec3(camera.view * glm::vec4(corner, 1));
    const float distance = std::max(-at.z, nearest);
    near = std::min(near, 0.99f * distance); // what touches a plane, rounding may cut away
    far = std::max(far, distance);
    right = std::max(right, std::abs(at.x) / distance);
    top = std::max(top, std::abs(at.y) / distance);
  }
  right = std::min(right, 5.0f) * near; // 79 degrees to a side at most
  top = std::min(top, 5.0f) * near;
  camera.projection = glm::frustum(-right, right, -top, top, near, 1.01f * far);
  // END SOLUTION(shadow.2)
  return camera;
}

// TODO(shadow.3): draw the objects into the shadow map, and come back to the window.
//   Given:  `map`, and map.program to draw with; `camera`, the light's; draw(); `window`, the
//           window's size (pixels).
//   Goal:   these three functions leave in the map the depths of this frame and no other; what is
//           drawn after them covers all of the window.
//   Expect: the picture doesn't change yet.                             (shadow.md, step 3)
inline void beginShadowPass(const ShadowMap& map) {
  // BEGIN SOLUTION(shadow.3)
  glBindFramebuffer(GL_FRAMEBUFFER, map.framebuffer);
  glViewport(0, 0, map.size, map.size);
  glClear(GL_DEPTH_BUFFER_BIT);
  // END SOLUTION(shadow.3)
}

inline void drawDepths(const ShadowMap& map, const LightCamera& camera, const Draw& draw) {
  // BEGIN SOLUTION(shadow.3)
  map.program.use();
  draw(map.program, camera.projection, camera.view);
  // END SOLUTION(shadow.3)
}

inline void endShadowPass(const glm::ivec2& window) {
  // BEGIN SOLUTION(shadow.3)
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, window.x, window.y);
  // END SOLUTION(shadow.3)
}

// TODO(shadow.4): let the shaders ask the shadow map, through texture unit 1.
//   Given:  `depth`, its texture; 0 if this scene has no shadows.
//   Goal:   it is bound there, and unit 0 is the active one again. Then ask it in shadow.glsl.
//   Expect: see there.                                                  (shadow.md, step 4)
inline void bindShadowMap(GLuint depth) {
  // BEGIN SOLUTION(shadow.4)
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, depth);
  glActiveTexture(GL_TEXTURE0);
  // END SOLUTION(shadow.4)
}

// TODO(shadow.6): bonus: move the depths away from the light while they are drawn.
//   Given:  `bias`, the scene's shadow_bias: only if it is 2. The other biases are in shadow.glsl.
//   Goal:   between these two functions, by more where a triangle is steep; after them all is as
//           before.                                                     (shadow.md, step 6)
inline void beginOffset(int bias) {
  // BEGIN SOLUTION(shadow.6)
  if (bias == 2) {
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(2.5f, 4.0f);
  }
  // END SOLUTION(shadow.6)
}

inline void endOffset() {
  // BEGIN SOLUTION(shadow.6)
  glDisable(GL_POLYGON_OFFSET_FILL);
  // END SOLUTION(shadow.6)
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
