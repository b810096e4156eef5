#version 410 core
// Smooth edges, found in the picture alone (FXAA 3.11, Timothy Lottes, 2011).

uniform sampler2D uPicture; // as displayed; alpha: luma; a linear filter
uniform int uSteps;         // of the search along an edge, to each side
uniform float uSubpixel;    // how far a single pixel may be shifted, 0 to 1
uniform int uShow;          // 0 the picture, 1 which pixels are edges, 2 how these lie

layout(location = 0) out vec4 oColor;

// Luma must differ by so much for an edge: at least, and as a share of the brightest.
const float kLeast = 0.0833, kShare = 0.166;
// How far each step of the search goes, pixels.
const float kStep[12] = float[](1.0, 1.0, 1.0, 1.0, 1.0, 1.5, 2.0, 2.0, 2.0, 2.0, 4.0, 8.0);

vec2 texel = 1.0 / vec2(textureSize(uPicture, 0));

// Luma at a place that lies `pixels` away from the middle of this fragment.
float lumaAt(vec2 pixels) {
  return texture(uPicture, texel * (gl_FragCoord.xy + pixels)).a;
}

// The luma of a pixel (m) and of its eight neighbours, north being up.
struct Around {
  float m, n, s, e, w, ne, nw, se, sw;
};
Around lumaAround() {
  return Around(lumaAt(vec2(0)), lumaAt(vec2(0, 1)), lumaAt(vec2(0, -1)), lumaAt(vec2(1, 0)),
                lumaAt(vec2(-1, 0)), lumaAt(vec2(1, 1)), lumaAt(vec2(-1, 1)), lumaAt(vec2(1, -1)),
                lumaAt(vec2(-1, -1)));
}

// The contrast around a pixel where it is an edge, else 0.
float contrastOf(Around luma) {
  float contrast = 0.0;
  // TODO(antialias.1): brightest minus darkest of m, n, s, e and w, if that is enough.
  //   Given:  luma.m, luma.n, ...; kLeast, kShare.
  //   Goal:   0 where it is less than kLeast, or less than kShare of the brightest.
  //   Expect: white lines along all edges in the picture of edges.        (antialias.md, step 1)
  return contrast;
}

// How an edge lies.
struct Edge {
  bool horizontal; // it runs along a row
  vec2 across;     // towards the pixel on its other side: one pixel up, down, right or left
  float step;      // luma's change across it
  float middle;    // luma on the edge itself, between both pixels
};
Edge edgeOf(Around luma) {
  Edge edge = Edge(true, vec2(0, 1), 0.0, luma.m);
  // TODO(antialias.2): does the edge run along rows or columns, and on which side is it?
  //   Given:  luma.
  //   Goal:   `horizontal` where luma bends more along columns than along rows: second differences
  //           of the three columns, the middle one twice, against those of the three rows. `across`
  //           towards the neighbour that differs more; `step` by how much, `middle` the mean of
  //           both.
  //   Expect: red and green edges in the picture of how they lie.         (antialias.md, step 2)
  return edge;
}

// How far to one end of the edge, in pixels, and how luma there differs from the edge's middle.
struct End {
  float distance, difference;
};
End search(Edge edge, vec2 along) {
  End end = End(0.0, 0.0);
  // TODO(antialias.3): go along the edge until luma on it has changed.
  //   Given:  `edge`, `along` (one pixel to this side), kStep, uSteps, lumaAt().
  //   Goal:   on the line between both pixels, 0.5 * edge.across; step by step, until luma there
  //           differs from edge.middle by at least a quarter of edge.step.
  return end;
}

// How far to shift towards the edge's other side, 0 to 0.5 pixels.
float shiftOf(Around luma, Edge edge) {
  float shift = 0.0;
  vec2 along = edge.horizontal ? vec2(1, 0) : vec2(0, 1);
  End before = search(edge, -along), behind = search(edge, along);
  // TODO(antialias.3): the nearer the end at which this pixel's side begins to be the other one,
  //   the more.
  //   Given:  `before` and `behind`, the edge's ends; luma.m, edge.middle.
  //   Goal:   1/2 minus the distance of the nearer end as a share of the edge's length; nothing if
  //           luma at that end lies on the same side of edge.middle as luma.m.
  //   Expect: edges that are nearly level or upright have no steps.       (antialias.md, step 3)
  return shift;
}

// How far to shift because the pixel differs from all that is around it, 0 to 1 pixels.
float subpixelShift(Around luma, float contrast) {
  float shift = 0.0;
  // TODO(antialias.4): the more the pixel stands out of the mean around it, the more.
  //   Given:  luma, contrast, uSubpixel.
  //   Goal:   the neighbours' mean, sides weighing 2 and corners 1, minus luma.m, as a share of the
  //           contrast, at most 1; smoothed by smoothstep, squared, times uSubpixel.
  //   Expect: letters and highlights are calmer, wires softer.            (antialias.md, step 4)
  return shift;
}

void main() {
  oColor = texelFetch(uPicture, ivec2(gl_FragCoord.xy), 0);
  Around luma = lumaAround();
  float contrast = contrastOf(luma);
  if (uShow == 1) oColor = vec4(vec3(contrast), 1);
  if (uShow == 2) oColor = vec4(0, 0, 0, 1);
  if (contrast == 0.0 || uShow == 1) return;
  Edge edge = edgeOf(luma);
  if (uShow == 2) {
    bool up = edge.across.x + edge.across.y > 0.0;
    oColor = vec4(edge.horizontal, !edge.horizontal, up, 1);
    return;
  }
  float shift = max(shiftOf(luma, edge), subpixelShift(luma, contrast));
  oColor = texture(uPicture, texel * (gl_FragCoord.xy + shift * edge.across));
}
