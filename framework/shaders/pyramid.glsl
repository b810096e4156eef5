// Filters between the levels of a pyramid, a row of pictures each half as large as the one before.
//
// Level sizes are halved and rounded down, so two levels need not be 2 to 1 apart: 45 pixels become
// 22. The area filter weighs every source pixel by its share of the tent (the linear B-spline, two
// target pixels wide) about a target pixel. With mirrored edges these weights conserve energy both
// ways at every size; at 2 to 1 they are the four bilinear samples at +-0.75 texels, and the plain
// bilinear sample on the way up.
//
//   filter  0  5 x 5 binomial, up: bilinear
//           1  dual filter: 5 samples down, 8 up (Bjorge, Bandwidth-Efficient Rendering, 2015)
//           2  13 samples down, 3 x 3 tent up (Jimenez, Next Generation Post Processing, 2014)
//           3  area-weighted tent
//
// The sampler must filter linearly; its wrap mode is the edge rule.
//
// Written for software renderers, too, which run both sides of an `if`, and the body of a `for` once
// more for nothing: how many samples a filter takes is the length of a do-while loop.

// Integral of the tent max(1 - |x|, 0) from minus infinity to x.
vec4 tentArea(vec4 x) {
  x = clamp(x, -1.0, 1.0);
  return 0.5 + x - 0.5 * x * abs(x);
}
float tentArea(float x) { return tentArea(vec4(x)).x; }

// Bilinear samples along one axis: neighbouring texels share one.
struct Taps {
  int count;   // 1 to 4
  vec4 at;     // texture coordinates, 0 to 1
  vec4 weight; // they add up to 1
};

// For target pixel i of `to`, from a level of `from` texels, `from` >= `to`. Up to three to one.
Taps downTaps(float i, float from, float to) {
  float ratio = from / to, centre = (i + 0.5) * ratio;
  float start = floor(centre - ratio), end = ceil(centre + ratio);
  vec4 texel = start + vec4(0, 2, 4, 6); // and the one after it
  vec4 between = tentArea((texel + 1.0 - centre) / ratio);
  vec4 first = between - tentArea((texel - centre) / ratio);
  vec4 second = tentArea((texel + 2.0 - centre) / ratio) - between;
  vec4 weight = first + second;
  return Taps(int(ceil(0.5 * (end - start))),
              (texel + 0.5 + second / max(weight, 1e-9)) / from, weight);
}

// For target pixel i of `to`, from a level of `from` texels, `from` <= `to`: the transpose.
Taps upTaps(float i, float from, float to) {
  float low = i * from / to, high = (i + 1.0) * from / to;
  float start = floor(low - 0.5), end = ceil(high + 0.5);
  vec4 texel = start + vec4(0, 1, 2, 3);
  vec4 single = (tentArea(high - texel - 0.5) - tentArea(low - texel - 0.5)) * (to / from);
  vec2 weight = single.xz + single.yw;
  vec2 at = (texel.xz + 0.5 + single.yw / max(weight, 1e-9)) / from;
  return Taps(int(ceil(0.5 * (end - start))), at.xyxy, vec4(weight, 0, 0));
}

// A sample of a filter that is a product: texture coordinates and weight.
vec3 product(Taps x, Taps y, int i, int j) {
  return vec3(x.at[i], y.at[j], x.weight[i] * y.weight[j]);
}

// Sample i of row j of another filter of the way down: offset in texels of the source, and weight.
vec3 downTap(int filterKind, int i, int j) {
  const float binomial[5] = float[](1.0, 4.0, 6.0, 4.0, 1.0);
  vec2 corner = vec2((i & 1) * 2 - 1, (i & 2) - 1); // samples 0 to 3
  if (filterKind == 0) return vec3(i - 2, j - 2, binomial[i] * binomial[j] / 256.0);
  if (filterKind == 1) return i < 4 ? vec3(corner, 0.125) : vec3(0, 0, 0.5);
  // Five overlapping 2 x 2 boxes of samples: the middle one weighs 1/2, the others 1/8 each. Rows of
  // 3, 2, 3, 2, 3.
  vec2 offset = vec2(2 * i - 2 + (j & 1), j - 2);
  float share = (i == 1 ? 2.0 : 1.0) * (j == 2 ? 2.0 : 1.0) / 32.0;
  return vec3(offset, (j & 1) == 1 ? 0.125 : share);
}

