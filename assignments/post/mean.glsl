// What a pixel's four samples come to. Before: SAMPLES, a type of sampler, and
//   vec4 sampleOf(SAMPLES samples, ivec2 pixel, int i)

uniform SAMPLES uColor; // linear light
uniform SAMPLES uDepth;
uniform SAMPLES uVelocity;
uniform bool uHasVelocity;

layout(location = 0) out vec4 oColor;    // linear light
layout(location = 1) out vec2 oVelocity; // that of the nearest sample, as is the depth

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  // The light L of which tone.frag shows the mean of what it would show of the samples' light:
  // exp(-L) is the mean of exp(-light). A mean of light itself would let one sample of a lamp
  // decide for all. Less what all have, so that no exponential vanishes.
  vec3 least = sampleOf(uColor, pixel, 0).rgb;
  int nearest = 0;
  float depth = sampleOf(uDepth, pixel, 0).r;
  for (int i = 1; i < 4; ++i) {
    least = min(least, sampleOf(uColor, pixel, i).rgb);
    float other = sampleOf(uDepth, pixel, i).r;
    if (other < depth) {
      depth = other;
      nearest = i;
    }
  }
  vec3 sum = vec3(0);
  for (int i = 0; i < 4; ++i) sum += exp(least - sampleOf(uColor, pixel, i).rgb);
  oColor = vec4(least - log(sum / 4.0), 1);
  oVelocity = uHasVelocity ? sampleOf(uVelocity, pixel, nearest).rg : vec2(0);
  gl_FragDepth = depth;
}
