#version 410 core
// The light of a pixel: ambient light as far as it gets in, and the lamp's.

#include "gbuffer.glsl"
#include "upsample.glsl"

uniform sampler2D uAmbient;
uniform sampler2D uDirect;

layout(location = 0) out vec4 oColor;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 ambient = texelFetch(uAmbient, pixel, 0).rgb;
  vec3 direct = texelFetch(uDirect, pixel, 0).rgb;
  float open = openAt(pixel); // 0 to 1
  vec3 color = ambient + direct;
  // TODO(ssao.5): the surface gets `open` of the ambient light, and all of the lamp's.
  //   Expect: soft shadows where things touch.                            (README.md, step 5)
  oColor = vec4(color, 1);
}
