#version 410 core
// The mean of a multisampled texture's samples.

#define SAMPLES sampler2DMS
vec4 sampleOf(sampler2DMS samples, ivec2 pixel, int i) { return texelFetch(samples, pixel, i); }

#include "mean.glsl"
