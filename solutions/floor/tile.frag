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

// BEGIN SOLUTION(mirror.7)
// A Gaussian average of the reflection about `at`. The samples lie on a golden-angle spiral whose
// radii follow the Gaussian's own distribution, so all weigh the same; turning the spiral by another
// angle in every pixel makes noise of what would be ghost images.
vec3 blurredReflection(vec2 at) {
  const float kGoldenAngle = 2.39996323;
  float turn = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  vec2 scale = uBlurSigma * vec2(uViewport.y / uViewport.x, 1);
  vec3 sum = vec3(0);
  for (int i = 0; i < uBlurSamples; ++i) {
    float radius = sqrt(-2 * log(1 - (i + 0.5) / uBlurSamples));
    float angle = turn + kGoldenAngle * i;
    sum += texture(uReflection, at + radius * scale * vec2(cos(angle), sin(angle))).rgb;
  }
  return sum / uBlurSamples;
}
// END SOLUTION(mirror.7)

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
    // BEGIN SOLUTION(mirror.3)
    vec2 at = gl_FragCoord.xy / uViewport;
    reflected = texture(uReflection, at).rgb;
    // END SOLUTION(mirror.3)
    // TODO(mirror.7): bonus: if uBlurSigma and uBlurSamples are more than 0, the plain mean of that
    //   many samples, whose places follow a Gaussian distribution.
    // BEGIN SOLUTION(mirror.7)
    if (uBlurSigma > 0 && uBlurSamples > 0) reflected = blurredReflection(at);
    // END SOLUTION(mirror.7)
  }
  oColor = vec4(color + uMaterial.specular.rgb * reflected, 1);
}
