#version 410 core
uniform sampler2D uSource;
layout(location = 0) out vec4 oColor;
void main() {
  oColor = texelFetch(uSource, ivec2(0), 0);
}
