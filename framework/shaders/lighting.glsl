// Blinn-Phong lighting by one point light, in eye space.

layout(std140) uniform Light {
  vec4 ambient;
  vec4 diffuse;
  vec4 specular;
  vec4 position; // eye space
} uLight;

layout(std140) uniform Material {
  vec4 ambient;
  vec4 diffuse;
  vec4 specular;
  float shininess;
} uMaterial;

// The three kinds of light that leave a surface, apart, so that each can be used in its own way.
struct Lit {
  vec3 ambient;
  vec3 diffuse;
  vec3 specular;
};

// The unit vector along `v`; 0 for 0, where normalize() would divide by 0.
vec3 direction(vec3 v) {
  return v * inversesqrt(max(dot(v, v), 1e-30));
}

// position: of the surface, eye space;  normal: of the surface, eye space, unit length
Lit blinnPhong(vec3 position, vec3 normal) {
  vec3 toLight = direction(uLight.position.xyz - position);
  vec3 halfway = direction(toLight - direction(position));
  float facing = dot(normal, toLight);
  float highlight = facing > 0.0 ? pow(max(dot(normal, halfway), 1e-6), uMaterial.shininess) : 0.0;
  return Lit(uMaterial.ambient.rgb * uLight.ambient.rgb,
             uMaterial.diffuse.rgb * uLight.diffuse.rgb * max(facing, 0.0),
             uMaterial.specular.rgb * uLight.specular.rgb * highlight);
}
