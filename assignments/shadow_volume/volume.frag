#version 410 core
// White, for the eyes; the pass "volume" writes no colours.

layout(location = 0) out vec4 oColor;

void main() {
  oColor = vec4(1);
}
