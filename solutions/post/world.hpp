// What is drawn: everything that pictures of moving things fail at. A chequered ground, a fan of
// wires as thin as a pixel at every angle, a board with letters, a rippled ball that glitters, a
// slow ball and a fast box whose ways cross, and a bright lamp that flies around.
#pragma once

#include <gg/gg.hpp>

enum class Shape { plane, box, ball };
enum class Pattern { none, squares, letters };

struct Thing {
  Shape shape;
  glm::vec3 color;
  Pattern pattern = Pattern::none;
  float ripples = 0;  // how steep those of its surface are
  float emission = 0; // light that it gives off itself
};

inline constexpr int kWires = 25; // an odd number: no two of them are parallel

// Sines of the time, so that the things go to and fro.
inline float swing(double time, double period, double phase = 0) {
  return static_cast<float>(std::sin(6.283185307179586 * (std::fmod(time / period, 1.0) + phase)));
}

// The things, and where each of them is at a time: world from model. Their number and order are
// always the same.
//   place(thing, worldFromModel)
template <class Place> void placeThings(const gg::Scene& scene, double time, Place place) {
  const glm::mat4 world(1);
  const auto at = [&](const glm::vec3& position, const glm::vec3& size) {
    return glm::scale(glm::translate(world, position), size);
  };
  const double t = scene.number("motion.speed") * time;

  place(Thing{Shape::plane, glm::vec3(1), Pattern::squares}, world);

  const glm::vec3 hub(-1.7f, 1.15f, -1.2f);
  const float thick = scene.real("wires.thickness");
  for (int i = 0; i < kWires; ++i) {
    const float angle = 6.28318531f * static_cast<float>(i) / kWires;
    const glm::mat4 turned = glm::rotate(glm::translate(world, hub), angle, {0, 0, 1});
    place(Thing{Shape::box, {0.05f, 0.05f, 0.08f}},
          glm::scale(glm::translate(turned, {0, 0.3f, 0}), {thick, 0.75f, thick}));
  }

  const glm::mat4 board =
      glm::rotate(glm::translate(world, {1.75f, 0.95f, -1.3f}), -0.35f, {0, 1, 0});
  place(Thing{Shape::plane, glm::vec3(1), Pattern::letters},
        glm::scale(glm::rotate(board, 1.57079633f, {1, 0, 0}), {1.7f, 1, 1.2f}));

  place(Thing{Shape::ball, {0.35f, 0.45f, 0.75f}, Pattern::none, 0.35f},
        at({0.55f, 0.45f, 0.9f}, glm::vec3(0.45f)));
  // The two that cross: the box before the ball.
  place(Thing{Shape::ball, {0.8f, 0.3f, 0.2f}},
        at({0.9f * swing(t, 5), 0.5f, -0.2f}, glm::vec3(0.5f)));
  place(Thing{Shape::box, {0.25f, 0.65f, 0.3f}},
        glm::rotate(at({-1.6f * swing(t, 1.4), 0.02f, 0.6f}, glm::vec3(0.5f, 0.8f, 0.5f)), 0.5f,
                    {0, 1, 0}));
  place(Thing{Shape::ball, {1, 0.85f, 0.5f}, Pattern::none, 0, scene.real("lamp.brightness")},
        at({1.5f * swing(t, 2.2), 1.75f + 0.35f * swing(t, 1.1), 0.3f * swing(t, 2.2, 0.25)},
           glm::vec3(0.09f)));
}

// A ball of radius 1 around the origin.
inline gg::MeshData makeBall(int around = 48) {
  gg::MeshData ball;
  const int up = around / 2;
  for (int j = 0; j <= up; ++j)
    for (int i = 0; i <= around; ++i) {
      const glm::vec2 uv(static_cast<float>(i) / static_cast<float>(around),
                         static_cast<float>(j) / static_cast<float>(up));
      const float a = 6.28318531f * uv.x, b = 3.14159265f * (uv.y - 0.5f);
      const glm::vec3 p(std::cos(b) * std::sin(a), std::sin(b), std::cos(b) * std::cos(a));
      ball.positions.push_back(p);
      ball.normals.push_back(p);
      ball.uvs.push_back(uv);
      ball.tangents.emplace_back(std::cos(a), 0, -std::sin(a), 1);
    }
  const auto index = [&](int i, int j) { return static_cast<std::uint32_t>(j * (around + 1) + i); };
  for (int j = 0; j < up; ++j)
    for (int i = 0; i < around; ++i)
      for (const std::uint32_t k : {index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j),
                                    index(i + 1, j + 1), index(i, j + 1)})
        ball.indices.push_back(k);
  return ball;
}

