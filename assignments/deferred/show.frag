#version 410 core
// One of the figure's pictures, as the window shows it.

#include "figure.glsl"

uniform int uPicture;   // 1 to 13
uniform vec4 uViewport; // left, bottom, width, height: what is drawn into, pixels
uniform vec2 uRange;    // distances of the near and far planes

layout(location = 0) out vec4 oColor;

// The one place where light becomes what a display shows: what is brighter than 1 is cut off, then
// the sRGB curve (IEC 61966-2-1).
vec3 display(vec3 light) {
  vec3 cut = min(light, 1.0);
  return mix(12.92 * cut, 1.055 * pow(cut, vec3(1.0 / 2.4)) - 0.055, greaterThan(cut, vec3(0.0031308)));
}

void main() {
  vec2 at = (gl_FragCoord.xy - uViewport.xy) / uViewport.zw; // 0 to 1
  ivec2 pixel = ivec2(at * vec2(textureSize(uIds, 0)));
  vec2 all = vec2(at.x, 1.0 - at.y); // of a map of all directions: +y is on top
  vec3 color = vec3(0);
  if (uPicture == 1 && covered(pixel)) color = 0.5 + 0.5 * normalAt(pixel);
  if (uPicture == 2) color = display(textureLod(uIrradianceMap, all, 0.0).rgb / (2.0 * kPi));
  if (uPicture == 3) color = display(vec3(distanceAt(pixel) - uRange.x) / (uRange.y - uRange.x));
  if (uPicture == 4) color = display(texelFetch(uIrradiance, pixel, 0).rgb / (2.0 * kPi));
  if (uPicture == 5) color = texelFetch(uOcclusion, pixel, 0).rrr;
  if (uPicture == 6) color = display(texelFetch(uOccluded, pixel, 0).rgb / (2.0 * kPi));
  if (uPicture == 7) color = display(texelFetch(uAlbedo, pixel, 0).rgb);
  if (uPicture == 8) color = display(texelFetch(uDiffuse, pixel, 0).rgb);
  if (uPicture == 9 && covered(pixel)) color = 0.5 + 0.5 * decode(texelFetch(uReflected, pixel, 0));
  if (uPicture == 10) color = display(textureLod(uEnvironment, all, 0.0).rgb);
  if (uPicture == 11) color = texelFetch(uFresnel, pixel, 0).rgb;
  if (uPicture == 12) color = display(texelFetch(uReflection, pixel, 0).rgb);
  if (uPicture == 13) color = display(texelFetch(uComposition, pixel, 0).rgb);
  oColor = vec4(color, 1);
}
