#version 410 core
// Picture 12: the environment, as the surfaces mirror it.

#include "figure.glsl"

layout(location = 0) out vec4 oReflection;

void main() {
  vec3 reflection = vec3(0);
  // TODO(figure.5): where there is a surface, the Fresnel term times the environment in the
  //   reflected direction (decode() takes it out of its texture).          (figure.md, step 5)
  oReflection = vec4(min(reflection, kMost), 1);
}
