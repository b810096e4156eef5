#version 410 core
// The bright pass: what is brighter than the threshold, at half the scene's size.

#include "gg/pyramid.glsl"

uniform sampler2D uScene;
uniform vec2 uSize;       // pixels of what is drawn into
uniform float uThreshold; // bloom.threshold
uniform float uWeight;    // 1 / number of levels

layout(location = 0) out vec4 oColor;

void main() {
  vec3 color = downsampleFinite(uScene, uSize);
  vec3 bright = color;
  // TODO(bloom.4): the part of the scene's light that exceeds the threshold, in the same hue.
  //   Given:  `color`, the weighted mean of 4 x 4 pixels of the scene (a few more where its size is
  //           odd), NaN made 0, infinity 65504; uThreshold; uWeight.
  //   Goal:   its share of the light, as bloom.md says, is kept, times uWeight; the rest, and black,
  //           is 0.
  //   Expect: in level 0, only what glows.                            (bloom.md, step 4)
  oColor = vec4(bright, 1);
}
