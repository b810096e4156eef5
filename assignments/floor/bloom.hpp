// Bloom: light spreads around what is brighter than a display can show.
//
// The scene is drawn into half floats. Its bright parts go into a row of pictures, the levels, each
// half as large as the one before and a little more blurred; their sum is added to the scene. What
// you write stands in the order of the steps; it is called below and in floor.cpp.
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

// TODO(bloom.1): make the framebuffer object of the scene.
//   Given:  `size` (of the window, pixels), `format` (GL_RGBA16F unless the scene file asks for
//           another) and the names in `bloom`: color, depth, framebuffer.
//   Goal:   as for the reflection: `framebuffer` is complete, with `color`, which later passes will
//           sample, and `depth`; if it isn't, std::runtime_error is thrown. The window is bound.
//   Expect: the picture doesn't change yet.                             (bloom.md, step 1)
inline void makeScene(Bloom& bloom, const glm::ivec2& size, GLenum format) {
  bloom.size = size;
}

// Covers what is drawn into with one triangle.
inline void drawScreen(const Bloom& bloom) {
  glBindVertexArray(bloom.noVertices);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

// TODO(bloom.2): draw the scene into its framebuffer object, then bring it to the window.
//   Given:  `bloom`, whose framebuffer is as large as the window; `window`, its size (pixels);
//           drawScreen(), with the program and its uniforms set, which samples the scene through
//           texture unit 0.
//   Goal:   objects and floor, drawn between these two functions, go into the framebuffer object;
//           the second one draws their picture into the window.
//   Expect: the same scene, in brighter tones: composite.frag encodes it for the display.
//                                                                       (bloom.md, step 2)
inline void beginScene(const Bloom& bloom) {
}

inline void showScene(const Bloom& bloom, const glm::ivec2& window) {
}

// TODO(bloom.3): make the levels, and the sampler that they are read by.
//   Given:  bloom.levels, as many as asked for; bloom.size, that of the scene; `format` as for the
//           scene; bloom.sampler; `edge`, what it reads beyond an edge (GL_CLAMP_TO_EDGE or
//           GL_MIRRORED_REPEAT).
//   Goal:   each level is half as large as the one before (the first: as the scene), in a window of
//           any size, and can be drawn into and sampled. The sampler filters linearly.
inline void makeLevels(Bloom& bloom, int count, GLenum format, GLint edge) {
  bloom.levels.clear();
  bloom.levels.resize(static_cast<std::size_t>(count));
}

// TODO(bloom.3), too: the bright pass, from the scene into level 0.
//   Given:  bloom.bright, in use: its uSize (a glm::vec2) is the size of what is drawn into;
//           drawScreen(); texture unit 0.
//   Goal:   all of level 0 is drawn anew, from the scene's colours.
//   Expect: the picture doesn't change yet; `./ggrade inspect bloom` shows the pass: so far, all of
//           the scene. What of it is too bright is the next step's, in bright.frag.
//                                                                       (bloom.md, step 3)
inline void brightPass(const Bloom& bloom, float threshold) {
  bloom.bright.use();
  bloom.bright.set("uScene", 0); // texture unit
  bloom.bright.set("uThreshold", threshold);
  bloom.bright.set("uWeight", 1.0f / static_cast<float>(bloom.levels.size()));
}

// TODO(bloom.5): down: into each level from 1 on, the one before it, blurred.
//   Given:  bloom.down, in use, which blurs what it reads through unit 0; the rest as above.
//   Goal:   each of these levels is drawn anew, the larger ones first.
//   Expect: the picture doesn't change yet.                             (bloom.md, step 5)
inline void downPasses(const Bloom& bloom, int filter) {
  bloom.down.use();
  bloom.down.set("uSource", 0); // texture unit
  bloom.down.set("uFilter", filter);
}

// TODO(bloom.6): up: from the last level but one to level 0, add to each the next smaller one.
//   Given:  bloom.up, in use, as bloom.down is above.
//   Goal:   level 0 holds the sum of all levels; afterwards nothing is blended any more.
//   Expect: the picture doesn't change yet.                             (bloom.md, step 6)
inline void upPasses(const Bloom& bloom, int filter) {
  bloom.up.use();
  bloom.up.set("uSource", 0); // texture unit
  bloom.up.set("uFilter", filter);
}

// TODO(bloom.7): let the composite read level 0, which now holds the sum, through texture unit 1.
//   Given:  `bloom`; its sampler, for this unit, too.
//   Goal:   between these two functions, level 0 is read by the sampler's rules; after them no
//           sampler is left. Then add it in composite.frag.
//   Expect: light around what glows.                                    (bloom.md, step 7)
inline void bindSum(const Bloom& bloom) {
}

inline void unbindSum() {
}

// The pass "composite": the scene and level 0, into the window. It is made of TODO(bloom.2) and
// TODO(bloom.7).
//   window: its size, pixels;  glows: is there bloom to add?
inline void compositePass(const Bloom& bloom, const glm::ivec2& window, bool glows, int filter) {
  bloom.composite.use();
  bloom.composite.set("uScene", 0); // texture units
  bloom.composite.set("uBloom", 1);
  bloom.composite.set("uGlows", glows);
  bloom.composite.set("uSize", glm::vec2(window));
  bloom.composite.set("uFilter", filter);
  if (glows) bindSum(bloom);
  showScene(bloom, window);
  unbindSum();
}

// What light is stored in: quality.bloom_format.
inline GLenum lightFormat(const gg::Scene& scene) {
  const GLenum formats[] = {GL_RGBA8, GL_R11F_G11F_B10F, GL_RGBA16F, GL_RGBA32F};
  return formats[scene.integer("quality.bloom_format")];
}

// Makes what has the size of the window, or a share of it.
inline void makeBloom(Bloom& bloom, const glm::ivec2& window, const gg::Scene& scene, bool glows) {
  makeScene(bloom, window, lightFormat(scene));
  if (glows)
    makeLevels(bloom, scene.integer("quality.bloom_levels"), lightFormat(scene),
               scene.integer("quality.bloom_edge") == 0 ? GL_CLAMP_TO_EDGE : GL_MIRRORED_REPEAT);
}

// The passes "bright", "down", "up" and "composite".
inline void bloomPasses(const Bloom& bloom, const glm::ivec2& window, const gg::Scene& scene,
                        bool glows) {
  const int filter = scene.integer("quality.bloom_filter");
  glDisable(GL_DEPTH_TEST);
  glActiveTexture(GL_TEXTURE0);
  if (glows) {
    glBindSampler(0, bloom.sampler);
    brightPass(bloom, scene.real("bloom.threshold"));
    downPasses(bloom, filter);
    upPasses(bloom, filter);
    glBindSampler(0, 0);
  }
  compositePass(bloom, window, glows, filter);
  glEnable(GL_DEPTH_TEST);
}

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
