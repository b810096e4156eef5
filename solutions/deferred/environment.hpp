// The environment as textures: what comes from every direction, and what falls on every normal.
#pragma once

#include "hdr.hpp"
#include "irradiance.hpp"

#include <gg/gg.hpp>

struct Environment {
  gg::Texture radiance;   // by direction
  gg::Texture irradiance; // by normal
};

// The sky of this scene; its sun stands where the light's position is, seen from the origin.
inline Sky skyOf(const gg::Scene& scene) {
  Sky sky;
  if (scene.flag("sky.uniform"))
    sky.zenith = sky.horizon = sky.ground = glm::vec3(0.5f), sky.glow = 0;
  for (glm::vec3* part : {&sky.zenith, &sky.horizon, &sky.ground})
    *part *= scene.real("sky.brightness");
  const glm::vec3 towards(scene.light.position);
  sky.sunDirection =
      towards == glm::vec3(0) ? glm::vec3(0, 1, 0) : glm::vec3(glm::normalize(glm::dvec3(towards)));
  sky.sunRadiance *= scene.real("sun.brightness");
  sky.sunRadius = scene.real("sun.radius");
  return sky;
}

// A map as a texture with the coordinates of equirectangular() in figure.glsl.
//   format: GL_RGB16F or GL_RGB32F
inline void loadMap(GLuint texture, const EnvironmentMap& map, GLenum format) {
  std::vector<glm::vec3> texels = map.texels;
  for (glm::vec3& texel : texels) texel = glm::min(texel, 65504.0f); // the largest half float
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, format, map.width, map.height, 0, GL_RGB, GL_FLOAT, texels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

// Makes both, the second one if anything in the scene scatters light.
// Throws gg::FileError for a file that is no environment.
inline void makeEnvironment(Environment& environment, const gg::Scene& scene, bool scatters) {
  const std::string file = scene.text("sky.file");
  const GLenum format = scene.integer("quality.format") == 2 ? GL_RGB32F : GL_RGB16F;
  const int width = 2 * scene.integer("quality.irradiance_height");
  constexpr int kSummed = 256; // texels in a row of a map that is summed up for each normal
  if (!file.empty()) {
    const EnvironmentMap map = loadEnvironment(file);
    loadMap(environment.radiance, map, format);
    if (!scatters) return;
    const EnvironmentMap summed = map.width > kSummed ? coarser(map, kSummed) : map;
    return loadMap(environment.irradiance, irradianceMap(summed, width), format);
  }
  const Sky sky = skyOf(scene);
  loadMap(environment.radiance,
          environmentMap(sky, 2 * scene.integer("quality.environment_height")), format);
  if (!scatters) return;
  constexpr int kDegrees[] = {2, 4};
  const int method = scene.integer("quality.irradiance");
  loadMap(environment.irradiance,
          method < 2 ? irradianceMap(sky, kDegrees[method], width)
                     : irradianceMap(environmentMap(sky, kSummed), width),
          format);
}
