#version 410 core
// Blinn-Phong lighting of the objects, in eye space.

#include "gg/lighting.glsl"
#include "shadow.glsl"

uniform mat4 uView; // eye from world
uniform vec3 uGlow; // light of the object's own

in vec3 vPosition; // eye space
in vec3 vNormal;   // eye space, any length
in vec3 vWorld;

layout(location = 0) out vec4 oColor;

void main() {
  vec3 normal = normalize(vNormal);
  Lit lit = blinnPhong(vPosition, normal);
  // A view turns (and mirrors) but doesn't stretch: its transpose takes directions back.
  float visible = visibility(vWorld, transpose(mat3(uView)) * normal);
  oColor = vec4(lit.ambient + visible * (lit.diffuse + lit.specular) + uGlow, 1);
  // What a half float can't hold would become infinity, and that times a filter's weight of 0 NaN.
  oColor = min(oColor, 65504.0);
}
