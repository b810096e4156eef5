#version 410 core
// The objects as the eye sees them.

uniform mat4 uProjection; // clip from eye
uniform mat4 uView;       // eye from world
uniform mat4 uModel;      // world from model
uniform mat3 uNormal;     // world from model, for normals
uniform int uObjectId;    // of the object that is drawn, at least 1
uniform int uMaterialId;  // of its material, at least 1

layout(location = 0) in vec4 aPosition;
layout(location = 1) in vec3 aNormal;

out vec3 vPosition;   // eye space
out vec3 vNormal;     // world space, any length
flat out uvec2 vIds;  // object, material

void main() {
  vec4 position = uView * (uModel * aPosition);
  vPosition = position.xyz;
  vNormal = uNormal * aNormal;
  vIds = uvec2(uObjectId, uMaterialId);
  gl_Position = uProjection * position;
}
