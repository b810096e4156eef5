#version 410 core
// One axis of a Gaussian with weights that were worked out before.

const int kMost = 128;

uniform sampler2D uSource;
uniform vec2 uAxis; // (1,0) or (0,1)
uniform int uCount; // of samples to one side, the middle one included
uniform float uOffset[kMost]; // texels
uniform float uWeight[kMost];

layout(location = 0) out vec4 oColor;

void main() {
  vec2 texel = uAxis / vec2(textureSize(uSource, 0));
  vec2 at = gl_FragCoord.xy / vec2(textureSize(uSource, 0));
  vec3 sum = uWeight[0] * textureLod(uSource, at, 0.0).rgb;
  for (int i = 1; i < uCount; ++i) {
    vec2 offset = uOffset[i] * texel;
    sum += uWeight[i] * (textureLod(uSource, at + offset, 0.0).rgb + textureLod(uSource, at - offset, 0.0).rgb);
  }
  oColor = vec4(sum, 1);
}
