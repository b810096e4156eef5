// Bloom: light spreads around what is brighter than a display can show.
//
// The scene is drawn into half floats. Its bright parts go into a row of pictures, the levels, each
// half as large as the one before and a little more blurred; their sum is added to the scene. The
// functions stand in the order in which they are called.
#pragma once

#include <gg/gg.hpp>

struct Bloom {
  gg::Program bright{{"screen.vert", "bright.frag"}};
  gg::Program down{{"screen.vert", "down.frag"}};
  gg::Program up{{"screen.vert", "up.frag"}};
  gg::Program composite{{"screen.vert", "composite.frag"}};
  gg::VertexArray noVertices; // screen.vert makes its own corners
  gg::Sampler sampler;        // of all post effects, instead of the textures' own settings

  // The scene.
  gg::Texture color;
  gg::Renderbuffer depth;
  gg::Framebuffer framebuffer;
  glm::ivec2 size{0}; // pixels

  struct Level {
    gg::Texture color;
    gg::Framebuffer framebuffer;
    glm::ivec2 size{0}; // pixels
  };
  std::vector<Level> levels;
};

// Can anything in this scene be brighter than the threshold?
inline bool showsBloom(const gg::Scene& scene) {
  if (scene.flag("debug.draw_all_passes")) return true;
  const auto brightest = [&](const char* name) {
    const gg::Material& of = scene.material(name);
    return glm::vec3(of.ambient * scene.light.ambient) +
           glm::max(glm::vec3(of.diffuse * scene.light.diffuse), 0.0f) +
           glm::max(glm::vec3(of.specular * scene.light.specular), 0.0f);
  };
  glm::vec3 objects(0);
  if (scene.integer("ring.count") > 0) objects = brightest("object") + scene.real("ring.glow");
  glm::vec3 floor = brightest("floor");
  if (scene.flag("effects.mirror"))
    floor += glm::vec3(scene.material("floor").specular) * glm::max(objects, scene.background);
  const glm::vec3 most = glm::max(glm::max(objects, floor), scene.background);
  return std::max({most.r, most.g, most.b}) > scene.real("bloom.threshold");
}

// What light is stored in: quality.bloom_format.
inline GLenum lightFormat(const gg::Scene& scene) {
  const GLenum formats[] = {GL_RGBA8, GL_R11F_G11F_B10F, GL_RGBA16F, GL_RGBA32F};
  return formats[scene.integer("quality.bloom_format")];
}

// TODO(bloom.1): make the framebuffer object of the scene.
//   Given:  `size` (of the window, pixels), `format` (GL_RGBA16F unless the scene file asks for
//           another) and the names in `bloom`: color, depth, framebuffer.
//   Do:     as for the reflection: storage for `color` (no mipmaps: set the filter) and `depth`;
//           attach both; throw unless it is complete; bind the window again.
//   Expect: the picture doesn't change yet.                             (bloom.md, step 1)
inline void makeScene(Bloom& bloom, const glm::ivec2& size, GLenum format) {
  bloom.size = size;
  // BEGIN SOLUTION(bloom.1)
  glBindTexture(GL_TEXTURE_2D, bloom.color);
  glTexImage2D(GL_TEXTURE_2D, 0, format, size.x, size.y, 0, GL_RGBA, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);

  glBindRenderbuffer(GL_RENDERBUFFER, bloom.depth);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size.x, size.y);

  glBindFramebuffer(GL_FRAMEBUFFER, bloom.framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, bloom.color, 0);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, bloom.depth);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("the scene's framebuffer object is not complete");
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  // END SOLUTION(bloom.1)
}

