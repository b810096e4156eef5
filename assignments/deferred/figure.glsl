// What all passes of the figure may read: a texture a unit, the camera, and what the G-buffer says
// of a pixel.

#include "encoding.glsl"

uniform usampler2D uIds;          // object and material; 0: nothing there
uniform sampler2D uNormals;       // 1  encoded, world space
uniform sampler2D uIrradianceMap; // 2  by normal
uniform sampler2D uDepth;         // 3
uniform sampler2D uIrradiance;    // 4
uniform sampler2D uOcclusion;     // 5
uniform sampler2D uOccluded;      // 6
uniform sampler2D uAlbedo;        // 7
uniform sampler2D uDiffuse;       // 8
uniform sampler2D uReflected;     // 9  encoded, world space
uniform sampler2D uEnvironment;   // 10 by direction
uniform sampler2D uFresnel;       // 11
uniform sampler2D uReflection;    // 12
uniform sampler2D uComposition;   // 13

uniform mat4 uProjection; // clip from eye
uniform mat4 uView;       // eye from world

const float kPi = 3.14159265;
// The largest half float: what is brighter would become infinity in a target of half floats.
const float kMost = 65504.0;

// This pixel of the pictures, which are as large as the window.
ivec2 here() { return ivec2(gl_FragCoord.xy); }

// Is there a surface?
bool covered(ivec2 pixel) { return texelFetch(uIds, pixel, 0).x != 0u; }

// Its normal, world space, unit length; means nothing where there is no surface.
vec3 normalAt(ivec2 pixel) { return decode(texelFetch(uNormals, pixel, 0)); }

// How far it is, along the eye's axis. What the projection did to z, undone.
float distanceAt(ivec2 pixel) {
  float z = 2.0 * texelFetch(uDepth, pixel, 0).r - 1.0;
  return uProjection[3][2] / (z + uProjection[2][2]);
}

// From the eye through the middle of a pixel, eye space; z is -1, so that a surface lies at
// distance times this.
vec3 eyeRay(ivec2 pixel) {
  vec2 ndc = 2.0 * (vec2(pixel) + 0.5) / vec2(textureSize(uIds, 0)) - 1.0;
  return vec3(ndc.x / uProjection[0][0], ndc.y / uProjection[1][1], -1);
}

// The direction in which the eye looks through a pixel, world space, unit length.
vec3 viewDirection(ivec2 pixel) {
  return direction(transpose(mat3(uView)) * eyeRay(pixel)); // a view doesn't stretch
}

// Where a direction lies in a map of all directions: u turns to the right, -z in the middle; v goes
// down from +y.
vec2 equirectangular(vec3 to) {
  return vec2(0.5 + atan(to.x, -to.z) / (2.0 * kPi), acos(clamp(to.y, -1.0, 1.0)) / kPi);
}

// Such a map's value, linear between texels. Beyond the middle of the outermost row the map goes on
// across the pole, on the other side: level ground faces the pole itself.
// (textureLod: at the map's seam the coordinates jump, and a lookup that chooses its level by their
// differences would draw a line there.)
vec3 lookUp(sampler2D map, vec3 to) {
  vec2 at = equirectangular(to);
  float across = max(0.5 - min(at.y, 1.0 - at.y) * float(textureSize(map, 0).y), 0.0);
  return mix(textureLod(map, at, 0.0).rgb, textureLod(map, at + vec2(0.5, 0), 0.0).rgb, across);
}
