#version 410 core
// Picture 6: the light that falls on each surface and comes through to it.

#include "figure.glsl"

uniform vec3 uSunDirection;  // to its middle, world space, unit length
uniform vec3 uSunIrradiance; // of a surface that faces it; 0: a picture of the sky has no sun apart

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

// The sun's part in the irradiance. Its light comes from one direction: how much of the half space is
// open says nothing of whether that one is.
vec3 fromSun(vec3 irradiance) {
  float cosine = max(dot(normalAt(here()), uSunDirection), 0.0);
  return min(cosine * uSunIrradiance, irradiance);
}

void main() {
  vec3 irradiance = texelFetch(uIrradiance, here(), 0).rgb;
  oOccluded = vec4(mix(fromSun(irradiance), irradiance, meanOpen()), 1);
}
