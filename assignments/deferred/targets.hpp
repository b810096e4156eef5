// Multiple render targets: the three kinds of light that leave the surfaces, drawn at once into
// three textures and added afterwards. The functions stand in the order in which they are called.
#pragma once

#include "objects.hpp"

// The kinds of light: the number of its attachment, and its place in the arrays below.
enum Kind { kDiffuse, kSpecular, kAmbient };

struct Targets {
  gg::Program light{{"object.vert", "light.frag"}};
  gg::Program compose{{"screen.vert", "compose.frag"}};
  gg::VertexArray noVertices; // screen.vert makes its own corners

  std::array<bool, 3> needed{}; // of which kinds does this scene have any?
  std::array<gg::Texture, 3> color;
  gg::Renderbuffer depth;
  gg::Framebuffer framebuffer;
  glm::ivec2 size{0}; // pixels
};

// Only what the scene can show: without a material that shines there is no specular light to keep.
inline std::array<bool, 3> neededKinds(const gg::Scene& scene) {
  const auto any = [&](const glm::vec4& light, glm::vec4 gg::Material::*part) {
    return anyMaterial(scene, [&](const gg::Material& material) {
      return glm::vec3(light) * glm::vec3(material.*part) != glm::vec3(0);
    });
  };
  // The diffuse target holds the background, too.
  return {true, any(scene.light.specular, &gg::Material::specular),
          any(scene.light.ambient, &gg::Material::ambient)};
}

// What light is stored in: quality.format.
inline GLenum lightFormat(const gg::Scene& scene) {
  constexpr GLenum formats[] = {GL_RGBA8, GL_RGBA16F, GL_RGBA32F};
  return formats[scene.integer("quality.format")];
}

// TODO(targets.1): make the framebuffer object with its three textures.
//   Given:  `size` (of the window, pixels), `format`, and the names in `targets`: color (three
//           textures), needed (which of them), depth, framebuffer.
//   Do:     for each texture that is needed: storage of this size and format; nearest filter, no
//           mipmaps, clamped at the edges; attach it to GL_COLOR_ATTACHMENT0 + its number. Tell
//           glDrawBuffers which attachment each of the shader's three outputs goes to, or GL_NONE.
//           A renderbuffer for the depth. Throw unless it is complete; bind the window again.
//   Expect: the picture doesn't change yet.                           (targets.md, step 1)
inline void makeTargets(Targets& targets, const glm::ivec2& size, GLenum format) {
  targets.size = size;
}

// TODO(targets.2): compose the picture: from the textures to the window, which is bound.
//   Do:     bind each texture that is needed to the unit of its number, and make unit 0 active
//           again; then one triangle over the whole window: bind noVertices,
//           glDrawArrays(GL_TRIANGLES, 0, 3). The depth test is off already.
//   Expect: the same picture as before, now by way of a texture.      (targets.md, step 2)
inline void composeTargets(const Targets& targets, bool edges) {
  targets.compose.use();
  targets.compose.set("uDiffuse", int(kDiffuse)); // texture units
  targets.compose.set("uSpecular", int(kSpecular));
  targets.compose.set("uAmbient", int(kAmbient));
  targets.compose.set("uHasSpecular", targets.needed[kSpecular]);
  targets.compose.set("uHasAmbient", targets.needed[kAmbient]);
  targets.compose.set("uEdges", edges);
}
