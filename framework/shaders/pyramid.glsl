// Filters between the levels of a pyramid, a row of pictures each half as large as the one before.
//
// Level sizes are halved and rounded down, so two levels need not be 2 to 1 apart: 45 pixels become
// 22. The area filter weighs every source pixel by its share of the tent (the linear B-spline, two
// target pixels wide) about a target pixel. With mirrored edges these weights conserve energy both
// ways at every size; at 2 to 1 they are the four bilinear samples at +-0.75 texels, and the plain
// bilinear sample on the way up.
//
//   filter  0  5 x 5 binomial (the lecture's), up: bilinear
//           1  dual filter: 5 samples down, 8 up (Bjorge, Bandwidth-Efficient Rendering, 2015)
//           2  13 samples down, 3 x 3 tent up (Jimenez, Next Generation Post Processing, 2014)
//           3  area-weighted tent
//
// The sampler must filter linearly; its wrap mode is the edge rule.

// Integral of the tent max(1 - |x|, 0) from minus infinity to x.
float tentArea(float x) {
  x = clamp(x, -1.0, 1.0);
  return x < 0.0 ? 0.5 * (1.0 + x) * (1.0 + x) : 1.0 - 0.5 * (1.0 - x) * (1.0 - x);
}

// Bilinear samples along one axis: neighbouring texels share one.
struct Taps {
  int count;
  float at[4];     // texture coordinate, 0 to 1
  float weight[4]; // they add up to 1
};

void addTap(inout Taps taps, float texel, float first, float second, float size) {
  if (first + second <= 0.0) return;
  taps.at[taps.count] = (texel + 0.5 + second / (first + second)) / size;
  taps.weight[taps.count++] = first + second;
}

// Weight of source texel j for a target pixel whose centre lies at `centre` (texels), at `ratio`
// texels a pixel.
float downWeight(float j, float centre, float ratio) {
  return tentArea((j + 1.0 - centre) / ratio) - tentArea((j - centre) / ratio);
}

// For target pixel i of `to`, from a level of `from` texels, `from` >= `to`. No taps unless `wanted`.
Taps downTaps(bool wanted, float i, float from, float to) {
  float ratio = from / to, centre = (i + 0.5) * ratio;
  float end = wanted ? ceil(centre + ratio) : -1e9;
  Taps taps;
  taps.count = 0;
  for (float j = floor(centre - ratio); j < end; j += 2.0)
    addTap(taps, j, downWeight(j, centre, ratio), downWeight(j + 1.0, centre, ratio), from);
  return taps;
}

// For target pixel i of `to`, from a level of `from` texels, `from` <= `to`: the transpose.
Taps upTaps(bool wanted, float i, float from, float to) {
  float low = i * from / to, high = (i + 1.0) * from / to, scale = to / from;
  float end = wanted ? ceil(high + 0.5) : -1e9;
  Taps taps;
  taps.count = 0;
  for (float j = floor(low - 0.5); j < end; j += 2.0) {
    float first = tentArea(high - j - 0.5) - tentArea(low - j - 0.5);
    float second = tentArea(high - j - 1.5) - tentArea(low - j - 1.5);
    addTap(taps, j, first * scale, second * scale, from);
  }
  return taps;
}

vec3 gather(sampler2D source, Taps x, Taps y) {
  vec3 sum = vec3(0);
  for (int j = 0; j < y.count; ++j)
    for (int i = 0; i < x.count; ++i)
      sum += x.weight[i] * y.weight[j] * textureLod(source, vec2(x.at[i], y.at[j]), 0.0).rgb;
  return sum;
}

// Sample i of a filter of the way down: offset in texels of the source, and weight.
vec3 downTap(int filterKind, int i) {
  const float binomial[5] = float[](1.0, 4.0, 6.0, 4.0, 1.0);
  int x = i % 5, y = i / 5;
  if (filterKind == 0) return vec3(x - 2, y - 2, binomial[x] * binomial[y] / 256.0);
  vec2 corner = vec2((i & 1) * 2 - 1, (i & 2) - 1); // samples 0 to 3
  if (filterKind == 1) return i < 4 ? vec3(corner, 0.125) : vec3(0, 0, 0.5);
  // Five overlapping 2 x 2 boxes of samples: the middle one weighs 1/2, the others 1/8 each.
  if (filterKind == 2 && i < 4) return vec3(corner, 0.125);
  vec2 wide = vec2((i - 4) % 3 - 1, (i - 4) / 3 - 1) * 2.0;
  float share = (wide.x == 0.0 ? 2.0 : 1.0) * (wide.y == 0.0 ? 2.0 : 1.0) / 32.0;
  return filterKind == 2 ? vec3(wide, share) : vec3(0.75 * corner, 0.25);
}

