#version 410 core
// Everything in the world.

uniform mat4 uProjection;    // clip from eye
uniform mat4 uView;          // eye from world
uniform mat4 uModel;         // world from model
uniform mat3 uNormal;        // eye from model, for normals
uniform mat4 uLastFromModel; // the last frame's clip space from model

layout(location = 0) in vec4 aPosition;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in vec2 aUv;

out vec3 vModel;    // model space
out vec3 vPosition; // eye space
out vec3 vNormal;   // eye space
out vec2 vUv;
out vec4 vNow;  // clip space, this frame's
out vec4 vLast; // clip space, the last frame's

void main() {
  vec4 position = uView * uModel * aPosition;
  vModel = aPosition.xyz;
  vPosition = position.xyz;
  vNormal = uNormal * aNormal;
  vUv = aUv;
  gl_Position = uProjection * position;
  vNow = gl_Position;
  vLast = vNow;
  // TODO(motion_blur.3): where this point was in the last frame.
  //   Given:  uLastFromModel.
  //   Expect: with object.frag, the fast box and the ball are blurred too. (motion_blur.md, step 3)
}
