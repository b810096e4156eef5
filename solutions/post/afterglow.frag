#version 410 core
// What is bright goes on glowing for a while, as on an old screen.

uniform sampler2D uColor; // linear light, of this frame
uniform sampler2D uGlow;  // what the last frame left
uniform float uDecay;     // what is left of that

layout(location = 0) out vec4 oColor;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 now = texelFetch(uColor, pixel, 0).rgb;
  vec3 last = texelFetch(uGlow, pixel, 0).rgb;
  oColor = vec4(now, 1);
  // TODO(afterglow.2): the brighter one, of each colour, of this frame and of what is left.
  //   Given:  `now`, `last`, uDecay.
  //   Expect: the lamp draws a trail behind it.                           (afterglow.md, step 2)
  // BEGIN SOLUTION(afterglow.2)
  oColor.rgb = max(now, uDecay * last);
  // END SOLUTION(afterglow.2)
}
