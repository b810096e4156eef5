#version 410 core
// The G-buffer: what is seen, and how much light of either kind it reflects.

#include "gg/lighting.glsl"

in vec3 vPosition; // eye space
in vec3 vNormal;   // eye space, any length

layout(location = 0) out vec4 oNormal; // eye space, unit length
layout(location = 1) out vec4 oAmbient;
layout(location = 2) out vec4 oDirect;

void main() {
  vec3 normal = direction(vNormal);
  Lit lit = blinnPhong(vPosition, normal);
  oNormal = vec4(normal, 0);
  // What a half float can't hold would become infinity.
  oAmbient = vec4(min(lit.ambient, 65504.0), 1);
  oDirect = vec4(min(lit.diffuse + lit.specular, 65504.0), 1);
}
