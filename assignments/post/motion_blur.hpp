// Motion blur: how far everything moved since the last frame, and the picture blurred along that.
#pragma once

#include "targets.hpp"

struct MotionBlur {
  gg::Program fromDepth{{"screen.vert", "velocity.frag"}};
  gg::Program blur{{"screen.vert", "motion_blur.frag"}};
  gg::Program tile{{"screen.vert", "tile.frag"}};
  gg::Program neighbour{{"screen.vert", "neighbour.frag"}};
  gg::Program gather{{"screen.vert", "gather.frag"}};
  Target velocity;          // of the camera alone
  Target tiles, neighbours; // a pixel for each tile
  Target blurred;
};

// How velocities are found: quality.velocity.
enum Velocity { kOfTheCamera, kOfEveryObject, kOfTheNeighbours };

//   size: of the window, pixels;  tile: width and height of one, pixels
inline void makeMotionBlur(const MotionBlur& motion, const glm::ivec2& size, Velocity velocity,
                           int tile) {
  if (velocity == kOfTheCamera)
    makeTarget(motion.velocity, kVelocity, GL_RG16F, GL_NEAREST, size, "velocity");
  if (velocity == kOfTheNeighbours) {
    const glm::ivec2 tiles = (size + tile - 1) / tile;
    makeTarget(motion.tiles, kTiles, GL_RG16F, GL_NEAREST, tiles, "tiles");
    makeTarget(motion.neighbours, kTiles, GL_RG16F, GL_NEAREST, tiles, "neighbours");
  }
  makeTarget(motion.blurred, kColor, GL_RGBA16F, GL_LINEAR, size, "motion blur");
}

// The longest velocity of each tile, and of each tile and the eight around it. Leaves the latter in
// unit kTiles.
inline void drawTiles(const MotionBlur& motion, const glm::ivec2& size, int tile,
                      const Screen& screen) {
  const glm::ivec2 tiles = (size + tile - 1) / tile;
  glViewport(0, 0, tiles.x, tiles.y);
  glBindFramebuffer(GL_FRAMEBUFFER, motion.tiles.framebuffer);
  motion.tile.set("uVelocity", int(kVelocity));
  motion.tile.set("uTile", tile);
  screen.draw(motion.tile);

  glBindFramebuffer(GL_FRAMEBUFFER, motion.neighbours.framebuffer);
  bind(kTiles, motion.tiles.texture);
  motion.neighbour.set("uTiles", int(kTiles));
  motion.neighbour.set("uSize", glm::vec2(size));
  screen.draw(motion.neighbour);

  bind(kTiles, motion.neighbours.texture);
  glViewport(0, 0, size.x, size.y);
}

// Can this scene show any motion blur? Only what moves while the shutter is open is blurred.
inline bool showsMotion(const gg::Scene& scene) {
  if (!scene.flag("effects.motion_blur")) return false;
  if (scene.flag("debug.draw_all_passes") || scene.integer("debug.picture") == 3) return true;
  const bool camera = scene.real("motion.turn") != 0;
  const bool objects =
      scene.real("motion.speed") != 0 && scene.integer("quality.velocity") != kOfTheCamera;
  return (camera || objects) && scene.real("motion.shutter") > 0;
}