// White letters on a dark board.
inline gg::Image makeLetters() {
  static constexpr const char* kRows[] = {
      " ####  ####  ####   ##   ####  ##### ", //
      "#     #      #   # #  #  #   # #     ", //
      "#     #      #   # #  #  #   # #     ", //
      "#  ## #  ### ####  ####  #   # ####  ", //
      "#   # #    # # #   #  #  #   # #     ", //
      "#   # #    # #  #  #  #  #   # #     ", //
      " ###   ####  #   # #  #  ####  ##### ", //
  };
  gg::Image image{80, 40, std::vector<std::uint8_t>(80 * 40 * 4, 40)};
  for (int y = 0; y < 14; ++y)
    for (int x = 0; x < 74; ++x)
      if (kRows[y / 2][x / 2] == '#')
        for (int c = 0; c < 3; ++c)
          image.rgba[static_cast<std::size_t>((27 - y) * 80 + 3 + x) * 4 +
                     static_cast<std::size_t>(c)] = 240;
  return image;
}

// The camera on its way around what it looks at.
inline glm::mat4 viewAt(const gg::Scene& scene, double time) {
  gg::Camera camera = scene.camera;
  const auto angle =
      static_cast<float>(0.5 * std::sin(2 * scene.number("motion.turn") * time)); // radians
  const glm::vec3 from = camera.position - camera.target;
  camera.position =
      camera.target + glm::vec3(glm::rotate(glm::mat4(1), angle, {0, 1, 0}) * glm::vec4(from, 0));
  return camera.view();
}

// When and from where a frame shows the scene.
struct Moment {
  double time = 0;         // seconds
  glm::mat4 projection{1}; // clip from eye
  glm::mat4 view{1};       // eye from world
  glm::mat4 clipFromWorld() const { return projection * view; }
};

struct World {
  gg::Mesh plane = gg::plane(1, 1), box = gg::box(), ball = makeBall();
  gg::Texture squares = gg::makeTexture(gg::checkerImage(64, 2, glm::vec3(0.85f), glm::vec3(0.2f)));
  gg::Texture letters = gg::makeTexture(makeLetters());
};

// Draws all of it with `program`, whose pattern is read from texture unit `unit`.
//   last: of the frame before
inline void drawWorld(const gg::Program& program, const World& world, const gg::Scene& scene,
                      const gg::UniformBuffer<gg::Material>& material, int unit, const Moment& now,
                      const Moment& last) {
  std::vector<glm::mat4> lastPlaces; // world from model
  placeThings(scene, last.time,
              [&](const Thing&, const glm::mat4& model) { lastPlaces.push_back(model); });
  program.use();
  program.set("uProjection", now.projection);
  program.set("uView", now.view);
  program.set("uPattern", unit);
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  std::size_t index = 0;
  placeThings(scene, now.time, [&](const Thing& thing, glm::mat4 model) {
    glm::mat4 lastModel = lastPlaces[index++];
    gg::Material own = scene.material(thing.ripples > 0 ? "glitter" : "matt");
    own.ambient *= glm::vec4(thing.color, 1);
    own.diffuse *= glm::vec4(thing.color, 1);
    material.load(own);
    if (thing.pattern == Pattern::squares) {
      const float size = scene.real("ground.size");
      model = glm::scale(model, glm::vec3(size));
      lastModel = glm::scale(lastModel, glm::vec3(size));
    }
    glBindTexture(GL_TEXTURE_2D, thing.pattern == Pattern::letters ? world.letters : world.squares);
    program.set("uHasPattern", thing.pattern != Pattern::none);
    program.set("uRepeat", thing.pattern == Pattern::squares ? scene.real("ground.size") : 1.0f);
    program.set("uRipples", thing.ripples);
    program.set("uEmission", thing.emission * thing.color);
    program.set("uModel", model);
    program.set("uNormal", gg::cofactor(now.view * model));
    program.set("uLastFromModel", last.clipFromWorld() * lastModel);
    const gg::Mesh& mesh = thing.shape == Shape::plane ? world.plane
                           : thing.shape == Shape::box ? world.box
                                                       : world.ball;
    mesh.draw();
  });
}
