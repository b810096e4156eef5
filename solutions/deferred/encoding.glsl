// How directions are kept in a texture: quality.normal.
//   0 as they are (floats)          1, 3 octahedral, two numbers (16, 8 bits)
//   2 (direction + 1) / 2 (10 bits)

#include "gg/lighting.glsl" // direction()

uniform int uEncoding; // quality.normal

// Onto the octahedron |x| + |y| + |z| = 1, whose lower half is folded out over the corners of the
// square that its upper half fills (Meyer et al., "On floating-point normal vectors", 2010).
vec2 octahedral(vec3 unit) {
  vec3 on = unit / (abs(unit.x) + abs(unit.y) + abs(unit.z));
  vec2 folded = (1.0 - abs(on.yx)) * vec2(on.x < 0.0 ? -1 : 1, on.y < 0.0 ? -1 : 1);
  return on.z < 0.0 ? folded : on.xy;
}

// unit: of unit length
vec4 encode(vec3 unit) {
  if (uEncoding == 0) return vec4(unit, 0);
  if (uEncoding == 2) return vec4(0.5 + 0.5 * unit, 1);
  return vec4(0.5 + 0.5 * octahedral(unit), 0, 1);
}

// Of unit length, unless nothing was written: where a texture with 0 as they are was cleared to 0,
// there is no direction, and normalising it would give NaN.
vec3 decode(vec4 stored) {
  if (uEncoding == 0) return direction(stored.xyz);
  vec3 on = 2.0 * stored.xyz - 1.0;
  if (uEncoding == 2) return direction(on);
  on.z = 1.0 - abs(on.x) - abs(on.y);
  float fold = max(-on.z, 0.0);
  on.xy -= fold * vec2(on.x < 0.0 ? -1 : 1, on.y < 0.0 ? -1 : 1);
  return direction(on);
}
