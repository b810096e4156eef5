#version 410 core
// What a level of the pyramid gains from the next smaller one.

#include "gg/pyramid.glsl"

uniform sampler2D uSource;
uniform vec2 uSize;  // pixels of what is drawn into
uniform int uFilter; // quality.bloom_filter

layout(location = 0) out vec4 oColor;

void main() {
  oColor = vec4(upsample(uSource, uSize, uFilter), 1);
}
