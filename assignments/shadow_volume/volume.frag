#version 410 core
// For the eyes: white where the volume is seen from the front, a way in, orange where it is seen from
// the back, a way out. The pass "volume" writes no colours.

layout(location = 0) out vec4 oColor;

void main() {
  oColor = gl_FrontFacing ? vec4(1) : vec4(1, 0.5, 0, 1);
}
