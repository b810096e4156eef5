// What every pass may ask the G-buffer. Pixels are the window's, (0, 0) at the bottom left.

uniform sampler2D uDepth;
uniform sampler2D uNormals; // eye space, unit length; 0 where there is nothing
uniform mat4 uProjection;   // clip from eye
uniform float uRadius;      // ao.radius: how far what keeps light out may be away, world units
uniform int uScale;         // how many of the window's pixels, in a row, share one of this pass's

// The window's pixel that a pixel of this pass stands for.
ivec2 windowPixel(ivec2 pixel) { return min(pixel * uScale, textureSize(uDepth, 0) - 1); }
ivec2 here() { return windowPixel(ivec2(gl_FragCoord.xy)); }

// Is there a surface, or only background?
bool covered(ivec2 pixel) { return texelFetch(uDepth, pixel, 0).r < 1.0; }

vec3 normalAt(ivec2 pixel) { return texelFetch(uNormals, pixel, 0).xyz; }

// The surface seen at a pixel, eye space.
vec3 positionAt(ivec2 pixel) {
  vec3 position = vec3(0, 0, -1);
  // TODO(ssao.1): undo the projection.
  //   Given:  `pixel`, uDepth, uProjection.
  //   Do:     the pixel's middle and its depth are window coordinates, from 0 to 1 if the middle is
  //           divided by the window's size; made -1 to 1 they are normalised device coordinates
  //           (x, y, z). The distance along the eye's axis is P[3][2] / (z + P[2][2]); with it,
  //           x and y times it and divided by P[0][0] and P[1][1]. The eye looks along -z.
  //   Expect: waves of colour on all surfaces, with "debug": { "picture": 2 }.  (README.md, step 1)
  return position;
}

// The pixel that shows a point of eye space in front of the eye; it may lie outside the window.
ivec2 pixelOf(vec3 point) {
  vec2 ndc = vec2(uProjection[0][0] * point.x, uProjection[1][1] * point.y) / -point.z;
  return ivec2(floor((0.5 + 0.5 * ndc) * vec2(textureSize(uDepth, 0))));
}

bool inWindow(ivec2 pixel) {
  return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, textureSize(uDepth, 0)));
}

// How much the surface at a pixel goes on smoothly from a position with a normal: 1 if it lies in
// its plane, 0 from a tenth of uRadius off it, or if there is none. (Not the difference of depths:
// on a ground seen at a low angle neighbours have very different ones.)
float sameSurface(ivec2 pixel, vec3 position, vec3 normal) {
  if (!covered(pixel)) return 0.0;
  return max(1.0 - abs(dot(positionAt(pixel) - position, normal)) / max(0.1 * uRadius, 1e-20), 0.0);
}
