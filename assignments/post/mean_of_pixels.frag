#version 410 core
// The mean of two by two pixels.

#define SAMPLES sampler2D
vec4 sampleOf(sampler2D samples, ivec2 pixel, int i) {
  return texelFetch(samples, 2 * pixel + ivec2(i % 2, i / 2), 0);
}

#include "mean.glsl"
