#version 410 core
// From linear light of any brightness to what the screen shows, and how bright that looks.

uniform sampler2D uColor; // linear light

layout(location = 0) out vec4 oColor; // as displayed (sRGB); alpha: its luma

void main() {
  vec3 light = max(texelFetch(uColor, ivec2(gl_FragCoord.xy), 0).rgb, 0.0);
  vec3 toned = 1.0 - exp(-light);
  vec3 shown = mix(1.055 * pow(toned, vec3(1.0 / 2.4)) - 0.055, 12.92 * toned,
                   lessThanEqual(toned, vec3(0.0031308)));
  oColor = vec4(shown, dot(shown, vec3(0.299, 0.587, 0.114)));
}
