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
  // BEGIN SOLUTION(shadow.4)
  float bias = 0.004;
  // END SOLUTION(shadow.4)
  // TODO(shadow.6): bonus: no constant bias. If uShadowBias is 3, move the point off its surface along
  //   `normal`, by more where the light grazes, before all else. A texel there is uShadowTexel * (clip
  //   space w) wide. If it is 2, glPolygonOffset while the map is drawn (floor.cpp).
  // BEGIN SOLUTION(shadow.6)
  if (uShadowBias != 1) bias = 0.0;
  if (uShadowBias == 3) {
    vec3 toLight = normalize(uLightWorld - world);
    float cosine = clamp(dot(normal, toLight), 0.0, 1.0);
    float texel = uShadowTexel * (uLightClipFromWorld * vec4(world, 1)).w;
    float reach = float(uPcfRadius) + 1.5;
    world += texel * reach * (normal * sqrt(1.0 - cosine * cosine) + 0.2 * toLight);
  }
  // END SOLUTION(shadow.6)
  // Then TODO(shadow.4) goes on.
  // BEGIN SOLUTION(shadow.4)
  vec4 clip = uLightClipFromWorld * vec4(world, 1);
  if (clip.w <= 0.0) return 1.0;
  vec3 at = clip.xyz / clip.w * 0.5 + 0.5;
  if (any(lessThan(at.xy, vec2(0))) || any(greaterThan(at.xy, vec2(1)))) return 1.0;
  // Beyond the far plane the map's 1 still means that nothing is there: a format that doesn't clamp
  // by itself (32 bit float) would find a shadow.
  at.z = clamp(at.z - bias, 0.0, 1.0);
  // END SOLUTION(shadow.4)
  // TODO(shadow.5): bonus: if uPcfRadius > 0, the mean over (2 * uPcfRadius + 1)^2 neighbouring texels.
  // BEGIN SOLUTION(shadow.5)
  if (uPcfRadius > 0) {
    vec2 texel = 1.0 / vec2(textureSize(uShadowMap, 0));
    float sum = 0.0;
    for (int y = -uPcfRadius; y <= uPcfRadius; ++y)
      for (int x = -uPcfRadius; x <= uPcfRadius; ++x)
        sum += texture(uShadowMap, vec3(at.xy + vec2(x, y) * texel, at.z));
    return sum / float((2 * uPcfRadius + 1) * (2 * uPcfRadius + 1));
  }
  // END SOLUTION(shadow.5)
  // Then TODO(shadow.4) goes on.
  // BEGIN SOLUTION(shadow.4)
  return texture(uShadowMap, at);
  // END SOLUTION(shadow.4)
  return 1.0;
}
