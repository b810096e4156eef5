#version 410 core
// Picture 13: the scattered light and the reflection; behind all surfaces, the environment.

#include "figure.glsl"

uniform bool uHasDiffuse;    // false: all surfaces are black but for what they mirror
uniform bool uHasReflection; // false: no surface mirrors anything

layout(location = 0) out vec4 oComposition;

// The light that leaves the surface in all directions: the diffuse light, less the share that the
// surface has mirrored and so can't scatter. Otherwise it would give more light than it gets.
vec3 scattered() {
  vec3 mirrored = uHasReflection ? texelFetch(uFresnel, here(), 0).rgb : vec3(0);
  return (1.0 - mirrored) * texelFetch(uDiffuse, here(), 0).rgb;
}

void main() {
  vec3 light = texelFetch(uAlbedo, here(), 0).rgb;
  // TODO(figure.6): where there is a surface, the sum of scattered() and reflection, each if there
  //   is such a picture; elsewhere the environment in the direction of view.
  //   Expect: the finished picture.                                        (figure.md, step 6)
  // BEGIN SOLUTION(figure.6)
  light = vec3(0);
  if (!covered(here())) {
    light = lookUp(uEnvironment, viewDirection(here()));
  } else {
    if (uHasDiffuse) light += scattered();
    if (uHasReflection) light += texelFetch(uReflection, here(), 0).rgb;
  }
  // END SOLUTION(figure.6)
  oComposition = vec4(min(light, kMost), 1);
}
