// new_assignment: an object turns in the light of one lamp.
//
// The passes of one frame:
//   object  the object  -> the window

#include <gg/gg.hpp>

void app(const gg::Scene& scene) {
  gg::Window window("new_assignment", scene.size);

  const gg::Program program({"object.vert", "object.frag"});
  const gg::Mesh object = gg::loadMesh(scene.text("mesh"));
  const gg::UniformBuffer<gg::Light> light(gg::kLightBinding);
  const gg::UniformBuffer<gg::Material> material(gg::kMaterialBinding);

  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glClearColor(scene.background.r, scene.background.g, scene.background.b, 1);

  while (window) {
    const float time = static_cast<float>(glfwGetTime());
    const glm::mat4 projection = scene.camera.projection(window.aspect()); // clip from eye
    const glm::mat4 view = scene.camera.view();                            // eye from world
    const glm::mat4 model =                                                // world from model
        glm::rotate(glm::mat4(1), scene.real("object.turn") * time, {0, 1, 0});

    // Pass "object".
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    light.load(scene.light.in(view));
    material.load(scene.material("object"));
    program.use();
    program.set("uProjection", projection);
    program.set("uModelView", view * model);
    program.set("uNormal", gg::cofactor(view * model));
    object.draw();

    window.swapBuffers();
  }
}
