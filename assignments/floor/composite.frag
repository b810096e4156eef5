#version 410 core
// The scene and its bloom, as the window shows them.

#include "gg/pyramid.glsl"

uniform sampler2D uScene;
uniform sampler2D uBloom; // the sum of all levels
uniform bool uGlows;      // is there any bloom to add?
uniform vec2 uSize;       // pixels of the window
uniform int uFilter;      // quality.bloom_filter

layout(location = 0) out vec4 oColor;

// The one place where light becomes what a display shows: what is brighter than 1 is cut off, then
// the sRGB curve (IEC 61966-2-1).
vec3 display(vec3 light) {
  vec3 cut = min(light, 1.0);
  return mix(12.92 * cut, 1.055 * pow(cut, vec3(1.0 / 2.4)) - 0.055, greaterThan(cut, vec3(0.0031308)));
}

void main() {
  vec3 light = finite(texelFetch(uScene, ivec2(gl_FragCoord.xy), 0).rgb);
  // TODO(bloom.7): add the bloom, if there is any.
  //   Given:  upsample(uBloom, uSize, uFilter), its value at this pixel of the window.
  oColor = vec4(display(light), 1);
}
