// How much of the light reaches a point: the comparison with the shadow map.

uniform bool uShadow;                // is there a shadow map to ask?
uniform mat4 uLightClipFromWorld;    // the light's projection and view
uniform sampler2DShadow uShadowMap;  // what the pass "shadow" drew
uniform vec3 uLightWorld;            // the light's position, world space
uniform int uShadowBias;             // quality.shadow_bias
uniform int uPcfRadius;              // quality.pcf_radius
uniform float uShadowTexel;          // side of a map's texel, one unit away from the light

// 1 where the light is seen, 0 in shadow.
//   world: a point of a surface;  normal: of the surface, unit length; both in world space
float visibility(vec3 world, vec3 normal) {
  if (!uShadow) return 1.0;
  // TODO(shadow.4): ask the shadow map whether something nearer to the light hides this point.
  //   Given:  `world`, uLightClipFromWorld and uShadowMap.
  //   Do:     to the light's clip space, divide by w, from -1..1 to 0..1. What lies behind the light
  //           (w <= 0) or outside the map is lit. texture() of a sampler2DShadow compares: it gives 1
  //           where your depth, less a small bias, is not beyond the map's.
  //   Expect: shadows on the floor and on the objects.             (shadow.md, step 4)
  // TODO(shadow.6): bonus: no constant bias. If uShadowBias is 3, move the point off its surface along
  //   `normal`, by more where the light grazes, before all else. A texel there is uShadowTexel * (clip
  //   space w) wide. If it is 2, glPolygonOffset while the map is drawn (floor.cpp).
  // Then TODO(shadow.4) goes on.
  // TODO(shadow.5): bonus: if uPcfRadius > 0, the mean over (2 * uPcfRadius + 1)^2 neighbouring texels.
  // Then TODO(shadow.4) goes on.
  return 1.0;
}
