#version 410 core
// How much pixels take of their neighbours (MLAA: Reshetov, "Morphological Antialiasing", 2009).
// Each edge is followed to its ends; by what crosses it there it is the middle of a Z, a U or an
// L, and a line is laid through these shapes. A pixel takes of its neighbour what the line cuts
// off it.

uniform sampler2D uEdges; // red: on the pixel's left, green: below it

layout(location = 0) out vec4 oWeights; // as in smaa_weights.frag

const int kLongest = 32; // pixels that an edge is followed, to each side

// All is written for edges below pixels. For those on their left, rows and columns change places.
bool upright = false;

// The edges of the pixel so many pixels away. Beyond the picture there are none.
//   red: across the row, green: along it
vec2 edgesAt(ivec2 pixels) {
  ivec2 place = ivec2(gl_FragCoord.xy) + (upright ? pixels.yx : pixels);
  if (place != clamp(place, ivec2(0), textureSize(uEdges, 0) - 1)) return vec2(0);
  vec2 edges = texelFetch(uEdges, place, 0).rg;
  return upright ? edges.gr : edges;
}

// How high the line lies where the pixel `column` begins: half a pixel up or down where an edge
// crosses there, 0 (on the edge below this pixel) where none does.
float heightAt(int column) {
  return 0.5 * (edgesAt(ivec2(column, 0)).r - edgesAt(ivec2(column, -1)).r);
}

// Does an edge cross there?
bool isCrossed(int column) {
  return edgesAt(ivec2(column, 0)).r + edgesAt(ivec2(column, -1)).r > 0.0;
}

// What lies between a line and the edge below this pixel, above the edge (x) and below it (y): the
// integral of the line's height, split by its sign.
//   from, to: the line's ends (x: 0 where this pixel begins, 1 where it ends; y: height)
vec2 areas(vec2 from, vec2 to) {
  float begin = max(from.x, 0.0), end = min(to.x, 1.0);
  float slope = (to.y - from.y) / (to.x - from.x);
  if (begin >= end || slope == 0.0) return vec2(0);
  float y1 = from.y + slope * (begin - from.x), y2 = from.y + slope * (end - from.x);
  vec2 high = max(vec2(y1, y2), 0.0), low = min(vec2(y1, y2), 0.0);
  return 0.5 / slope * vec2(high.y * high.y - high.x * high.x, low.x * low.x - low.y * low.y);
}

// The weights of the edge below this pixel.
vec2 weights() {
  int left = 0, right = 1; // the columns where the edge begins, and before which it ends
  while (left > -kLongest && !isCrossed(left) && edgesAt(ivec2(left - 1, 0)).g > 0.0) --left;
  while (right <= kLongest && !isCrossed(right) && edgesAt(ivec2(right, 0)).g > 0.0) ++right;
  vec2 from = vec2(left, heightAt(left)), to = vec2(right, heightAt(right));
  if (from.y * to.y < 0.0) return areas(from, to); // a Z
  vec2 middle = vec2(0.5 * (from.x + to.x), 0);
  return areas(from, middle) + areas(middle, to); // a U, or an L: then one of both is 0
}

void main() {
  oWeights = vec4(0);
  vec2 edges = edgesAt(ivec2(0));
  if (edges.g > 0.0) oWeights.rg = weights();
  upright = true;
  if (edges.r > 0.0) oWeights.ba = weights();
}
