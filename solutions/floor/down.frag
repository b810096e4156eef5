#version 410 core
// A level of the pyramid from the next larger one: blurred, at half the size.

#include "gg/pyramid.glsl"

uniform sampler2D uSource;
uniform vec2 uSize;  // pixels of what is drawn into
uniform int uFilter; // quality.bloom_filter

layout(location = 0) out vec4 oColor;

void main() {
  oColor = vec4(downsample(uSource, uSize, uFilter), 1);
}
