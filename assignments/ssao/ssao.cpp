// ssao: where surfaces come close to each other, less of the light that comes from all sides gets
// in. What keeps it out is looked for in the depth buffer.
//
// The passes of one frame:
//   G-buffer    what is seen: normal, ambient light, direct light, depth  -> four textures
//   occlusion   how open each surface is, by the depths around it         -> a texture
//   blur        its noise removed, along rows, then along columns         -> the same texture
//   composite   ambient light times that, and direct light                -> the window

#include "still_life.hpp"
#include "targets.hpp"

#include <gg/gg.hpp>

#include <optional>

namespace {

// The passes behind the G-buffer draw one triangle over the whole target, without depths.
struct Screen {
  gg::VertexArray noVertices; // screen.vert makes its own corners

  void draw(const gg::Program& program) const {
    program.use();
    glBindVertexArray(noVertices);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
};

// The light of both kinds, and the normal if it is asked for, into the G-buffer.
void clearGBuffer(const gg::Scene& scene) {
  const GLfloat nothing[4] = {0, 0, 0, 0}, farthest = 1;
  const GLfloat background[4] = {scene.background.r, scene.background.g, scene.background.b, 1};
  glClearBufferfv(GL_COLOR, 0, nothing);
  glClearBufferfv(GL_COLOR, 1, background);
  glClearBufferfv(GL_COLOR, 2, nothing);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
}

} // namespace

void app(const gg::Scene& scene) {
  gg::Window window("ssao", scene.size);

  const gg::Program compositeProgram({"screen.vert", "composite.frag"});
  const gg::Program showProgram({"screen.vert", "show.frag"});
  const gg::UniformBuffer<gg::Light> light(gg::kLightBinding);
  const gg::UniformBuffer<gg::Material> material(gg::kMaterialBinding);
  const StillLife life = makeStillLife(scene);
  const Screen screen;
  GBuffer gbuffer;
  // What a scene can't show isn't made.
  std::optional<Occlusion> occlusion;
  if (showsOcclusion(scene)) occlusion.emplace();

  const int scale = scene.integer("quality.resolution"); // window pixels to one of the occlusion's
  const int blur = scene.integer("quality.blur");
  const int picture = scene.integer("debug.picture");
  const bool normals = occlusion || picture == 1;

  glEnable(GL_CULL_FACE);

  while (window) {
    const glm::ivec2 size(window.width(), window.height());
    const glm::mat4 projection = scene.camera.projection(window.aspect()); // clip from eye
    const glm::mat4 view = scene.camera.view();                            // eye from world
    if (gbuffer.size != size) {
      makeGBuffer(gbuffer, size, normals);
      if (occlusion) makeOcclusion(*occlusion, (size + scale - 1) / scale, blur > 0);
    }

    // Pass "G-buffer".
    glBindFramebuffer(GL_FRAMEBUFFER, gbuffer.framebuffer);
    glViewport(0, 0, size.x, size.y);
    glEnable(GL_DEPTH_TEST);
    clearGBuffer(scene);
    light.load(scene.light.in(view));
    drawStillLife(gbuffer.program, projection, view, life, material, scene, glfwGetTime());
    glDisable(GL_DEPTH_TEST);

    // What the shaders behind it read: every texture in the unit of its name.
    const auto bind = [](Unit unit, GLuint texture) {
      glActiveTexture(GL_TEXTURE0 + unit);
      glBindTexture(GL_TEXTURE_2D, texture);
    };
    bind(kDepth, gbuffer.depth);
    bind(kNormals, normals ? GLuint(gbuffer.normals) : 0);
    bind(kAmbient, gbuffer.ambient);
    bind(kDirect, gbuffer.direct);
    const auto setAll = [&](const gg::Program& program) {
      program.set("uDepth", int(kDepth));
      program.set("uNormals", int(kNormals));
      program.set("uProjection", projection);
      program.set("uRadius", scene.real("ao.radius"));
      program.set("uScale", scale);
    };

    if (occlusion) {
      // Pass "occlusion".
      bind(kOcclusion, 0);
      glBindFramebuffer(GL_FRAMEBUFFER, occlusion->framebuffers[0]);
      glViewport(0, 0, occlusion->size.x, occlusion->size.y);
      setAll(occlusion->find);
      occlusion->find.set("uMethod", scene.integer("quality.method"));
      occlusion->find.set("uSamples", scene.integer("quality.samples"));
      screen.draw(occlusion->find);

      // Pass "blur", twice.
      if (blur > 0) {
        setAll(occlusion->blur);
        occlusion->blur.set("uOcclusion", int(kOcclusion));
        occlusion->blur.set("uReach", blur);
        for (const int from : {0, 1}) {
          glBindFramebuffer(GL_FRAMEBUFFER, occlusion->framebuffers[std::size_t(1 - from)]);
          bind(kOcclusion, occlusion->open[std::size_t(from)]);
          occlusion->blur.set("uAlongColumns", from == 1);
          screen.draw(occlusion->blur);
        }
      }
    }

    // Pass "composite", or the picture to look at instead.
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.x, size.y);
    bind(kOcclusion, occlusion ? GLuint(occlusion->open[0]) : 0);
    const gg::Program& last = picture == 0 ? compositeProgram : showProgram;
    setAll(last);
    last.set("uOcclusion", int(kOcclusion));
    last.set("uHasOcclusion", occlusion.has_value());
    if (picture == 0) {
      last.set("uAmbient", int(kAmbient));
      last.set("uDirect", int(kDirect));
    } else {
      last.set("uPicture", picture);
    }
    screen.draw(last);

    window.swapBuffers();
  }
}
