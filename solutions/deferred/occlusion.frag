#version 410 core
// Picture 5: how much of the half space above a surface is open, judged by the depths around it.
// 1: all of it.

#include "figure.glsl"

uniform int uSamples;  // quality.ao_samples
uniform float uRadius; // quality.ao_radius, world units

layout(location = 0) out float oOpen;

// Point i of uSamples in the upper half of a ball of radius 1, z up. Seen from above they are spread
// evenly over a disc (Vogel's spiral), so that those straight up count most, as they do for light.
// The 16 pixels of a square of 4 x 4 test other points each; occluded.frag takes their mean.
vec3 inHemisphere(int i) {
  int k = 4 * (here().y & 3) + (here().x & 3);
  float share = (float(i) + 0.5) / float(uSamples), turn = 2.3999632 * float(i) + 0.3926991 * float(k);
  vec3 to = vec3(sqrt(share) * vec2(cos(turn), sin(turn)), sqrt(1.0 - share));
  return to * fract(0.7548777 * float(i) + (float(k * 7 & 15) + 0.5) / 16.0);
}

// Turns z into `axis` (of unit length).
mat3 frame(vec3 axis) {
  vec3 side = normalize(cross(abs(axis.x) < 0.5 ? vec3(1, 0, 0) : vec3(0, 1, 0), axis));
  return mat3(side, cross(axis, side), axis);
}

// The pixel that shows a point of eye space; z of it is negative.
ivec2 pixelOf(vec3 point) {
  vec2 ndc = vec2(uProjection[0][0] * point.x, uProjection[1][1] * point.y) / -point.z;
  return ivec2(floor((0.5 + 0.5 * ndc) * vec2(textureSize(uIds, 0))));
}

bool inPicture(ivec2 pixel) {
  return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, textureSize(uIds, 0)));
}

void main() {
  float open = 1.0;
  if (covered(here())) {
    float own = distanceAt(here());
    vec3 position = own * eyeRay(here());              // eye space
    mat3 turned = frame(mat3(uView) * normalAt(here())); // eye space from the hemisphere's
    // TODO(figure.4): how many of uSamples points about `position` are hidden behind something?
    //   Given:  position, own, turned, uRadius; inHemisphere(i), pixelOf(point), inPicture(pixel),
    //           covered(pixel), distanceAt(pixel).
    //   Goal:   a point, up to uRadius away, is hidden if another pixel than here() shows a surface
    //           there that is nearer to the eye than the point, by more than 2% of uRadius (depths
    //           are rounded), and not much nearer than `own`: they differ by less than uRadius.
    //           `open` is the share of all points that are not hidden.
    //   Expect: dark creases.                                              (figure.md, step 4)
    // BEGIN SOLUTION(figure.4)
    int hidden = 0;
    for (int i = 0; i < uSamples; ++i) {
      vec3 point = position + uRadius * (turned * inHemisphere(i));
      if (point.z >= 0.0) continue; // behind the eye
      ivec2 at = pixelOf(point);
      if (!inPicture(at) || at == here() || !covered(at)) continue;
      float seen = distanceAt(at);
      if (seen < -point.z - 0.02 * uRadius && abs(seen - own) < uRadius) ++hidden;
    }
    if (uSamples > 0) open = 1.0 - float(hidden) / float(uSamples);
    // END SOLUTION(figure.4)
  }
  oOpen = open;
}
