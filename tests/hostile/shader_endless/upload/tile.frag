#version 410 core
uniform mat4 uView;
out vec4 oColor;
void main() {
  float x = 0.0;
  while (uView[3][3] > -1.0)
    for (int i = 0; i < 1000000 && uView[3][3] > -1.0; ++i) x += sin(x);
  oColor = vec4(x);
}
