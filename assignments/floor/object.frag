#version 410 core
// Blinn-Phong lighting of the objects, in eye space.

#include "gg/lighting.glsl"

in vec3 vPosition; // eye space
in vec3 vNormal;   // eye space, any length

layout(location = 0) out vec4 oColor;

void main() {
  Lit lit = blinnPhong(vPosition, normalize(vNormal));
  oColor = vec4(lit.ambient + lit.diffuse + lit.specular, 1);
}
