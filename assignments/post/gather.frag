#version 410 core
// Motion blur that reaches beyond the outline of what moves: each pixel looks along the longest
// velocity nearby for what may have passed before it (McGuire et al. 2012).

uniform sampler2D uColor; // linear light
uniform sampler2D uVelocity;
uniform sampler2D uDepth;
uniform sampler2D uNeighbours; // the longest velocity of each tile and those around it
uniform mat4 uProjection;      // clip from eye
uniform float uShutter;        // share of the time between two frames during which it is open
uniform int uSamples;
uniform float uLongest; // of a blur, and a tile's side, pixels

layout(location = 0) out vec4 oColor;

// How much farther away something may be and still count as at the same distance, as a share.
const float kSoft = 0.02;

vec2 size = vec2(textureSize(uColor, 0));

// Half of the path while the shutter is open, pixels.
vec2 halfPath(vec2 velocity) {
  vec2 path = 0.5 * uShutter * velocity * size;
  return path * min(1.0, 0.5 * uLongest / max(length(path), 1e-6));
}

// How far away the scene is at a pixel, world units.
float distanceAt(ivec2 pixel) {
  float z = 2.0 * texelFetch(uDepth, pixel, 0).r - 1.0;
  return uProjection[3][2] / (z + uProjection[2][2]);
}

// 1 where a is nearer than b, 0 where it is clearly farther away.
float before(float a, float b) {
  return clamp(1.0 - (a - b) / (kSoft * min(a, b)), 0.0, 1.0);
}

// 1 for what moves by `reach` pixels to either side and gets as far as `away`, else 0.
float arrives(float away, float reach) {
  return 1.0 - smoothstep(0.95 * reach, 1.05 * reach, away);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  oColor = texelFetch(uColor, pixel, 0);
  vec2 path = halfPath(texelFetch(uNeighbours, pixel / int(uLongest), 0).xy);
  if (length(path) < 0.25) return; // nothing nearby moves: exactly what it was

  float own = max(length(halfPath(texelFetch(uVelocity, pixel, 0).xy)), 0.5);
  float depth = distanceAt(pixel);
  vec3 sum = vec3(0);
  for (int i = 0; i < uSamples; ++i) {
    vec2 offset = path * (2.0 * (float(i) + 0.5) / float(uSamples) - 1.0);
    ivec2 there = ivec2(floor(gl_FragCoord.xy + offset));
    there = clamp(there, ivec2(0), ivec2(size) - 1);
    float away = length(offset);
    float reach = max(length(halfPath(texelFetch(uVelocity, there, 0).xy)), 0.5);
    float other = distanceAt(there);
    // Each sample stands for a moment. Then what is there had come here, in front; or what is here
    // had gone so far that one sees what is behind it, which looks as it does there.
    float seen = before(other, depth) * arrives(away, reach) +
                 before(depth, other) * arrives(away, own);
    sum += mix(oColor.rgb, texelFetch(uColor, there, 0).rgb, min(seen, 1.0));
  }
  oColor.rgb = sum / float(uSamples);
}
