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
  // BEGIN SOLUTION(motion_blur.4)
  float longest = 0.0; // squared, pixels
  ivec2 from = max(tile - 1, ivec2(0)), to = min(tile + 1, textureSize(uTiles, 0) - 1);
  for (int y = from.y; y <= to.y; ++y)
    for (int x = from.x; x <= to.x; ++x) {
      vec2 velocity = texelFetch(uTiles, ivec2(x, y), 0).xy;
      vec2 pixels = velocity * uSize;
      if (dot(pixels, pixels) > longest) {
        longest = dot(pixels, pixels);
        oVelocity = velocity;
      }
    }
  // END SOLUTION(motion_blur.4)
}
