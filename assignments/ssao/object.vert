#version 410 core
// Ground, mesh and boxes.

uniform mat4 uProjection; // clip from eye
uniform mat4 uView;       // eye from world
uniform mat4 uModel;      // world from model
uniform mat3 uNormal;     // eye from model, for normals

layout(location = 0) in vec4 aPosition;
layout(location = 1) in vec3 aNormal;

out vec3 vPosition; // eye space
out vec3 vNormal;   // eye space

void main() {
  vec4 position = uView * uModel * aPosition;
  vPosition = position.xyz;
  vNormal = uNormal * aNormal;
  gl_Position = uProjection * position;
}
