// What the passes draw into.
#pragma once

#include <gg/gg.hpp>

// The texture units that the shaders' samplers read.
enum Unit {
  kColor,
  kVelocity,
  kDepth,
  kTiles,
  kGlow,
  kPicture,
  kPattern,
  kEdges,
  kWeights,
  kAreas,
  kSearch
};

inline void bind(Unit unit, GLuint texture) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture);
}

// The passes behind the scene's draw one triangle over the whole target, without depths.
struct Screen {
  gg::VertexArray noVertices; // screen.vert makes its own corners

  void draw(const gg::Program& program) const {
    program.use();
    glBindVertexArray(noVertices);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
};

// Storage for a texture, which stays bound in its unit.
//   filter: GL_NEAREST or GL_LINEAR
inline void makeStorage(const gg::Texture& texture, Unit unit, GLenum format, GLint filter,
                        const glm::ivec2& size) {
  bind(unit, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), size.x, size.y, 0,
               unit == kDepth ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

inline void attach(GLenum point, const gg::Texture& texture) {
  glFramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, texture, 0);
}

inline void requireComplete(const char* name) {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error(std::string("the framebuffer object \"") + name +
                             "\" is not complete");
}

// The scene's light, what it moves, and depths. Only what something reads is made.
struct SceneTarget {
  gg::Program program{{"object.vert", "object.frag"}};
  gg::Texture color; // linear light
  gg::Texture velocity;
  gg::Texture depth;
  gg::Framebuffer framebuffer;
};

inline void makeSceneTarget(SceneTarget& target, const glm::ivec2& size, bool velocities) {
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  makeStorage(target.color, kColor, GL_RGBA16F, GL_LINEAR, size);
  attach(GL_COLOR_ATTACHMENT0, target.color);
  if (velocities) {
    makeStorage(target.velocity, kVelocity, GL_RG16F, GL_NEAREST, size);
    attach(GL_COLOR_ATTACHMENT1, target.velocity);
  }
  makeStorage(target.depth, kDepth, GL_DEPTH_COMPONENT32F, GL_NEAREST, size);
  attach(GL_DEPTH_ATTACHMENT, target.depth);
  const GLenum outputs[] = {GL_COLOR_ATTACHMENT0,
                            velocities ? GLenum(GL_COLOR_ATTACHMENT1) : GLenum(GL_NONE)};
  glDrawBuffers(2, outputs);
  requireComplete("scene");
}

// One texture that a pass draws into.
struct Target {
  gg::Texture texture;
  gg::Framebuffer framebuffer;
};

inline void makeTarget(const Target& target, Unit unit, GLenum format, GLint filter,
                       const glm::ivec2& size, const char* name) {
  makeStorage(target.texture, unit, format, filter, size);
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  attach(GL_COLOR_ATTACHMENT0, target.texture);
  requireComplete(name);
}
