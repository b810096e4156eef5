#version 410 core
// The picture: the sum of the three kinds of light, the diffuse one with its edges emphasised.

uniform sampler2D uDiffuse;
uniform sampler2D uSpecular;
uniform sampler2D uAmbient;
uniform bool uHasSpecular; // false: nothing shines, and there is no such texture
uniform bool uHasAmbient;
uniform bool uEdges; // effects.edges

layout(location = 0) out vec4 oColor;

void main() {
  vec2 at = gl_FragCoord.xy / vec2(textureSize(uDiffuse, 0)); // texture coordinates, 0 to 1
  vec3 light = texture(uDiffuse, at).rgb;
  // TODO(targets.4): if uEdges, the handout's filter over this texel and its four neighbours
  //   (textureOffset), nowhere less than 0. Only the diffuse light: the others are added after it.
  // BEGIN SOLUTION(targets.4)
  if (uEdges)
    light = max(5.0 * light - textureOffset(uDiffuse, at, ivec2(0, -1)).rgb
                            - textureOffset(uDiffuse, at, ivec2(-1, 0)).rgb
                            - textureOffset(uDiffuse, at, ivec2(1, 0)).rgb
                            - textureOffset(uDiffuse, at, ivec2(0, 1)).rgb, 0.0);
  // END SOLUTION(targets.4)
  // TODO(targets.3): add the specular and the ambient light, each if there is such a texture.
  // BEGIN SOLUTION(targets.3)
  if (uHasSpecular) light += texture(uSpecular, at).rgb;
  if (uHasAmbient) light += texture(uAmbient, at).rgb;
  // END SOLUTION(targets.3)
  oColor = vec4(light, 1);
}
