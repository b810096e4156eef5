#version 410 core
// Velocities as colours: grey is at rest, more red to the right, more green up.

uniform sampler2D uVelocity;

layout(location = 0) out vec4 oColor;

void main() {
  vec2 velocity = texelFetch(uVelocity, ivec2(gl_FragCoord.xy), 0).xy;
  oColor = vec4(0.5 + 6.0 * velocity, 0.5, 1);
}
