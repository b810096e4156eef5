// Several samples a pixel: the scene is drawn for each of four, and their mean is the pixel's.
// Against antialiasing afterwards: what is smaller than a pixel was seen by some of them.
#pragma once

#include "antialias.hpp"

// What the scene is drawn into instead of its target. Multisampled textures (four depths and
// colours a pixel, shaded once for each object in it), or textures of twice the width and height.
struct Samples {
  explicit Samples(Method method)
      : multisampled(method == kMultisampled),
        mean({"screen.vert", multisampled ? "mean_of_samples.frag" : "mean_of_pixels.frag"}) {}

  bool multisampled;
  gg::Program mean;
  gg::Texture color, velocity, depth;
  gg::Framebuffer framebuffer;
  glm::ivec2 size{0};
};

inline void bind(const Samples& samples, Unit unit, GLuint texture) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(samples.multisampled ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, texture);
}

inline void makeSamples(Samples& samples, const glm::ivec2& window, bool velocities) {
  samples.size = samples.multisampled ? window : 2 * window;
  const auto attachNew = [&](GLenum point, const gg::Texture& texture, Unit unit, GLenum format) {
    if (samples.multisampled) {
      bind(samples, unit, texture);
      glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, 4, format, window.x, window.y, GL_TRUE);
      glFramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D_MULTISAMPLE, texture, 0);
    } else {
      makeStorage(texture, unit, format, GL_NEAREST, samples.size);
      attach(point, texture);
    }
  };
  glBindFramebuffer(GL_FRAMEBUFFER, samples.framebuffer);
  attachNew(GL_COLOR_ATTACHMENT0, samples.color, kColor, GL_RGBA16F);
  if (velocities) attachNew(GL_COLOR_ATTACHMENT1, samples.velocity, kVelocity, GL_RG16F);
  attachNew(GL_DEPTH_ATTACHMENT, samples.depth, kDepth, GL_DEPTH_COMPONENT32F);
  const GLenum outputs[] = {GL_COLOR_ATTACHMENT0,
                            velocities ? GLenum(GL_COLOR_ATTACHMENT1) : GLenum(GL_NONE)};
  glDrawBuffers(2, outputs);
  requireComplete("samples");
}

// Pass "mean": leaves in the scene's target what its samples come to.
inline void drawMean(const Samples& samples, const SceneTarget& target, const glm::ivec2& size,
                     bool velocities, const Screen& screen) {
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  glViewport(0, 0, size.x, size.y);
  bind(samples, kColor, samples.color);
  bind(samples, kDepth, samples.depth);
  if (velocities) bind(samples, kVelocity, samples.velocity);
  samples.mean.set("uColor", int(kColor));
  samples.mean.set("uDepth", int(kDepth));
  samples.mean.set("uVelocity", int(kVelocity));
  samples.mean.set("uHasVelocity", velocities);
  glDepthFunc(GL_ALWAYS);
  screen.draw(samples.mean);
  glDepthFunc(GL_LESS);
}
