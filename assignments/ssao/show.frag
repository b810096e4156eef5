#version 410 core
// A picture to look at instead of the scene: debug.picture.

#include "gbuffer.glsl"
#include "upsample.glsl"

uniform int uPicture; // 1 normals, 2 positions, 3 occlusion

layout(location = 0) out vec4 oColor;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 color = vec3(0);
  if (uPicture == 3) color = vec3(openAt(pixel));
  else if (covered(pixel) && uPicture == 1) color = 0.5 + 0.5 * normalAt(pixel);
  else if (covered(pixel)) color = 0.5 + 0.5 * sin(6.2831853 * positionAt(pixel)); // a wave a unit
  oColor = vec4(color, 1);
}
