// The occlusion at a pixel of the window. Include gbuffer.glsl first.

uniform sampler2D uOcclusion;
uniform bool uHasOcclusion; // is there any in this scene?

// Where it was found for every other pixel, between the four nearest: as a bilinear sample, but
// surfaces other than this pixel's count next to nothing.
float openAt(ivec2 pixel) {
  if (!uHasOcclusion || !covered(pixel)) return 1.0;
  ivec2 first = pixel / uScale, last = textureSize(uOcclusion, 0) - 1;
  if (uScale == 1) return texelFetch(uOcclusion, first, 0).r;
  vec3 position = positionAt(pixel), normal = normalAt(pixel);
  vec2 part = vec2(pixel) / float(uScale) - vec2(first);
  float sum = 0.0, weights = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 corner = ivec2(i & 1, i >> 1), at = min(first + corner, last);
    vec2 share = mix(1.0 - part, part, vec2(corner));
    float weight = share.x * share.y * (sameSurface(windowPixel(at), position, normal) + 1e-4);
    sum += weight * texelFetch(uOcclusion, at, 0).r;
    weights += weight;
  }
  return sum / weights;
}