// Sample i of a filter of the way up.
vec3 upTap(int filterKind, int i) {
  vec2 corner = vec2((i & 1) * 2 - 1, (i & 2) - 1);
  vec2 axis = vec2(i == 4 ? 1 : i == 5 ? -1 : 0, i == 6 ? 1 : i == 7 ? -1 : 0);
  if (filterKind == 1) return i < 4 ? vec3(0.5 * corner, 2.0 / 12.0) : vec3(axis, 1.0 / 12.0);
  vec2 near = vec2(i % 3 - 1, i / 3 - 1);
  float share = (near.x == 0.0 ? 2.0 : 1.0) * (near.y == 0.0 ? 2.0 : 1.0) / 16.0;
  return filterKind == 2 ? vec3(near, share) : vec3(0, 0, 1);
}

// How many samples a filter takes is a loop's length: a software renderer runs both sides of an if.

// This pixel of a level of `size` pixels, from the next larger level.
vec3 downsample(sampler2D source, vec2 size, int filterKind) {
  vec2 from = vec2(textureSize(source, 0));
  vec2 pixel = floor(gl_FragCoord.xy), at = gl_FragCoord.xy / size;
  bool odd = filterKind == 3 && from != 2.0 * size; // else its weights are four samples
  int count = filterKind == 0 ? 25 : filterKind == 1 ? 5 : filterKind == 2 ? 13 : odd ? 0 : 4;
  vec3 sum = gather(source, downTaps(odd, pixel.x, from.x, size.x),
                    downTaps(odd, pixel.y, from.y, size.y));
  for (int i = 0; i < count; ++i) {
    vec3 tap = downTap(filterKind, i);
    sum += tap.z * textureLod(source, at + tap.xy / from, 0.0).rgb;
  }
  return sum;
}

// This pixel of a level of `size` pixels, from the next smaller level.
vec3 upsample(sampler2D source, vec2 size, int filterKind) {
  vec2 from = vec2(textureSize(source, 0));
  vec2 pixel = floor(gl_FragCoord.xy), at = gl_FragCoord.xy / size;
  bool odd = filterKind == 3 && 2.0 * from != size; // else its weights are one sample
  int count = filterKind == 1 ? 8 : filterKind == 2 ? 9 : odd ? 0 : 1;
  vec3 sum =
      gather(source, upTaps(odd, pixel.x, from.x, size.x), upTaps(odd, pixel.y, from.y, size.y));
  for (int i = 0; i < count; ++i) {
    vec3 tap = upTap(filterKind, i);
    sum += tap.z * textureLod(source, at + tap.xy / from, 0.0).rgb;
  }
  return sum;
}

// A colour that can be added and filtered: NaN and what is below 0 become 0, what a half float can't
// hold becomes its largest, 65504. One bad pixel would spread over the whole picture otherwise.
vec3 finite(vec3 color) {
  return vec3(color.r > 0.0 ? min(color.r, 65504.0) : 0.0,
              color.g > 0.0 ? min(color.g, 65504.0) : 0.0,
              color.b > 0.0 ? min(color.b, 65504.0) : 0.0);
}

// As downsample() with the area filter, but each texel is made finite before it is weighed, which a
// bilinear sample can't do. Edges are mirrored.
vec3 downsampleFinite(sampler2D source, vec2 size) {
  ivec2 from = textureSize(source, 0);
  vec2 ratio = vec2(from) / size, centre = gl_FragCoord.xy * ratio;
  vec2 end = ceil(centre + ratio), start = floor(centre - ratio);
  vec3 sum = vec3(0);
  for (float y = start.y; y < end.y; ++y) {
    float weightY = downWeight(y, centre.y, ratio.y);
    for (float x = start.x; x < end.x; ++x) {
      ivec2 at = ivec2(x, y);
      at = max(at, -1 - at);               // mirrored at the left and bottom edge
      at = min(at, 2 * from - 1 - at);     // and at the right and top one
      at = clamp(at, ivec2(0), from - 1);
      sum += downWeight(x, centre.x, ratio.x) * weightY * finite(texelFetch(source, at, 0).rgb);
    }
  }
  return sum;
}
