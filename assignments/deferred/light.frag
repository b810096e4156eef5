#version 410 core
// The light that leaves a surface, in three kinds, each into a target of its own.

#include "gg/lighting.glsl"

uniform mat4 uView; // eye from world

in vec3 vPosition; // eye space
in vec3 vNormal;   // world space, any length

layout(location = 0) out vec4 oDiffuse;
// TODO(targets.3): two more outputs, oSpecular at location 1 and oAmbient at location 2; and write
//   them below. Alpha is 1. Then compose.frag.
//   Expect: all three kinds of light.                               (targets.md, step 3)

// The largest half float: what is brighter would become infinity in a target of half floats.
const float kMost = 65504.0;

void main() {
  Lit lit = blinnPhong(vPosition, mat3(uView) * direction(vNormal));
  oDiffuse = vec4(min(lit.diffuse, kMost), 1);
}
