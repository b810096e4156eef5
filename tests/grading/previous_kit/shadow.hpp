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
//   Do:     a view (glm::lookAt) from the light to the box's middle, and a projection whose field
//           of view, near and far planes just enclose the corners in that view.
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
