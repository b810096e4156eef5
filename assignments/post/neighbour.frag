#version 410 core
// The longest velocity of each tile and of the tiles around it: what may be blurred across it.

uniform sampler2D uTiles; // the longest velocity of each
uniform vec2 uSize;       // of the picture, pixels

layout(location = 0) out vec2 oVelocity;

void main() {
  ivec2 tile = ivec2(gl_FragCoord.xy);
  oVelocity = texelFetch(uTiles, tile, 0).xy;
  // TODO(motion_blur.4): of the tile and the eight around it, the longest.
  //   Given:  `tile`, uTiles, uSize.
  //   Goal:   the one that is the most pixels long; there is no tile beyond the picture's edge.
  //   Expect: the fast box's blur reaches beyond its outline.             (motion_blur.md, step 4)
}
