#version 410 core
// The bright pass: what is brighter than the threshold, at half the scene's size.

#include "gg/pyramid.glsl"

uniform sampler2D uScene;
uniform vec2 uSize;       // pixels of what is drawn into
uniform float uThreshold; // bloom.threshold
uniform float uWeight;    // 1 / number of levels

layout(location = 0) out vec4 oColor;

void main() {
  // The weighted mean of 4 x 4 pixels of the scene (a few more where its size is odd), NaN and infinity
  // left out.
  vec3 color = downsampleFinite(uScene, uSize);
  vec3 bright = vec3(0);
  // TODO(bloom.3): keep what exceeds the threshold, in the same hue.
  //   Given:  `color`, uThreshold, uWeight.
  //   Do:     brightness = the largest of r, g, b; ratio = max(brightness - threshold, 0) /
  //           max(brightness, 1e-5); bright = color * ratio * uWeight.
  // BEGIN SOLUTION(bloom.3)
  float brightness = max(color.r, max(color.g, color.b));
  float ratio = max(brightness - uThreshold, 0.0) / max(brightness, 1e-5);
  bright = color * ratio * uWeight;
  // END SOLUTION(bloom.3)
  oColor = vec4(bright, 1);
}
