#version 410 core
// The chequered floor and what it reflects.

#include "gg/lighting.glsl"
#include "shadow.glsl"

const vec3 kLightTile = vec3(0.9, 0.9, 0.9);
const vec3 kDarkTile = vec3(0.6, 0.7, 0.8);

uniform float uTilesPerUnit;
uniform vec2 uViewport;        // pixels of the window
uniform bool uMirror;          // is there a reflection to show?
uniform sampler2D uReflection; // what the pass "mirror" drew
uniform float uBlurSigma;      // standard deviation of the blur, in window heights; 0 is sharp
uniform int uBlurSamples;

in vec3 vPosition; // eye space
in vec3 vNormal;   // eye space
in vec3 vWorld;

layout(location = 0) out vec4 oColor;

void main() {
  vec2 tile = floor(vWorld.xz * uTilesPerUnit);
  vec3 albedo = mix(kLightTile, kDarkTile, mod(tile.x + tile.y, 2));
  Lit lit = blinnPhong(vPosition, normalize(vNormal));
  float visible = visibility(vWorld, vec3(0, 1, 0));
  vec3 color = (lit.ambient + visible * lit.diffuse) * albedo + visible * lit.specular;

  vec3 reflected = vec3(0);
  if (uMirror) {
    // TODO(mirror.3): `reflected` is the reflection under this pixel of the window.
    //   Given:  uReflection, drawn with the window's projection; gl_FragCoord; uViewport.
    // TODO(mirror.7): bonus: if uBlurSigma and uBlurSamples are more than 0, the plain mean of that
    //   many samples, whose places follow a Gaussian distribution.
  }
  oColor = vec4(color + uMaterial.specular.rgb * reflected, 1);
}
