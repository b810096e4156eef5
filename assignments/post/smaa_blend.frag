#version 410 core
// Each pixel takes of its neighbours what the weights say (last pass of SMAA and of MLAA).

uniform sampler2D uPicture; // as displayed; a linear filter
uniform sampler2D uWeights; // of smaa_weights.frag or mlaa_weights.frag

layout(location = 0) out vec4 oColor;

// The picture at a place that lies `pixels` away from the middle of this fragment.
vec4 pictureAt(vec2 pixels) {
  return texture(uPicture, (gl_FragCoord.xy + pixels) / vec2(textureSize(uPicture, 0)));
}

// The weights of the pixel so many pixels away, beyond the picture those of its border.
vec4 weightsAt(ivec2 pixels) {
  ivec2 last = textureSize(uWeights, 0) - 1;
  return texelFetch(uWeights, min(ivec2(gl_FragCoord.xy) + pixels, last), 0);
}

void main() {
  oColor = texelFetch(uPicture, ivec2(gl_FragCoord.xy), 0);
  vec4 own = weightsAt(ivec2(0));
  // How much this pixel takes of the one on its left and its right, and below and above it.
  vec2 leftRight = vec2(own.b, weightsAt(ivec2(1, 0)).a);
  vec2 belowAbove = vec2(own.r, weightsAt(ivec2(0, 1)).g);
  // TODO(antialias.6): blend, along the row or along the column.
  //   Given:  leftRight and belowAbove, 0 to 1; pictureAt(), which blends two pixels by itself: a
  //           quarter of a pixel to the left it gives 3/4 of this pixel and 1/4 of the left one.
  //   Goal:   the pair with the greatest weight counts, along the column if both have it. The
  //           picture at both of its places, as far away as the weight, weighted by these weights.
  //           Where all are 0, the picture stays.
  //   Expect: with quality.antialias 1, smooth edges.                     (antialias.md, step 6)
}
