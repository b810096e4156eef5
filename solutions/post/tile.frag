#version 410 core
// The longest velocity of each tile (McGuire et al. 2012, "A Reconstruction Filter for Plausible
// Motion Blur"). What is drawn into has a pixel for each tile.

uniform sampler2D uVelocity;
uniform int uTile; // width and height of a tile, pixels

layout(location = 0) out vec2 oVelocity;

void main() {
  ivec2 first = uTile * ivec2(gl_FragCoord.xy);
  ivec2 size = textureSize(uVelocity, 0);
  ivec2 end = min(first + uTile, size);
  oVelocity = vec2(0);
  // TODO(motion_blur.4): of the velocities of all pixels from `first` to before `end`, the longest.
  //   Given:  `first`, `end`, uVelocity; `size`, as the picture may be wider than high.
  //   Goal:   the one that is the most pixels long.
  // BEGIN SOLUTION(motion_blur.4)
  float longest = 0.0; // squared, pixels
  for (int y = first.y; y < end.y; ++y)
    for (int x = first.x; x < end.x; ++x) {
      vec2 velocity = texelFetch(uVelocity, ivec2(x, y), 0).xy;
      vec2 pixels = velocity * vec2(size);
      if (dot(pixels, pixels) > longest) {
        longest = dot(pixels, pixels);
        oVelocity = velocity;
      }
    }
  // END SOLUTION(motion_blur.4)
}
