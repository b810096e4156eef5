// Antialiasing: the displayed picture in a texture, and its edges made smooth.
#pragma once

#include "smaa_tables.hpp"
#include "targets.hpp"

#include <optional>

// How edges are made smooth: quality.antialias. The last two are the scene's own (samples.hpp).
enum Method { kFxaa, kSmaa, kMlaa, kMultisampled, kSupersampled };

// An occlusion query.
struct QueryTraits {
  static GLuint create() {
    GLuint name = 0;
    glGenQueries(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteQueries(1, &name); }
};
using Query = gg::Handle<QueryTraits>;

// quality.smaa_preset: low, medium, high, ultra.
struct SmaaPreset {
  float threshold;   // luma's difference across an edge
  int steps;         // of a search along a row or column
  int diagonalSteps; // 0: no diagonals
  float rounding;    // of corners; 1: corners aren't looked for
};
inline constexpr SmaaPreset kSmaaPresets[] = {
    {0.15f, 4, 0, 1}, {0.1f, 8, 0, 1}, {0.1f, 16, 8, 0.25f}, {0.05f, 32, 16, 0.25f}};

inline void makeTable(const gg::Texture& texture, Unit unit, GLint filter, const Table& table) {
  makeStorage(texture, unit, GL_RG8, filter, table.size);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, table.size.x, table.size.y, GL_RG, GL_FLOAT,
                  table.texels.data());
}

// SMAA or MLAA. Both find edges, then weights by the edges' shapes, then blend.
struct Shapes {
  explicit Shapes(Method method)
      : weights({"screen.vert", method == kSmaa ? "smaa_weights.frag" : "mlaa_weights.frag"}) {
    if (method != kSmaa) return;
    tables.emplace();
    makeTable(tables->areas, kAreas, GL_LINEAR, areaTable());
    makeTable(tables->search, kSearch, GL_NEAREST, searchTable());
  }

  gg::Program edges{{"screen.vert", "smaa_edges.frag"}};
  gg::Program weights;
  gg::Program blend{{"screen.vert", "smaa_blend.frag"}};
  Target edgesTarget, weightsTarget;
  Query anyEdge;
  struct Tables {
    gg::Texture areas, search;
  };
  std::optional<Tables> tables; // SMAA's
};

// What the scene's method doesn't need isn't made.
struct Antialias {
  explicit Antialias(Method method) {
    if (method == kFxaa)
      fxaa.emplace(std::initializer_list<const char*>{"screen.vert", "fxaa.frag"});
    else
      shapes.emplace(method);
  }

  std::optional<gg::Program> fxaa;
  std::optional<Shapes> shapes;
  Target picture; // as displayed; alpha: luma
};

inline void makeAntialias(const Antialias& antialias, const glm::ivec2& size) {
  makeTarget(antialias.picture, kPicture, GL_RGBA8, GL_LINEAR, size, "picture");
  if (!antialias.shapes) return;
  const Shapes& shapes = *antialias.shapes;
  makeTarget(shapes.edgesTarget, kEdges, GL_RG8, GL_LINEAR, size, "edges");
  makeTarget(shapes.weightsTarget, kWeights, GL_RGBA8, GL_NEAREST, size, "weights");
}

// Draws the picture in unit kPicture into the window, with smooth edges.
inline void drawFxaa(const gg::Program& program, const gg::Scene& scene, const Screen& screen) {
  const int picture = scene.integer("debug.picture");
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  program.set("uPicture", int(kPicture));
  program.set("uSteps", scene.integer("quality.search_steps"));
  program.set("uSubpixel", scene.real("quality.subpixel"));
  program.set("uShow", picture == 1 || picture == 2 ? picture : 0);
  screen.draw(program);
}

inline void drawShapes(const Shapes& shapes, const gg::Scene& scene, const Screen& screen) {
  const bool smaa = shapes.tables.has_value();
  const bool show = scene.integer("debug.picture") == 1; // the edges, in the window
  const SmaaPreset& preset = kSmaaPresets[scene.integer("quality.smaa_preset")];
  const GLfloat nothing[4] = {0, 0, 0, 0};

  // Pass "edges". MLAA has no local contrast: all that is steep enough is an edge.
  glBindFramebuffer(GL_FRAMEBUFFER, show ? 0 : GLuint(shapes.edgesTarget.framebuffer));
  glClearBufferfv(GL_COLOR, 0, nothing);
  shapes.edges.set("uPicture", int(kPicture));
  shapes.edges.set("uThreshold", smaa ? preset.threshold : 0.1f);
  shapes.edges.set("uLocalContrast", smaa ? 2.0f : 1e6f);
  glBeginQuery(GL_ANY_SAMPLES_PASSED, shapes.anyEdge);
  screen.draw(shapes.edges);
  glEndQuery(GL_ANY_SAMPLES_PASSED);
  if (show) return;

  // Pass "weights", unless there is no edge at all. Its answer is waited for; with
  // glBeginConditionalRender the GPU alone would wait, but the program wouldn't know what was
  // drawn.
  GLuint anyEdge = 0;
  glGetQueryObjectuiv(shapes.anyEdge, GL_QUERY_RESULT, &anyEdge);
  glBindFramebuffer(GL_FRAMEBUFFER, shapes.weightsTarget.framebuffer);
  glClearBufferfv(GL_COLOR, 0, nothing);
  if (anyEdge || scene.flag("debug.draw_all_passes")) {
    bind(kEdges, shapes.edgesTarget.texture);
    shapes.weights.set("uEdges", int(kEdges));
    if (smaa) {
      bind(kAreas, shapes.tables->areas);
      bind(kSearch, shapes.tables->search);
      shapes.weights.set("uAreas", int(kAreas));
      shapes.weights.set("uSearch", int(kSearch));
      shapes.weights.set("uSteps", preset.steps);
      shapes.weights.set("uDiagonalSteps", preset.diagonalSteps);
      shapes.weights.set("uRounding", preset.rounding);
    }
    screen.draw(shapes.weights);
  }

  // Pass "blend".
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  bind(kWeights, shapes.weightsTarget.texture);
  shapes.blend.set("uPicture", int(kPicture));
  shapes.blend.set("uWeights", int(kWeights));
  screen.draw(shapes.blend);
}

// Draws antialias.picture into the window, with smooth edges.
inline void drawAntialiased(const Antialias& antialias, const gg::Scene& scene,
                            const Screen& screen) {
  bind(kPicture, antialias.picture.texture);
  if (antialias.fxaa) drawFxaa(*antialias.fxaa, scene, screen);
  if (antialias.shapes) drawShapes(*antialias.shapes, scene, screen);
}
