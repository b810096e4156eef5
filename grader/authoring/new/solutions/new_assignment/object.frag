#version 410 core
// Ambient and diffuse light of the object, in eye space.

#include "gg/lighting.glsl"

in vec3 vPosition; // eye space
in vec3 vNormal;   // eye space, any length

layout(location = 0) out vec4 oColor;

void main() {
  vec3 normal = normalize(vNormal);
  vec3 color = uMaterial.ambient.rgb * uLight.ambient.rgb;

  // TODO(new_assignment.1): add the diffuse light.
  //   Given:  `normal`, vPosition and uLight.position, all in eye space; uMaterial, uLight.
  //   Do:     find the unit vector to the light. Add the material's diffuse colour times the
  //           light's, times the cosine between that vector and the normal, but never below 0.
  //   Expect: the object looks solid, bright where it faces the light.  (README.md, step 1)
  // BEGIN SOLUTION(new_assignment.1)
  vec3 toLight = normalize(uLight.position.xyz - vPosition);
  color += uMaterial.diffuse.rgb * uLight.diffuse.rgb * max(dot(normal, toLight), 0.0);
  // END SOLUTION(new_assignment.1)

  oColor = vec4(color, 1);
}