// The same of the way up.
vec3 upTap(int filterKind, int i, int j) {
  vec2 corner = vec2((i & 1) * 2 - 1, (i & 2) - 1);
  vec2 axis = vec2(i == 4 ? 1 : i == 5 ? -1 : 0, i == 6 ? 1 : i == 7 ? -1 : 0);
  if (filterKind == 0) return vec3(0, 0, 1);
  if (filterKind == 1) return i < 4 ? vec3(0.5 * corner, 2.0 / 12.0) : vec3(axis, 1.0 / 12.0);
  return vec3(i - 1, j - 1, (i == 1 ? 2.0 : 1.0) * (j == 1 ? 2.0 : 1.0) / 16.0);
}

// This pixel of a level of `size` pixels, from the next larger level.
vec3 downsample(sampler2D source, vec2 size, int filterKind) {
  vec2 from = vec2(textureSize(source, 0));
  vec2 pixel = floor(gl_FragCoord.xy), at = gl_FragCoord.xy / size;
  Taps x = downTaps(pixel.x, from.x, size.x), y = downTaps(pixel.y, from.y, size.y);
  int rows = filterKind == 3 ? y.count : filterKind == 1 ? 1 : 5;
  vec3 sum = vec3(0);
  int j = 0;
  do {
    int count = filterKind == 3 ? x.count : filterKind == 2 ? 3 - (j & 1) : 5;
    int i = 0;
    do {
      vec3 tap = downTap(filterKind, i, j);
      tap.xy = at + tap.xy / from;
      if (filterKind == 3) tap = product(x, y, i, j);
      sum += tap.z * textureLod(source, tap.xy, 0.0).rgb;
    } while (++i < count);
  } while (++j < rows);
  return sum;
}

// This pixel of a level of `size` pixels, from the next smaller level.
vec3 upsample(sampler2D source, vec2 size, int filterKind) {
  vec2 from = vec2(textureSize(source, 0));
  vec2 pixel = floor(gl_FragCoord.xy), at = gl_FragCoord.xy / size;
  Taps x = upTaps(pixel.x, from.x, size.x), y = upTaps(pixel.y, from.y, size.y);
  int rows = filterKind == 3 ? y.count : filterKind == 2 ? 3 : 1;
  int count = filterKind == 3 ? x.count : filterKind == 2 ? 3 : filterKind == 1 ? 8 : 1;
  vec3 sum = vec3(0);
  int j = 0;
  do {
    int i = 0;
    do {
      vec3 tap = upTap(filterKind, i, j);
      tap.xy = at + tap.xy / from;
      if (filterKind == 3) tap = product(x, y, i, j);
      sum += tap.z * textureLod(source, tap.xy, 0.0).rgb;
    } while (++i < count);
  } while (++j < rows);
  return sum;
}

// A colour that can be added and filtered: NaN and what is below 0 become 0, what a half float can't
// hold becomes its largest, 65504. One bad pixel would spread over the whole picture otherwise.
vec3 finite(vec3 color) {
  return vec3(color.r > 0.0 ? min(color.r, 65504.0) : 0.0,
              color.g > 0.0 ? min(color.g, 65504.0) : 0.0,
              color.b > 0.0 ? min(color.b, 65504.0) : 0.0);
}

// Texel `at` of `size`, or the one that is mirrored there beyond the edges.
int mirrored(int at, int size) {
  at = max(at, -1 - at);
  return clamp(min(at, 2 * size - 1 - at), 0, size - 1);
}

// As downsample() with the area filter, but each texel is made finite before it is weighed, which a
// bilinear sample can't do. Edges are mirrored.
vec3 downsampleFinite(sampler2D source, vec2 size) {
  ivec2 from = textureSize(source, 0);
  vec2 ratio = vec2(from) / size, centre = gl_FragCoord.xy * ratio;
  vec2 at = floor(centre - ratio), end = ceil(centre + ratio);
  float start = at.x, below = 0.0;
  vec3 sum = vec3(0);
  do {
    int y = mirrored(int(at.y), from.y);
    vec3 row = vec3(0);
    float left = 0.0;
    at.x = start;
    do {
      vec3 color = finite(texelFetch(source, ivec2(mirrored(int(at.x), from.x), y), 0).rgb);
      float right = tentArea((++at.x - centre.x) / ratio.x);
      row += (right - left) * color;
      left = right;
    } while (at.x < end.x);
    float above = tentArea((++at.y - centre.y) / ratio.y);
    sum += (above - below) * row;
    below = above;
  } while (at.y < end.y);
  return sum;
}
