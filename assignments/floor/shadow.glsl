// How much of the light reaches a point: the comparison with the shadow map.

uniform bool uShadow;                // is there a shadow map to ask?
uniform mat4 uLightClipFromWorld;    // the light's projection and view
uniform sampler2DShadow uShadowMap;  // what the pass "shadow" drew
uniform vec3 uLightWorld;            // the light's position, world space
uniform int uShadowBias;             // quality.shadow_bias
uniform int uPcfRadius;              // quality.pcf_radius
uniform float uShadowTexel;          // side of a map's texel, one unit away from the light

float comparison(vec3 at);
vec3 offset(vec3 world, vec3 normal);
float constantBias();

// 1 where the light is seen, 0 in shadow.
//   world: a point of a surface;  normal: of the surface, unit length; both in world space
float visibility(vec3 world, vec3 normal) {
  if (!uShadow) return 1.0;
  world = offset(world, normal);
  // TODO(shadow.4): ask the shadow map whether something nearer to the light hides this point.
  //   Given:  `world`; uLightClipFromWorld; constantBias(), a depth; comparison(), which compares at
  //           a place in the map (x and y) with a depth (z), all three from 0 to 1.
  //   Goal:   what the map doesn't show, beside it or behind the light, is lit.
  //   Expect: shadows on the floor and on the objects.             (shadow.md, step 4)
  return 1.0;
}

// 1 where the depth at.z is not beyond the map's at at.xy, 0 where it is; between, at an edge.
float comparison(vec3 at) {
  // TODO(shadow.5): bonus: if uPcfRadius > 0, the mean over (2 * uPcfRadius + 1)^2 neighbouring texels.
  //   Expect: soft edges of shadows.                               (shadow.md, step 5)
  return texture(uShadowMap, at);
}

// TODO(shadow.6): bonus: no constant bias, unless uShadowBias is 1.
//   Given:  if uShadowBias is 3, a point of a surface to be moved off it, along its normal, by more
//           where the light grazes. A texel there is uShadowTexel * (clip space w) wide.
//           If it is 2, see shadow.hpp.
//   Expect: no stripes where light grazes.                         (shadow.md, step 6)
vec3 offset(vec3 world, vec3 normal) {
  return world;
}

float constantBias() {
  return 0.004;
}
