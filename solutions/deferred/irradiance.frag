#version 410 core
// Picture 4: the light that falls on each surface from everywhere, as if nothing were in its way.

#include "figure.glsl"

layout(location = 0) out vec4 oIrradiance;

void main() {
  vec3 irradiance = vec3(0);
  // TODO(figure.3): where there is a surface, look the irradiance map up by its normal.
  //   Given:  here(), covered(), normalAt(), lookUp() of figure.glsl.      (figure.md, step 3)
  // BEGIN SOLUTION(figure.3)
  if (covered(here())) irradiance = lookUp(uIrradianceMap, normalAt(here()));
  // END SOLUTION(figure.3)
  oIrradiance = vec4(min(irradiance, kMost), 1);
}
