#version 410 core
// Picture 9: where the line of sight goes on to, if the surface is a mirror.

#include "figure.glsl"

layout(location = 0) out vec4 oReflected;

void main() {
  vec3 reflected = vec3(0, 0, 1);
  // TODO(figure.5): viewDirection(here()), reflected at the surface.       (figure.md, step 5)
  // BEGIN SOLUTION(figure.5)
  reflected = reflect(viewDirection(here()), normalAt(here()));
  // END SOLUTION(figure.5)
  oReflected = covered(here()) ? encode(reflected) : vec4(0);
}
