#version 410 core
// Which borders of a pixel are edges (first pass of SMAA: Jimenez, Echevarria, Sousa and
// Gutierrez, 2012; of MLAA, too). What has none is discarded, so that an occlusion query tells if
// there is any.

uniform sampler2D uPicture;   // as displayed; alpha: luma
uniform float uThreshold;     // luma must differ by so much across an edge
uniform float uLocalContrast; // an edge can be so many times as faint as one beside it

layout(location = 0) out vec4 oEdges; // red: on the pixel's left, green: below it

// The luma of the pixel so many pixels away, beyond the picture that of its border.
float lumaAt(ivec2 pixels) {
  ivec2 last = textureSize(uPicture, 0) - 1;
  return texelFetch(uPicture, clamp(ivec2(gl_FragCoord.xy) + pixels, ivec2(0), last), 0).a;
}

void main() {
  float luma = lumaAt(ivec2(0));
  vec2 nearer = vec2(lumaAt(ivec2(-1, 0)), lumaAt(ivec2(0, -1)));  // left, below
  vec2 farther = vec2(lumaAt(ivec2(-2, 0)), lumaAt(ivec2(0, -2))); // behind those
  vec2 opposite = vec2(lumaAt(ivec2(1, 0)), lumaAt(ivec2(0, 1)));  // right, above
  vec2 edges = vec2(0);
  // TODO(antialias.5): is there an edge on the left (edges.x), and one below (edges.y)?
  //   Given:  luma, nearer, farther, opposite; uThreshold, uLocalContrast.
  //   Goal:   1 where luma differs by at least uThreshold from the nearer one, and that difference,
  //           times uLocalContrast, is at least as great as the greatest of all six: from luma to
  //           nearer and to opposite, and from nearer to farther. Else 0.
  //   Expect: with quality.antialias 1, red edges on the left and green ones below, one pixel wide,
  //           in the picture of edges.                                    (antialias.md, step 5)
  if (edges == vec2(0)) discard;
  oEdges = vec4(edges, 0, 1);
}
