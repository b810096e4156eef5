#version 410 core
// Everything in the world: its light, and how far it moved since the last frame.

#include "gg/lighting.glsl"
#include "motion.glsl"

uniform bool uHasPattern;
uniform sampler2D uPattern;
uniform float uRepeat;  // of the pattern, along a side
uniform float uRipples; // how steep they are; 0: none
uniform vec3 uEmission; // light that it gives off itself

in vec3 vModel;    // model space
in vec3 vPosition; // eye space
in vec3 vNormal;   // eye space, any length
in vec2 vUv;
in vec4 vNow;  // clip space, this frame's
in vec4 vLast; // clip space, the last frame's

layout(location = 0) out vec4 oColor;    // linear
layout(location = 1) out vec2 oVelocity; // texture coordinates a frame

void main() {
  vec3 normal = direction(vNormal);
  // Waves that are narrower than a pixel: their highlights glitter.
  if (uRipples > 0.0)
    normal = direction(normal + uRipples * sin(90.0 * vModel.yzx) * sin(61.0 * vModel));
  Lit lit = blinnPhong(vPosition, normal);
  vec3 pattern = uHasPattern ? texture(uPattern, uRepeat * vUv).rgb : vec3(1);
  vec3 color = pattern * (lit.ambient + lit.diffuse) + lit.specular + uEmission;
  // What a half float can't hold would become infinity.
  oColor = vec4(min(color, 65504.0), 1);

  oVelocity = vec2(0);
  // TODO(motion_blur.3): how far this point moved since the last frame.
  //   Given:  vNow, vLast; moved(now, last).
}
