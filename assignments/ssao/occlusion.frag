#version 410 core
// How much of the half space above each surface is open to light from all sides.

#include "gbuffer.glsl"

uniform int uMethod;  // quality.method
uniform int uSamples; // quality.samples, of each pixel

layout(location = 0) out float oOpen;

const float kPi = 3.14159265;

// A number for each pixel of a square of 4 x 4, from 0 to 15/16.
float dither() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) & 3;
  return float(pixel.x + 4 * pixel.y) / 16.0;
}

// Point i of uSamples in the upper half of a ball of radius 1, z up.
//   turn: a share of a full turn by which all are turned about z
vec3 inHemisphere(int i, float turn) {
  vec3 point = vec3(0);
  // TODO(ssao.2): spread the points over the half ball: their directions as densely as the cosine
  //   with which light from there counts, their lengths evenly from 0 to 1, in no order that the
  //   directions have, too.
  //   Given:  i, uSamples, turn, kPi. Two sequences that do it stand in the handout.
  //   Expect: nothing yet: the points are counted below.                    (README.md, step 2)
  return point;
}

// Turns z into `axis` (of unit length).
mat3 frame(vec3 axis) {
  vec3 side = normalize(cross(abs(axis.x) < 0.5 ? vec3(1, 0, 0) : vec3(0, 1, 0), axis));
  return mat3(side, cross(axis, side), axis);
}

// May what is seen at `seen` keep light from `position`, or is it too far away? 1 to 0.
float inRange(vec3 seen, vec3 position) {
  float range = 1.0;
  // TODO(ssao.3): 1 up to uRadius away from each other, 0 from twice that, evenly less between.
  //   Expect: no dark seams around what stands before something far away.   (README.md, step 3)
  return range;
}

// The share of uSamples points about the surface that aren't hidden behind what the eye sees.
float openByPoints(vec3 position, vec3 normal) {
  float hidden = 0.0;
  // Then TODO(ssao.2) counts the points that are.
  //   Given:  frame(normal), inHemisphere(i, dither()), uRadius, pixelOf(point), inWindow(pixel),
  //           covered(pixel), positionAt(pixel), inRange(seen, position).
  //   Goal:   of the points about `position`, up to uRadius away, those that what is seen at their
  //           pixel hides: it is nearer to the eye, and more than a hundredth of uRadius above the
  //           surface's plane. Each counts as much as inRange says. What can't be known is open.
  //   Expect: dark and grainy where surfaces meet, with "debug": { "picture": 3 } and
  //           "quality": { "blur": 0 }.                                     (README.md, step 2)
  return 1.0 - hidden / float(uSamples);
}

// The same by horizons: in some directions over the window, how far up is the view blocked?
float openByHorizons(vec3 position, vec3 normal) {
  float hidden = 0.0;
  // TODO(ssao.6): bonus: see the handout.
  //   Expect: the same picture, smoother and nearer to the truth, with "quality": { "method": 1 }.
  return 1.0 - hidden;
}

void main() {
  oOpen = 1.0;
  if (!covered(here())) return;
  vec3 position = positionAt(here()), normal = normalAt(here());
  oOpen = uMethod == 1 ? openByHorizons(position, normal) : openByPoints(position, normal);
}
