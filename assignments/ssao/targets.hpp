// What the passes draw into: the G-buffer, and the occlusion that is found from it.
#pragma once

#include <gg/gg.hpp>

// The texture units that the shaders' samplers read.
enum Unit { kDepth, kNormals, kAmbient, kDirect, kOcclusion };

// What is seen at each pixel of the window.
struct GBuffer {
  gg::Program program{{"object.vert", "gbuffer.frag"}};
  gg::Texture normals; // eye space; made only if something reads it
  gg::Texture ambient; // light from all sides, as the surface reflects it; the background's too
  gg::Texture direct;  // the lamp's light
  gg::Texture depth;
  gg::Framebuffer framebuffer;
  glm::ivec2 size{0}; // pixels
};

// How open each surface is to light from all sides: 1 wholly, 0 not at all.
struct Occlusion {
  gg::Program find{{"screen.vert", "occlusion.frag"}};
  gg::Program blur{{"screen.vert", "blur.frag"}};
  // The blur goes from the first to the second along rows, and back along columns.
  std::array<gg::Texture, 2> open;
  std::array<gg::Framebuffer, 2> framebuffers;
  glm::ivec2 size{0}; // pixels
};

// Storage for the texture of a unit, without a filter: it is read pixel by pixel. Leaves it bound.
inline void makeStorage(const gg::Texture& texture, Unit unit, GLenum format,
                        const glm::ivec2& size) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), size.x, size.y, 0,
               unit == kDepth ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

inline void requireComplete(const char* name) {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error(std::string("the framebuffer object \"") + name +
                             "\" is not complete");
}

//   size: of the window, pixels
inline void makeGBuffer(GBuffer& buffer, const glm::ivec2& size, bool normals) {
  buffer.size = size;
  glBindFramebuffer(GL_FRAMEBUFFER, buffer.framebuffer);
  const auto attach = [&](const gg::Texture& texture, Unit unit, GLenum format, GLenum point) {
    makeStorage(texture, unit, format, size);
    glFramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, texture, 0);
  };
  if (normals) attach(buffer.normals, kNormals, GL_RGBA16F, GL_COLOR_ATTACHMENT0);
  attach(buffer.ambient, kAmbient, GL_RGBA16F, GL_COLOR_ATTACHMENT1);
  attach(buffer.direct, kDirect, GL_RGBA16F, GL_COLOR_ATTACHMENT2);
  attach(buffer.depth, kDepth, GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
  const GLenum outputs[] = {normals ? GLenum(GL_COLOR_ATTACHMENT0) : GLenum(GL_NONE),
                            GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2};
  glDrawBuffers(3, outputs);
  requireComplete("G-buffer");
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

//   size: pixels, the window's or half of it
inline void makeOcclusion(Occlusion& occlusion, const glm::ivec2& size, bool blurred) {
  occlusion.size = size;
  for (std::size_t i = 0; i < (blurred ? 2u : 1u); ++i) {
    makeStorage(occlusion.open[i], kOcclusion, GL_R8, size);
    glBindFramebuffer(GL_FRAMEBUFFER, occlusion.framebuffers[i]);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, occlusion.open[i],
                           0);
    requireComplete("occlusion");
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

// Can this scene show any occlusion? Only light from all sides is kept away by it.
inline bool showsOcclusion(const gg::Scene& scene) {
  if (!scene.flag("effects.ssao")) return false;
  if (scene.flag("debug.draw_all_passes") || scene.integer("debug.picture") == 3) return true;
  return glm::vec3(scene.light.ambient) != glm::vec3(0) && scene.real("ao.radius") > 0;
}
