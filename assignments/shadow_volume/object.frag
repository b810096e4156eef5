#version 410 core
// Blinn-Phong lighting in eye space, in two parts that are drawn one after the other.

#include "gg/lighting.glsl"

uniform bool uAmbient; // the light from all sides, which reaches into shadows
uniform bool uDirect;  // the lamp's light

in vec3 vPosition; // eye space
in vec3 vNormal;   // eye space, any length

layout(location = 0) out vec4 oColor;

void main() {
  Lit lit = blinnPhong(vPosition, normalize(vNormal));
  vec3 color = vec3(0);
  if (uAmbient) color += lit.ambient;
  if (uDirect) color += lit.diffuse + lit.specular;
  oColor = vec4(color, 1);
}
