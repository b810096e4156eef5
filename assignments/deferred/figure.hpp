// The lecture's figure: a G-buffer says what the surfaces are like, and one pass after another
// works out how bright they are. The functions stand in the order in which they are called.
#pragma once

#include "environment.hpp"
#include "objects.hpp"
#include "targets.hpp"

// The figure's pictures, numbered as in figure.md. A picture's number is its texture unit, too;
// unit 0 has the identifiers, which are no picture.
enum class Picture {
  normal = 1,
  irradianceMap,
  depth,
  irradiance,
  occlusion,
  occluded, // irradiance, less what is occluded of the sky's
  albedo,
  diffuse,
  reflected, // direction of view
  environment,
  fresnel,
  reflection,
  composition,
  all // one beside the other
};

struct GBuffer {
  gg::Program program{{"object.vert", "gbuffer.frag"}};
  gg::Texture albedo, normal, ids, depth;
  gg::Framebuffer framebuffer;
  bool hasAlbedo = true; // does anything in this scene scatter light?
};

// A pass over the whole picture.
struct Pass {
  Picture picture; // that it draws
  GLenum format;
  gg::Program program;
  gg::Texture color{};
  gg::Framebuffer framebuffer{};
};

struct Figure {
  GBuffer gbuffer;
  Environment environment;
  std::vector<Pass> passes; // in the order in which they are drawn
  gg::Program show{{"screen.vert", "show.frag"}};
  gg::VertexArray noVertices; // screen.vert makes its own corners
  glm::ivec2 size{0};         // pixels
};

// What directions are stored in: quality.normal, see encoding.glsl.
inline GLenum directionFormat(const gg::Scene& scene) {
  const GLenum floats = scene.integer("quality.format") == 2 ? GL_RGBA32F : GL_RGBA16F;
  const GLenum formats[] = {floats, GL_RG16, GL_RGB10_A2, GL_RG8};
  return formats[scene.integer("quality.normal")];
}

// What object and material identifiers are stored in.
inline GLenum idFormat(const gg::Scene& scene) {
  return scene.integer("ring.count") < 250 ? GL_RG8UI : GL_RG16UI;
}

// The passes that this scene can show: where nothing mirrors there are no mirrored directions,
// where no occlusion is asked for nothing is occluded.
inline void addPasses(Figure& figure, const gg::Scene& scene) {
  const GLenum light = lightFormat(scene);
  const auto add = [&](Picture picture, const char* shader, GLenum format) {
    figure.passes.push_back({picture, format, gg::Program({"screen.vert", shader})});
  };
  const bool occlusion =
      scene.flag("debug.draw_all_passes") ||
      (scene.integer("quality.ao_samples") > 0 && scene.real("quality.ao_radius") > 0);
  const bool mirrors = anyMaterial(scene, [](const gg::Material& material) {
    return glm::vec3(material.specular) != glm::vec3(0);
  });
  if (figure.gbuffer.hasAlbedo) {
    add(Picture::irradiance, "irradiance.frag", light);
    if (occlusion) add(Picture::occlusion, "occlusion.frag", GL_R8);
    if (occlusion) add(Picture::occluded, "occluded.frag", light);
    add(Picture::diffuse, "diffuse.frag", light);
  }
  if (mirrors) {
    add(Picture::reflected, "reflected.frag", directionFormat(scene));
    add(Picture::fresnel, "fresnel.frag", light);
    add(Picture::reflection, "reflection.frag", light);
  }
  add(Picture::composition, "composition.frag", light);
}

// Storage for a texture that is read pixel by pixel.
inline void allocate(GLuint texture, const glm::ivec2& size, GLenum format, GLenum components,
                     GLenum type) {
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), size.x, size.y, 0, components, type,
               nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

// TODO(figure.1): make the G-buffer's framebuffer object.
//   Given:  `size` (of the window, pixels), `light`, `direction` and `ids` (formats), allocate(),
//           and the names in `gbuffer`: albedo, normal, ids, depth, framebuffer, hasAlbedo.
//   Goal:   `framebuffer` is complete: the shader's output 0 goes into albedo (format `light`) if
//           hasAlbedo, else nowhere; output 1 into normal (`direction`), output 2 into ids (`ids`,
//           two whole numbers); depth has 24 bits. If it isn't complete,
//           std::runtime_error is thrown. Afterwards the window is bound.
//                                                                      (figure.md, step 1)
inline void makeGBuffer(GBuffer& gbuffer, const glm::ivec2& size, GLenum light, GLenum direction,
                        GLenum ids) {
}

