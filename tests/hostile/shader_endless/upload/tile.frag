#version 410 core
uniform mat4 uView;
out vec4 oColor;
void main() {
  float x = 0.0;
  while (uView[3][3] > -1.0) x += 1.0;
  oColor = vec4(x);
}
