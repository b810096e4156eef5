#version 410 core
// The object as the eye sees it.

uniform mat4 uProjection; // clip from eye
uniform mat4 uModelView;  // eye from model
uniform mat3 uNormal;     // eye from model, for normals

layout(location = 0) in vec4 aPosition;
layout(location = 1) in vec3 aNormal;

out vec3 vPosition; // eye space
out vec3 vNormal;   // eye space

void main() {
  vec4 position = uModelView * aPosition;
  vPosition = position.xyz;
  vNormal = uNormal * aNormal;
  gl_Position = uProjection * position;
}
