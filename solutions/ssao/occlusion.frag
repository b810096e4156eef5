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
  // BEGIN SOLUTION(ssao.2)
  float share = (float(i) + 0.5) / float(uSamples), angle = 2.3999632 * float(i) + 2.0 * kPi * turn;
  vec3 direction = vec3(sqrt(share) * vec2(cos(angle), sin(angle)), sqrt(1.0 - share));
  point = fract(0.7548777 * float(i) + 5.0 * turn + 1.0 / 32.0) * direction;
  // END SOLUTION(ssao.2)
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
  // BEGIN SOLUTION(ssao.3)
  range = clamp(2.0 - length(seen - position) / uRadius, 0.0, 1.0);
  // END SOLUTION(ssao.3)
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
  // BEGIN SOLUTION(ssao.2)
  mat3 turned = frame(normal);
  for (int i = 0; i < uSamples; ++i) {
    vec3 point = position + uRadius * (turned * inHemisphere(i, dither()));
    if (point.z >= 0.0) continue;
    ivec2 pixel = pixelOf(point);
    if (!inWindow(pixel) || !covered(pixel)) continue;
    vec3 seen = positionAt(pixel);
    if (seen.z > point.z && dot(seen - position, normal) > 0.01 * uRadius)
      hidden += inRange(seen, position);
  }
  // END SOLUTION(ssao.2)
  return 1.0 - hidden / float(uSamples);
}

// BEGIN SOLUTION(ssao.6)
// The integral of |sin a| cos(a - tilt) over the angle a from 0 to `angle` (at least 0).
float arc(float angle, float tilt) {
  return 0.25 * (cos(tilt) - cos(2.0 * angle - tilt) + 2.0 * angle * sin(tilt));
}
// END SOLUTION(ssao.6)

// The same by horizons: in some directions over the window, how far up is the view blocked?
float openByHorizons(vec3 position, vec3 normal) {
  float hidden = 0.0;
  // TODO(ssao.6): bonus: see the handout.
  //   Expect: the same picture, smoother and nearer to the truth, with "quality": { "method": 1 }.
  // BEGIN SOLUTION(ssao.6)
  int slices = max(int(0.25 * sqrt(float(uSamples))), 1), steps = max(uSamples / (2 * slices), 1);
  vec3 toEye = -normalize(position);
  // The radius in pixels, as large as it would be if it were seen face on.
  float reach = 0.5 * uProjection[1][1] * float(textureSize(uDepth, 0).y) * uRadius / -position.z;
  for (int slice = 0; slice < slices; ++slice) {
    float angle = kPi * (float(slice) + dither()) / float(slices);
    vec2 across = vec2(cos(angle), sin(angle));
    // The slice is the plane through the eye that shows as this line. In it, angles count from
    // toEye towards `along`.
    vec3 along = normalize(vec3(across, 0) - toEye * dot(vec3(across, 0), toEye));
    float up = dot(normal, toEye), forward = dot(normal, along);
    for (int side = -1; side <= 1; side += 2) {
      float tilt = clamp(atan(float(side) * forward, up), -0.5 * kPi, 0.5 * kPi);
      float horizon = 0.5 * kPi + tilt; // of the surface itself
      float last = -1.0;                // distance of what raised it last, if anything has
      for (int i = 0; i < steps; ++i) {
        float part = (float(i) + fract(5.0 * dither() + 1.0 / 32.0)) / float(steps);
        vec2 at = vec2(here()) + 0.5 + float(side) * reach * part * part * across;
        ivec2 pixel = ivec2(floor(at));
        if (!inWindow(pixel) || pixel == here() || !covered(pixel)) continue;
        vec3 to = positionAt(pixel) - position;
        float far = length(to);
        if (far >= uRadius || dot(to, normal) <= 0.01 * far) continue;
        float seen = atan(length(to - toEye * dot(to, toEye)), dot(to, toEye));
        if (seen >= horizon) continue;
        float mean = last < 0.0 ? far : 0.5 * (last + far);
        hidden += (1.0 - mean / uRadius) * length(vec2(up, forward)) *
                  (arc(horizon, tilt) - arc(seen, tilt)) / float(slices);
        horizon = seen, last = far;
      }
    }
  }
  // END SOLUTION(ssao.6)
  return 1.0 - hidden;
}

void main() {
  oOpen = 1.0;
  if (!covered(here())) return;
  vec3 position = positionAt(here()), normal = normalAt(here());
  oOpen = uMethod == 1 ? openByHorizons(position, normal) : openByPoints(position, normal);
}
