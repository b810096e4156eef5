#version 410 core
// The floor: a rectangle in the plane y = 0 of the world.

uniform mat4 uProjection; // clip from eye
uniform mat4 uView;       // eye from world

layout(location = 0) in vec4 aPosition;
layout(location = 1) in vec3 aNormal;

out vec3 vPosition; // eye space
out vec3 vNormal;   // eye space
out vec3 vWorld;

void main() {
  vec4 position = uView * aPosition;
  vPosition = position.xyz;
  vNormal = mat3(uView) * aNormal;
  vWorld = aPosition.xyz;
  gl_Position = uProjection * position;
}