// A texture and a framebuffer object for each pass.
inline void makePasses(Figure& figure, const glm::ivec2& size) {
  for (const Pass& pass : figure.passes) {
    allocate(pass.color, size, pass.format, GL_RGBA, GL_FLOAT);
    glBindFramebuffer(GL_FRAMEBUFFER, pass.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, pass.color, 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      throw std::runtime_error("a pass's framebuffer object is not complete");
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

inline bool has(const Figure& figure, Picture picture) {
  return std::any_of(figure.passes.begin(), figure.passes.end(),
                     [&](const Pass& pass) { return pass.picture == picture; });
}

inline void bindTexture(int unit, GLuint texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture);
}

// Binds every texture of the figure to its unit. What isn't drawn in this scene is bound nowhere.
inline void bindPictures(const Figure& figure) {
  std::array<GLuint, 14> textures{};
  const auto at = [&](Picture picture) -> GLuint& { return textures[std::size_t(picture)]; };
  textures[0] = figure.gbuffer.ids;
  at(Picture::normal) = figure.gbuffer.normal;
  at(Picture::depth) = figure.gbuffer.depth;
  if (figure.gbuffer.hasAlbedo) {
    at(Picture::albedo) = figure.gbuffer.albedo;
    at(Picture::irradianceMap) = figure.environment.irradiance;
  }
  at(Picture::environment) = figure.environment.radiance;
  for (const Pass& pass : figure.passes) at(pass.picture) = pass.color;
  // Where nothing is occluded, all irradiance arrives.
  if (!has(figure, Picture::occluded)) at(Picture::occluded) = at(Picture::irradiance);
  for (std::size_t unit = 0; unit < textures.size(); ++unit) bindTexture(int(unit), textures[unit]);
  glActiveTexture(GL_TEXTURE0);
}

// What every shader of the figure may ask for (figure.glsl).
inline void setUniforms(const gg::Program& program, const gg::Scene& scene,
                        const glm::mat4& projection, const glm::mat4& view) {
  constexpr const char* kNames[] = {"uIds",        "uNormals",    "uIrradianceMap", "uDepth",
                                    "uIrradiance", "uOcclusion",  "uOccluded",      "uAlbedo",
                                    "uDiffuse",    "uReflected",  "uEnvironment",   "uFresnel",
                                    "uReflection", "uComposition"};
  for (std::size_t unit = 0; unit < std::size(kNames); ++unit) program.set(kNames[unit], int(unit));
  program.set("uProjection", projection);
  program.set("uView", view);
  program.set("uEncoding", scene.integer("quality.normal"));
}

// The pictures after the G-buffer, each into its own texture. Leaves the window bound.
inline void drawPasses(const Figure& figure, const gg::Scene& scene, const glm::mat4& projection,
                       const glm::mat4& view) {
  bindPictures(figure);
  glBindVertexArray(figure.noVertices);
  for (const Pass& pass : figure.passes) {
    const gg::Program& program = pass.program;
    program.use();
    setUniforms(program, scene, projection, view);
    if (pass.picture == Picture::occlusion) {
      program.set("uSamples", scene.integer("quality.ao_samples"));
      program.set("uRadius", scene.real("quality.ao_radius"));
    }
    if (pass.picture == Picture::occluded) {
      const Sky sky = skyOf(scene);
      program.set("uSunDirection", sky.sunDirection);
      program.set("uSunIrradiance", scene.text("sky.file").empty()
                                        ? discIrradiance(sky, sky.sunDirection)
                                        : glm::vec3(0));
    }
    if (pass.picture == Picture::fresnel) {
      std::array<glm::vec3, 1 + kMaterials.size()> reflectance{}; // by material; 0: nothing there
      for (std::size_t i = 0; i < kMaterials.size(); ++i)
        reflectance[1 + i] = glm::vec3(scene.material(kMaterials[i]).specular);
      glUniform3fv(glGetUniformLocation(program, "uReflectance"), GLsizei(reflectance.size()),
                   &reflectance[0][0]);
    }
    if (pass.picture == Picture::composition) {
      program.set("uHasDiffuse", has(figure, Picture::diffuse));
      program.set("uHasReflection", has(figure, Picture::reflection));
    }
    glBindFramebuffer(GL_FRAMEBUFFER, pass.framebuffer);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

// Shows a picture in the window, or all of them side by side, four in a row.
inline void showPicture(const Figure& figure, const gg::Scene& scene, const glm::mat4& projection,
                        const glm::mat4& view, Picture picture) {
  figure.show.use();
  setUniforms(figure.show, scene, projection, view);
  figure.show.set("uRange", glm::vec2(scene.camera.near, scene.camera.far));
  const auto draw = [&](Picture one, const glm::ivec2& corner, const glm::ivec2& size) {
    glViewport(corner.x, corner.y, size.x, size.y);
    figure.show.set("uPicture", int(one));
    figure.show.set("uViewport", glm::vec4(corner, size));
    glDrawArrays(GL_TRIANGLES, 0, 3);
  };
  if (picture != Picture::all) return draw(picture, {0, 0}, figure.size);
  glClear(GL_COLOR_BUFFER_BIT);
  const glm::ivec2 tile = glm::max(figure.size / 4, 1);
  for (int i = 0; i < 13; ++i) {
    const glm::ivec2 corner(i % 4 * tile.x, figure.size.y - (i / 4 + 1) * tile.y);
    draw(Picture(i + 1), corner, tile);
  }
  glViewport(0, 0, figure.size.x, figure.size.y);
}
