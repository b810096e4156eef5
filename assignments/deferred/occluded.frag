#version 410 core
// Picture 6: the light that falls on each surface and comes through to it.

#include "figure.glsl"

layout(location = 0) out vec4 oOccluded;

// The mean occlusion of 4 x 4 pixels, of those of the same object.
float meanOpen() {
  uint object = texelFetch(uIds, here(), 0).x;
  ivec2 last = textureSize(uIds, 0) - 1;
  float sum = 0.0, count = 0.0;
  for (int y = -1; y <= 2; ++y)
    for (int x = -1; x <= 2; ++x) {
      ivec2 at = clamp(here() + ivec2(x, y), ivec2(0), last);
      if (texelFetch(uIds, at, 0).x != object) continue;
      sum += texelFetch(uOcclusion, at, 0).r;
      count += 1.0;
    }
  return sum / count;
}

void main() {
  oOccluded = vec4(meanOpen() * texelFetch(uIrradiance, here(), 0).rgb, 1);
}
