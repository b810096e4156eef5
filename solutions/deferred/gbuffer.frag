#version 410 core
// The G-buffer: what the surfaces are like, not how bright they are.

#include "encoding.glsl"
#include "gg/lighting.glsl"

in vec3 vNormal;    // world space, any length
flat in uvec2 vIds; // object, material

layout(location = 0) out vec4 oAlbedo;
// TODO(figure.2): two more outputs: oNormal, a vec4 at location 1, and oIds, a uvec2 at location 2;
//   and write them below: the unit normal, encoded by encode(), and vIds.
//   Expect: the picture of the normals.                                  (figure.md, step 2)
// BEGIN SOLUTION(figure.2)
layout(location = 1) out vec4 oNormal;
layout(location = 2) out uvec2 oIds;
// END SOLUTION(figure.2)

void main() {
  oAlbedo = vec4(uMaterial.diffuse.rgb, 1);
  // BEGIN SOLUTION(figure.2)
  oNormal = encode(direction(vNormal));
  oIds = vIds;
  // END SOLUTION(figure.2)
}
