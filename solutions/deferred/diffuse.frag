#version 410 core
// Picture 8: the light that the surfaces scatter.

#include "figure.glsl"

layout(location = 0) out vec4 oDiffuse;

void main() {
  vec3 diffuse = vec3(0);
  // TODO(figure.3): what the surface scatters of the light that comes through to it.
  //   Given:  uAlbedo, uOccluded, here(), kPi.                             (figure.md, step 3)
  // BEGIN SOLUTION(figure.3)
  diffuse = texelFetch(uAlbedo, here(), 0).rgb * texelFetch(uOccluded, here(), 0).rgb / kPi;
  // END SOLUTION(figure.3)
  oDiffuse = vec4(min(diffuse, kMost), 1);
}
