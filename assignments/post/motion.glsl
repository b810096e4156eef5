// How far things move in the picture, in texture coordinates: 1 is the whole width or height.

// From the last frame's place to this one's, both in clip space. What was beside or behind the eye
// wasn't anywhere in the last picture: it counts as at rest.
vec2 moved(vec4 now, vec4 last) {
  vec2 velocity = vec2(0);
  // TODO(motion_blur.1): the difference of both places in the picture.
  //   Given:  clip coordinates; x / w and y / w are -1 to 1 across the picture.
  //   Goal:   now's place minus last's, in texture coordinates; nothing where last.w isn't
  //           positive.
  //   Expect: with velocity.frag, colours in the picture of velocities.   (motion_blur.md, step 1)
  return clamp(velocity, -6e4, 6e4); // what a half float can't hold would become infinity
}
