// deferred: objects turn slowly on a ground. First it is drawn what leaves their surfaces, or what
// the surfaces are like, into several textures at once; from these the picture is made.
//
// The passes of one frame, each drawn only if the scene can show it. Part targets:
//   - light: the objects' diffuse, specular and ambient light, into three textures
//   - compose: their sum, the diffuse edges emphasised, into the window
//
// Part figure, each pass into its own textures but for the last one:
//   - G-buffer: albedo, normal, identifiers and depth of the objects
//   - irradiance: what falls on each pixel's surface
//   - occlusion: how much of the half space above it is open
//   - occluded: the irradiance, less what the sky lacks there
//   - diffuse: that times the albedo, what the surfaces scatter
//   - reflected: the direction of view, mirrored
//   - Fresnel: how much is mirrored
//   - reflection: that times the environment in the mirrored direction
//   - composition: the sum, and the environment behind it
//   - show: a picture, most often the composition, into the window

#include "figure.hpp"
#include "targets.hpp"

#include <gg/gg.hpp>

#include <optional>

namespace {

constexpr float kFarthest = 1; // depth

// Which of the figure's pictures the window shows: the scene's debug.picture, until Page Down or
// Page Up goes on or back from it.
class ShownPicture {
public:
  explicit ShownPicture(const gg::Scene& scene) : number_(scene.integer("debug.picture")) {}

  Picture next(const gg::Window& window) {
    const int step = (glfwGetKey(window.handle(), GLFW_KEY_PAGE_DOWN) == GLFW_PRESS) -
                     (glfwGetKey(window.handle(), GLFW_KEY_PAGE_UP) == GLFW_PRESS);
    if (step != before_) number_ = (number_ + step + kCount) % kCount;
    before_ = step;
    return number_ == 0 ? Picture::composition : Picture(number_);
  }

private:
  static constexpr int kCount = 1 + int(Picture::all);
  int number_;
  int before_ = 0; // the step that the keys asked for last
};

} // namespace

void app(const gg::Scene& scene) {
  gg::Window window("deferred", scene.size);

  const Objects objects = makeObjects(scene);
  const gg::UniformBuffer<gg::Light> light(gg::kLightBinding);
  const gg::UniformBuffer<gg::Material> material(gg::kMaterialBinding);
  // What a scene can't show isn't made.
  std::optional<Targets> targets;
  std::optional<Figure> figure;
  if (scene.flag("effects.figure")) {
    figure.emplace();
    figure->gbuffer.hasAlbedo = anyMaterial(
        scene, [](const gg::Material& one) { return glm::vec3(one.diffuse) != glm::vec3(0); });
    makeEnvironment(figure->environment, scene, figure->gbuffer.hasAlbedo);
    addPasses(*figure, scene);
  } else if (scene.flag("effects.targets")) {
    targets.emplace();
    targets->needed = neededKinds(scene);
  }
  ShownPicture shown(scene);

  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);

  while (window) {
    const double time = glfwGetTime();
    const glm::ivec2 size(window.width(), window.height());
    const glm::mat4 projection = scene.camera.projection(window.aspect()); // clip from eye
    const glm::mat4 view = scene.camera.view();                            // eye from world
    light.load(scene.light.in(view));

    if (targets) {
      if (targets->size != size) makeTargets(*targets, size, lightFormat(scene));
      // Pass "light": all objects once, three kinds of light.
      // TODO(targets.2): draw into the three textures instead of the window.
      //   Given:  `targets`. The lines below clear the first colour buffer to the background, and
      //           the depth, of whatever is bound.
      //   Goal:   they are the framebuffer object's, and its other two colour buffers are black
      //           where no object is. After the objects, the window is drawn into again.
      //           Then composeTargets() in targets.hpp.               (targets.md, step 2)
      // BEGIN SOLUTION(targets.2)
      glBindFramebuffer(GL_FRAMEBUFFER, targets->framebuffer);
      const glm::vec4 black(0, 0, 0, 1);
      glClearBufferfv(GL_COLOR, kSpecular, &black[0]);
      glClearBufferfv(GL_COLOR, kAmbient, &black[0]);
      // END SOLUTION(targets.2)
      const glm::vec4 background(scene.background, 1);
      glClearBufferfv(GL_COLOR, 0, &background[0]);
      glClearBufferfv(GL_DEPTH, 0, &kFarthest);
      drawObjects(targets->light, projection, view, objects, material, scene, time);
      // BEGIN SOLUTION(targets.2)
      glBindFramebuffer(GL_FRAMEBUFFER, 0);
      // END SOLUTION(targets.2)

      // Pass "compose": the sum, into the window.
      glDisable(GL_DEPTH_TEST);
      composeTargets(*targets, scene.flag("effects.edges"));
      glEnable(GL_DEPTH_TEST);
    }

    if (figure) {
      if (figure->size != size) {
        makeGBuffer(figure->gbuffer, size, lightFormat(scene), directionFormat(scene),
                    idFormat(scene));
        makePasses(*figure, size);
        figure->size = size;
      }
      // Pass "G-buffer": all objects once, what their surfaces are like.
      // TODO(figure.1): draw into the G-buffer instead of the window.
      //   Given:  `figure`. The lines below clear the first colour buffer to black, and the depth,
      //           of whatever is bound.
      //   Goal:   they are the G-buffer's, and its normals and identifiers (whole numbers) are 0
      //           where no object is. After the objects, the other pictures are drawn, and one is
      //           shown in the window: drawPasses(), showPicture(), without a depth test.
      //   Expect: the same flat colours, brighter.                       (figure.md, step 1)
      const glm::vec4 black(0);
      // BEGIN SOLUTION(figure.1)
      glBindFramebuffer(GL_FRAMEBUFFER, figure->gbuffer.framebuffer);
      glClearBufferfv(GL_COLOR, 1, &black[0]);
      constexpr GLuint kNothing[4] = {};
      glClearBufferuiv(GL_COLOR, 2, kNothing);
      // END SOLUTION(figure.1)
      glClearBufferfv(GL_COLOR, 0, &black[0]);
      glClearBufferfv(GL_DEPTH, 0, &kFarthest);
      figure->gbuffer.program.set("uEncoding", scene.integer("quality.normal"));
      drawObjects(figure->gbuffer.program, projection, view, objects, material, scene, time);
      // BEGIN SOLUTION(figure.1)
      glBindFramebuffer(GL_FRAMEBUFFER, 0);

      // The passes after it, over the whole picture; no pixel lies behind another there.
      glDisable(GL_DEPTH_TEST);
      drawPasses(*figure, scene, projection, view);
      showPicture(*figure, scene, projection, view, shown.next(window));
      glEnable(GL_DEPTH_TEST);
      // END SOLUTION(figure.1)
    }

    window.swapBuffers();
  }
}
