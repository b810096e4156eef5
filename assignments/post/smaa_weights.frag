#version 410 core
// How much pixels take of their neighbours (second pass of SMAA 1x: Jimenez, Echevarria, Sousa and
// Gutierrez, 2012). The steps of an edge are taken for what is left of a smooth line: a pixel takes
// of its neighbour as much as that line would cut off it.

uniform sampler2D uEdges;   // red: on the pixel's left, green: below it; a linear filter
uniform sampler2D uAreas;   // what lines cut off (smaa_tables.hpp); a linear filter
uniform sampler2D uSearch;  // how a search ends (smaa_tables.hpp)
uniform int uSteps;         // of a search along a row or column, to each side, two pixels each
uniform int uDiagonalSteps; // of a search along a diagonal, one pixel each; 0: no diagonals
uniform float uRounding;    // how round corners become: 0 not at all, 1 as the lines would
                            // have them

// Between this pixel and the one below it: red, how much this one takes of that one, green, that
// one of this one. Blue and alpha: the same between this pixel and the one on its left.
layout(location = 0) out vec4 oWeights;

// All is written for edges below pixels. For those on their left, rows and columns change places.
bool upright = false;

// The edges at a place that lies `pixels` away from the middle of this fragment.
//   red: across the row, green: along it
vec2 edgesAt(vec2 pixels) {
  vec2 place = gl_FragCoord.xy + (upright ? pixels.yx : pixels);
  vec2 edges = texture(uEdges, place / vec2(textureSize(uEdges, 0))).rg;
  return upright ? edges.gr : edges;
}

// How many pixels farther the edge goes on.
//   side: -1 to the left, 1 to the right
float search(float side) {
  // One look between four pixels sees them all: the nearer one of the row counts 21/32, the farther
  // one 7/32, those below them 3/32 and 1/32. No two sets of edges have the same sum. It goes on
  // while the edge is there in both pixels of the row, and no edge across it in any of the four.
  float first = side < 0.0 ? -0.25 : 1.25;
  vec2 seen = vec2(0, 1);
  int looks = 0;
  for (; looks < uSteps && seen.g > 26.5 / 32.0 && seen.r == 0.0; ++looks)
    seen = edgesAt(vec2(first + side * 2.0 * float(looks), -0.125));
  ivec2 sums = ivec2(round(32.0 * seen));
  vec2 counted = round(2.0 * texelFetch(uSearch, sums, 0).rg); // by the last look
  // To the left, the first look saw this pixel, too.
  return 2.0 * float(looks - 1) + (side < 0.0 ? counted.r - 1.0 : counted.g);
}

// The weights of the edge below this pixel, if it belongs to a line that is nearly level.
vec2 nearlyLevel() {
  float left = search(-1.0), right = search(1.0);

  // The edges across the line's ends, in quarters: 3 in this row, 1 in the one below, 4 in both.
  vec2 ends = vec2(edgesAt(vec2(-left, -0.25)).r, edgesAt(vec2(right + 1.0, -0.25)).r);
  vec2 place = 16.0 * round(4.0 * ends) + sqrt(vec2(left, right));
  vec2 areas = texture(uAreas, (place + 0.5) / vec2(textureSize(uAreas, 0))).rg;

  // An edge across that goes on for more than a pixel makes a corner, which is to stay one.
  vec2 near = step(vec2(left, right), vec2(right, left)); // which end is the nearer one, or both
  near *= (1.0 - uRounding) / (near.x + near.y);
  vec2 above = vec2(edgesAt(vec2(-left, 1)).r, edgesAt(vec2(right + 1.0, 1)).r);
  vec2 below = vec2(edgesAt(vec2(-left, -2)).r, edgesAt(vec2(right + 1.0, -2)).r);
  return areas * clamp(1.0 - vec2(dot(near, above), dot(near, below)), 0.0, 1.0);
}

// Diagonals are written for stairs that fall to the right: the edges on the left and below of a
// pixel, then of the one below on the right. For those that rise, left and right change places.
bool rising = false;

// The edges of a pixel that are part of such stairs.
vec2 stairsAt(vec2 pixels) {
  if (!rising) return edgesAt(pixels);
  return vec2(edgesAt(vec2(1.0 - pixels.x, pixels.y)).r, edgesAt(vec2(-pixels.x, pixels.y)).g);
}

// How the stairs go on to one side.
struct Stairs {
  float steps; // how many pixels farther
  bool end;    // was their end found?
  bool tread;  // do they end with an edge below a pixel?
};
Stairs walk(vec2 direction) {
  vec2 edges = vec2(1);
  int looks = 0;
  for (; looks < uDiagonalSteps && edges.r + edges.g > 1.5; ++looks)
    edges = stairsAt(float(looks + 1) * direction);
  return Stairs(float(looks - 1), edges.r + edges.g < 1.5, edges.g > 0.5);
}

// The weights of the edge below this pixel, if it belongs to stairs.
vec2 diagonal() {
  Stairs up = Stairs(0.0, true, false);
  if (stairsAt(vec2(0)).r > 0.5) up = walk(vec2(-1, 1));
  if (up.tread) up.steps += 1.0;
  Stairs down = walk(vec2(1, -1));
  vec2 steps = vec2(up.steps, down.steps);
  if (steps.x + steps.y < 2.5) return vec2(0);

  // The edges that go on from the ends: 2 along the row, 1 along the column, 3 both.
  vec2 ends = vec2(0);
  if (up.end)
    ends.x = 2.0 * stairsAt(vec2(-steps.x - 1.0, steps.x)).g + stairsAt(vec2(-steps.x, steps.x)).r;
  if (down.end)
    ends.y = 2.0 * stairsAt(vec2(steps.y + 1.0, -steps.y)).g +
             stairsAt(vec2(steps.y + 1.0, -steps.y - 1.0)).r;

  // The table's right half, from the left end to the right one.
  vec2 place = 20.0 * round(ends) + steps;
  vec2 areas = texelFetch(uAreas, ivec2(80, 0) + ivec2(rising ? place.yx : place), 0).rg;
  return rising ? areas.gr : areas;
}

void main() {
  oWeights = vec4(0);
  vec2 edges = edgesAt(vec2(0));
  if (edges.g > 0.5) {
    if (uDiagonalSteps > 0) {
      oWeights.rg = diagonal();
      rising = true;
      oWeights.rg += diagonal();
      if (oWeights.r + oWeights.g > 0.0) return; // its edge on the left belongs to the stairs
    }
    oWeights.rg = nearlyLevel();
  }
  if (edges.r > 0.5) {
    upright = true;
    oWeights.ba = nearlyLevel();
  }
}
