#version 410 core
// The occlusion without its noise, but with its edges: one direction at a time.

#include "gbuffer.glsl"

uniform sampler2D uOcclusion;
uniform bool uAlongColumns;
uniform int uReach; // quality.blur: pixels to each side

layout(location = 0) out float oOpen;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy), to = uAlongColumns ? ivec2(0, 1) : ivec2(1, 0);
  oOpen = texelFetch(uOcclusion, at, 0).r;
  if (!covered(here())) return;
  vec3 position = positionAt(here()), normal = normalAt(here());
  // TODO(ssao.4): the average of the pixels at + i * to, i from -uReach to uReach.
  //   Given:  `at`, `to`, `position`, `normal`; uOcclusion, sameSurface(), windowPixel(pixel).
  //   Goal:   each pixel in the window weighs 1, the two outermost 1/2, so that the widths of 4, 8,
  //           ... hold every number of dither() equally often; and the less, the less it shows the
  //           same surface.
  //   Expect: no grain, and sharp edges.                                  (README.md, step 4)
}
