#version 410 core
// The picture as a camera sees it whose shutter is open for a while.

uniform sampler2D uColor; // linear light; a linear filter
uniform sampler2D uVelocity;
uniform float uShutter; // share of the time between two frames during which it is open
uniform int uSamples;
uniform float uLongest; // of a blur, pixels

layout(location = 0) out vec4 oColor;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec2 size = vec2(textureSize(uColor, 0));
  vec2 uv = gl_FragCoord.xy / size;
  vec2 path = uShutter * texelFetch(uVelocity, pixel, 0).xy; // while the shutter is open
  float pixels = length(path * size);
  path *= min(1.0, uLongest / max(pixels, 1e-6));
  oColor = texelFetch(uColor, pixel, 0);
  if (pixels < 0.5) return; // at rest: exactly what it was
  // TODO(motion_blur.2): the mean of uSamples colours along the path.
  //   Given:  `uv`, `path`, uColor, uSamples.
  //   Goal:   the path's middle is this pixel, and every sample the middle of its share of it.
  //   Expect: what moves is blurred, as long at 4 samples as at 64.       (motion_blur.md, step 2)
  // BEGIN SOLUTION(motion_blur.2)
  vec3 sum = vec3(0);
  for (int i = 0; i < uSamples; ++i)
    sum += texture(uColor, uv + path * ((float(i) + 0.5) / float(uSamples) - 0.5)).rgb;
  oColor.rgb = sum / float(uSamples);
  // END SOLUTION(motion_blur.2)
}