// TODO(bloom.3): make the levels.
//   Given:  `count` of levels, `format` as for the scene, `edge` (GL_CLAMP_TO_EDGE or
//           GL_MIRRORED_REPEAT), and bloom.size.
//   Do:     each level has half the size of the one before (the first: of the scene), rounded down,
//           at least 1; a colour texture of that size, in a framebuffer object of its own, without
//           depth. And glSamplerParameteri for bloom.sampler: linear filter, `edge` both ways.
inline void makeLevels(Bloom& bloom, int count, GLenum format, GLint edge) {
  bloom.levels.clear();
  bloom.levels.resize(static_cast<std::size_t>(count));
  // BEGIN SOLUTION(bloom.3)
  glm::ivec2 size = bloom.size;
  for (Bloom::Level& level : bloom.levels) {
    size = glm::max(size / 2, glm::ivec2(1));
    level.size = size;
    glBindTexture(GL_TEXTURE_2D, level.color);
    glTexImage2D(GL_TEXTURE_2D, 0, format, size.x, size.y, 0, GL_RGBA, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, level.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, level.color, 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      throw std::runtime_error("a bloom level's framebuffer object is not complete");
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);

  glSamplerParameteri(bloom.sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glSamplerParameteri(bloom.sampler, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glSamplerParameteri(bloom.sampler, GL_TEXTURE_WRAP_S, edge);
  glSamplerParameteri(bloom.sampler, GL_TEXTURE_WRAP_T, edge);
  // END SOLUTION(bloom.3)
}

// Covers what is drawn into with one triangle.
inline void drawScreen(const Bloom& bloom) {
  glBindVertexArray(bloom.noVertices);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

// TODO(bloom.3), too: the bright pass, from the scene into level 0.
//   Do:     bind the level's framebuffer, set viewport and uSize (a glm::vec2) to its size; bind
//           the scene's colour texture to unit 0; draw with drawScreen(). Then bright.frag.
//   Expect: the picture doesn't change yet; `./ggrade inspect bloom` shows the pass.
//                                                                       (bloom.md, step 3)
inline void brightPass(const Bloom& bloom, float threshold) {
  bloom.bright.use();
  bloom.bright.set("uScene", 0); // texture unit
  bloom.bright.set("uThreshold", threshold);
  bloom.bright.set("uWeight", 1.0f / static_cast<float>(bloom.levels.size()));
  // BEGIN SOLUTION(bloom.3)
  const Bloom::Level& level = bloom.levels[0];
  glBindFramebuffer(GL_FRAMEBUFFER, level.framebuffer);
  glViewport(0, 0, level.size.x, level.size.y);
  bloom.bright.set("uSize", glm::vec2(level.size));
  glBindTexture(GL_TEXTURE_2D, bloom.color);
  drawScreen(bloom);
  // END SOLUTION(bloom.3)
}

// TODO(bloom.4): down: into each level from 1 on, the one before it, blurred.
//   Do:     as in the bright pass, for one level after another, with bloom.down (uSize, too).
//   Expect: the picture doesn't change yet.                             (bloom.md, step 4)
inline void downPasses(const Bloom& bloom, int filter) {
  bloom.down.use();
  bloom.down.set("uSource", 0); // texture unit
  bloom.down.set("uFilter", filter);
  // BEGIN SOLUTION(bloom.4)
  for (std::size_t i = 1; i < bloom.levels.size(); ++i) {
    const Bloom::Level& level = bloom.levels[i];
    glBindFramebuffer(GL_FRAMEBUFFER, level.framebuffer);
    glViewport(0, 0, level.size.x, level.size.y);
    bloom.down.set("uSize", glm::vec2(level.size));
    glBindTexture(GL_TEXTURE_2D, bloom.levels[i - 1].color);
    drawScreen(bloom);
  }
  // END SOLUTION(bloom.4)
}

// TODO(bloom.5): up: from the last level but one to level 0, add to each the next smaller one.
//   Do:     as on the way down, with bloom.up, and blending on: glBlendFunc(GL_ONE, GL_ONE).
//           Afterwards blending off.
//   Expect: the picture doesn't change yet.                             (bloom.md, step 5)
inline void upPasses(const Bloom& bloom, int filter) {
  bloom.up.use();
  bloom.up.set("uSource", 0); // texture unit
  bloom.up.set("uFilter", filter);
  // BEGIN SOLUTION(bloom.5)
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  for (std::size_t i = bloom.levels.size() - 1; i > 0; --i) {
    const Bloom::Level& level = bloom.levels[i - 1];
    glBindFramebuffer(GL_FRAMEBUFFER, level.framebuffer);
    glViewport(0, 0, level.size.x, level.size.y);
    bloom.up.set("uSize", glm::vec2(level.size));
    glBindTexture(GL_TEXTURE_2D, bloom.levels[i].color);
    drawScreen(bloom);
  }
  glDisable(GL_BLEND);
  // END SOLUTION(bloom.5)
}

// TODO(bloom.2): the composite: the scene, from its framebuffer object to the window.
//   Given:  `window`, the size of the window; `glows`: is there bloom to add?
//   Do:     bind the window (0), set the viewport to its size; bind the scene's colour texture
//           to unit 0; draw with drawScreen().
//   Expect: the same scene, in brighter tones: composite.frag encodes it for the display.
//                                                                       (bloom.md, step 2)
inline void compositePass(const Bloom& bloom, const glm::ivec2& window, bool glows, int filter) {
  bloom.composite.use();
  bloom.composite.set("uScene", 0); // texture units
  bloom.composite.set("uBloom", 1);
  bloom.composite.set("uGlows", glows);
  bloom.composite.set("uSize", glm::vec2(window));
  bloom.composite.set("uFilter", filter);
  // TODO(bloom.6): bind level 0, which now holds the sum, to unit 1, with bloom.sampler on it
  //   (glBindSampler); after drawing, no sampler (0). Add it in composite.frag.
  //   Expect: light around what glows.                                  (bloom.md, step 6)
  // BEGIN SOLUTION(bloom.6)
  if (glows) {
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, bloom.levels[0].color);
    glBindSampler(1, bloom.sampler);
  }
  // END SOLUTION(bloom.6)
  // Then TODO(bloom.2) draws.
  // BEGIN SOLUTION(bloom.2)
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, window.x, window.y);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, bloom.color);
  drawScreen(bloom);
  // END SOLUTION(bloom.2)
  // BEGIN SOLUTION(bloom.6)
  glBindSampler(1, 0);
  // END SOLUTION(bloom.6)
}
