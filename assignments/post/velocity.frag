#version 410 core
// How far everything moved in the picture because the camera did.

#include "motion.glsl"

uniform sampler2D uDepth;
uniform mat4 uLastFromClip; // the last frame's clip space from this frame's

layout(location = 0) out vec2 oVelocity; // texture coordinates a frame

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(uDepth, pixel, 0).r; // 0 to 1
  vec2 uv = gl_FragCoord.xy / vec2(textureSize(uDepth, 0));
  vec4 now = vec4(0, 0, 0, 1), last = now;
  // TODO(motion_blur.1): what the pixel shows, in clip space, in this frame and in the last one.
  //   Given:  `uv` and `depth`, 0 to 1; uLastFromClip.
  //   Goal:   `now` with w = 1, all coordinates from -1 to 1, and `last`.
  oVelocity = moved(now, last);
}
