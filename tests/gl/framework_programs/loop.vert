#version 410 core
layout(location = 0) in vec4 aPosition;
void main() {
  gl_Position = vec4(aPosition.x, -aPosition.z, 0, 1);
}
