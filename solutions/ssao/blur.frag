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
  // BEGIN SOLUTION(ssao.4)
  float sum = 0.0, weights = 0.0;
  for (int i = -uReach; i <= uReach; ++i) {
    ivec2 pixel = at + i * to;
    if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, textureSize(uOcclusion, 0))))
      continue;
    float weight = abs(i) == uReach ? 0.5 : 1.0;
    weight *= sameSurface(windowPixel(pixel), position, normal);
    sum += weight * texelFetch(uOcclusion, pixel, 0).r;
    weights += weight;
  }
  oOpen = sum / weights; // this pixel's own is not 0
  // END SOLUTION(ssao.4)
}
