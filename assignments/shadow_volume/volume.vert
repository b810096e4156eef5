#version 410 core
// The shadow volume: what faces the light stays, what doesn't goes to infinity.

uniform mat4 uProjection; // clip from eye
uniform mat4 uView;       // eye from world
uniform mat4 uModel;      // world from model
uniform vec3 uLight;      // model space

layout(location = 0) in vec4 aPosition;
layout(location = 1) in vec4 aPlane; // of the face that the vertex belongs to, see volume.hpp

invariant gl_Position; // as in object.vert

void main() {
  vec4 position = aPosition;
  // TODO(shadow_volume.2): if the vertex's face has the light behind it, move the vertex to infinity,
  //   straight away from the light.
  //   Given:  aPosition, aPlane and uLight, all in model space.
  //   Do:     a point at infinity is a direction with w = 0.
  //   Expect: with V held down white walls behind the blocks.    (README.md, step 2)
  gl_Position = uProjection * (uView * (uModel * position));
}
