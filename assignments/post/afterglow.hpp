// Afterglow: two textures in turn. Each frame one of them is read, which holds what the last frame
// left, and the other one drawn into.
#pragma once

#include "targets.hpp"

struct Glow {
  gg::Program program{{"screen.vert", "afterglow.frag"}};
  std::array<gg::Texture, 2> textures; // linear light
  std::array<gg::Framebuffer, 2> framebuffers;
  std::size_t newest = 0; // the texture that the last frame drew into
};

// Makes both, black: nothing has glowed yet. Also after the window has got another size.
//   format: of the textures, such as GL_RGBA16F
inline void makeGlow(Glow& glow, const glm::ivec2& size, GLenum format) {
  // TODO(afterglow.1): storage for both textures, each in its own framebuffer object, cleared.
  //   Given:  makeStorage(texture, kGlow, format, GL_NEAREST, size), attach(), requireComplete().
  (void)glow, (void)size, (void)format;
}

// Adds what goes on glowing to `color`. Returns the texture that holds both.
//   decay: what is left of the last frame's, 0 to 1
inline GLuint addGlow(Glow& glow, GLuint color, float decay, const Screen& screen) {
  GLuint result = color;
  glow.program.set("uColor", int(kColor));
  glow.program.set("uGlow", int(kGlow));
  glow.program.set("uDecay", decay);
  // TODO(afterglow.1): draw glow.program into the older texture, reading the newer one.
  //   Given:  bind(kColor, ...), bind(kGlow, ...); screen.draw(). The viewport is right.
  //   Goal:   `result` is the texture that was drawn into, and glow.newest says which that is.
  //   Expect: the same picture as before. T shows two textures more.         (afterglow.md, step 1)
  (void)screen;
  return result;
}

// What is left after a while of what glowed, 0 to 1.
//   seconds: that have passed since the last frame, or less than 0 if the clock was put back
//   constant: seconds after which 1/e is left
inline float decayAfter(double seconds, double constant) {
  if (constant == 0) return 0; // it goes out at once
  double decay = 0.9;
  // TODO(afterglow.3): as much in one step of 1/30 s as in two of 1/60 s.
  //   Goal:   e to the power of minus the seconds over the constant; of a clock that was put back,
  //           all is left.
  //   Expect: the trail is as long at any number of frames a second.         (afterglow.md, step 3)
  (void)seconds, (void)constant;
  return static_cast<float>(decay);
}

// Can this scene show any afterglow?
inline bool showsGlow(const gg::Scene& scene) {
  if (!scene.flag("effects.afterglow")) return false;
  return scene.flag("debug.draw_all_passes") || scene.real("afterglow.seconds") > 0;
}
