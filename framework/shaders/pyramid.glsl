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

// For target pixel i of `to`, from a level of `from` texels, `from` >= `to`.
Taps downTaps(float i, float from, float to) {
  float ratio = from / to, centre = (i + 0.5) * ratio, end = ceil(centre + ratio);
  Taps taps;
  taps.count = 0;
  for (float j = floor(centre - ratio); j < end; j += 2.0)
    addTap(taps, j, downWeight(j, centre, ratio), downWeight(j + 1.0, centre, ratio), from);
  return taps;
}

// For target pixel i of `to`, from a level of `from` texels, `from` <= `to`: the transpose.
Taps upTaps(float i, float from, float to) {
  float low = i * from / to, high = (i + 1.0) * from / to, scale = to / from;
  Taps taps;
  taps.count = 0;
  float end = ceil(high + 0.5);
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

// This pixel of a level of `size` pixels, from the next larger level.
vec3 downsample(sampler2D source, vec2 size, int filterKind) {
  vec2 from = vec2(textureSize(source, 0));
  vec2 pixel = floor(gl_FragCoord.xy), at = gl_FragCoord.xy / size, texel = 1.0 / from;
  if (filterKind == 0) {
    const float binomial[5] = float[](1.0, 4.0, 6.0, 4.0, 1.0);
    vec3 sum = vec3(0);
    for (int y = 0; y < 5; ++y)
      for (int x = 0; x < 5; ++x)
        sum += binomial[x] * binomial[y] / 256.0 *
               textureLod(source, at + vec2(x - 2, y - 2) * texel, 0.0).rgb;
    return sum;
  }
  if (filterKind == 1) {
    vec3 sum = 4.0 * textureLod(source, at, 0.0).rgb;
    for (int y = -1; y <= 1; y += 2)
      for (int x = -1; x <= 1; x += 2)
        sum += textureLod(source, at + vec2(x, y) * texel, 0.0).rgb;
    return sum / 8.0;
  }
  if (filterKind == 2) {
    // Five overlapping 2 x 2 boxes of samples: the middle one weighs 1/2, the others 1/8 each.
    vec3 sum = vec3(0);
    for (int y = -1; y <= 1; y += 2)
      for (int x = -1; x <= 1; x += 2)
        sum += 0.125 * textureLod(source, at + vec2(x, y) * texel, 0.0).rgb;
    for (int y = -2; y <= 2; y += 2)
      for (int x = -2; x <= 2; x += 2) {
        float weight = (x == 0 ? 2.0 : 1.0) * (y == 0 ? 2.0 : 1.0) / 32.0;
        sum += weight * textureLod(source, at + vec2(x, y) * texel, 0.0).rgb;
      }
    return sum;
  }
  return gather(source, downTaps(pixel.x, from.x, size.x), downTaps(pixel.y, from.y, size.y));
}

// This pixel of a level of `size` pixels, from the next smaller level.
vec3 upsample(sampler2D source, vec2 size, int filterKind) {
  vec2 from = vec2(textureSize(source, 0));
  vec2 pixel = floor(gl_FragCoord.xy), at = gl_FragCoord.xy / size, texel = 1.0 / from;
  if (filterKind == 0) return textureLod(source, at, 0.0).rgb;
  if (filterKind == 1) {
    vec3 sum = vec3(0);
    for (int i = 0; i < 4; ++i) {
      vec2 axis = vec2(i == 0 ? 1 : i == 1 ? -1 : 0, i == 2 ? 1 : i == 3 ? -1 : 0);
      vec2 diagonal = vec2(i < 2 ? 0.5 : -0.5, (i & 1) == 0 ? 0.5 : -0.5);
      sum += textureLod(source, at + axis * texel, 0.0).rgb +
             2.0 * textureLod(source, at + diagonal * texel, 0.0).rgb;
    }
    return sum / 12.0;
  }
  if (filterKind == 2) {
    vec3 sum = vec3(0);
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x)
        sum += (x == 0 ? 2.0 : 1.0) * (y == 0 ? 2.0 : 1.0) / 16.0 *
               textureLod(source, at + vec2(x, y) * texel, 0.0).rgb;
    return sum;
  }
  return gather(source, upTaps(pixel.x, from.x, size.x), upTaps(pixel.y, from.y, size.y));
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
