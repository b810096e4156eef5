#version 410 core
// Picture 11: the share of the light that is reflected as by a mirror.

#include "figure.glsl"

uniform vec3 uReflectance[5]; // by material: the share of light that comes from straight ahead

layout(location = 0) out vec4 oFresnel;

void main() {
  vec3 fresnel = vec3(0);
  vec3 straight = uReflectance[texelFetch(uIds, here(), 0).y];
  // TODO(figure.5): the share that is mirrored, by Schlick's approximation.
  //   Given:  straight, normalAt(), viewDirection(), which points to the surface.
  //   Goal:   no cosine is less than 0, and a material whose `straight` is 0 reflects nothing at
  //           all.                                                         (figure.md, step 5)
  // BEGIN SOLUTION(figure.5)
  float c = max(dot(normalAt(here()), -viewDirection(here())), 0.0);
  if (straight != vec3(0)) fresnel = straight + (1.0 - straight) * pow(1.0 - c, 5.0);
  // END SOLUTION(figure.5)
  oFresnel = vec4(fresnel, 1);
}
