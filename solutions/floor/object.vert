#version 410 core
// The objects as the eye sees them.

uniform mat4 uProjection; // clip from eye
uniform mat4 uView;       // eye from world
uniform mat4 uModel;      // world from model
uniform mat3 uNormal;     // eye from model, for normals

layout(location = 0) in vec4 aPosition;
layout(location = 1) in vec3 aNormal;

out vec3 vPosition; // eye space
out vec3 vNormal;   // eye space
out vec3 vWorld;

void main() {
  vec4 world = uModel * aPosition;
  vec4 position = uView * world;
  vWorld = world.xyz;
  vPosition = position.xyz;
  vNormal = uNormal * aNormal;
  gl_Position = uProjection * position;
}
