#version 410 core
// The objects as the floor sees them: `uView` is the mirrored view.

uniform mat4 uProjection; // clip from eye
uniform mat4 uView;       // mirrored eye from world
uniform mat4 uModel;      // world from model
uniform mat3 uNormal;     // eye from model, for normals: its sign turns with the mirror

// BEGIN SOLUTION(mirror.6)
uniform bool uClip; // quality.mirror_clip
// END SOLUTION(mirror.6)

layout(location = 0) in vec4 aPosition;
layout(location = 1) in vec3 aNormal;

out vec3 vPosition; // mirrored eye space
out vec3 vNormal;   // mirrored eye space
out vec3 vWorld;    // where the object really is, not its mirror image

void main() {
  vec4 world = uModel * aPosition;
  vec4 position = uView * world;
  vWorld = world.xyz;
  vPosition = position.xyz;
  vNormal = uNormal * aNormal;
  // TODO(mirror.5): the mirror has turned the normal inside: let it point outside again.
  // BEGIN SOLUTION(mirror.5)
  vNormal = -vNormal;
  // END SOLUTION(mirror.5)
  gl_Position = uProjection * position;
  // TODO(mirror.6): gl_ClipDistance[0] says how far from the floor this is; what is negative is cut away.
  // BEGIN SOLUTION(mirror.6)
  // Not by glEnable alone: llvmpipe clips by every distance that a shader writes.
  gl_ClipDistance[0] = uClip ? world.y : 1;
  // END SOLUTION(mirror.6)
}
