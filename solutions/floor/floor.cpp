// floor: objects hop in a ring over a chequered floor, and the floor reflects them.
//
// The passes of one frame:
//   mirror   the objects as the floor sees them  -> a framebuffer object
//   objects  the objects themselves              -> the window
//   floor    the floor, adding the reflection    -> the window

#include <gg/gg.hpp>

namespace {

constexpr float kPi = 3.14159265f;

// The framebuffer object that the mirror pass draws into. The floor samples `color`; nobody reads
// `depth` afterwards, so a renderbuffer is enough for it.
struct Reflection {
  gg::Texture color;
  gg::Renderbuffer depth;
  gg::Framebuffer framebuffer;
  GLsizei size = 0; // pixels, width and height
};

// TODO(mirror.1): make the framebuffer object of the reflection.
//   Given:  `size` (pixels) and the names in `reflection` (made, still empty).
//   Do:     storage for `color` (linear filter, clamp to edge) and `depth`; attach both to
//           `framebuffer`; throw std::runtime_error if it isn't complete; bind the window again.
//   Expect: the picture doesn't change yet.                             (handout: step 1)
void makeReflection(Reflection& reflection, GLsizei size) {
  reflection.size = size;
  // BEGIN SOLUTION(mirror.1)
  glBindTexture(GL_TEXTURE_2D, reflection.color);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);

  glBindRenderbuffer(GL_RENDERBUFFER, reflection.depth);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size, size);

  glBindFramebuffer(GL_FRAMEBUFFER, reflection.framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, reflection.color, 0);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, reflection.depth);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("the reflection's framebuffer object is not complete");
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  // END SOLUTION(mirror.1)
}

// The object's own colour: six that can be told apart.
glm::vec3 objectColor(int i) {
  return {(i & 1) * 0.4f + 0.4f, (i & 2) * 0.2f + 0.4f, (i & 4) * 0.1f + 0.4f};
}

// Draws the ring of hopping objects with `program`.
//   projection: clip from eye;  view: eye from world;  time: seconds
void drawObjects(const gg::Program& program, const glm::mat4& projection, const glm::mat4& view,
                 const gg::Mesh& mesh, const gg::UniformBuffer<gg::Material>& material,
                 const gg::Scene& scene, double time) {
  const int count = scene.integer("ring.count");
  const double cycle = scene.number("ring.cycle");
  const float t = static_cast<float>(std::fmod(time, cycle) / cycle); // 0 to 1, once a cycle
  const float h = std::fmod(36.0f * t, 2.0f) - 1.0f;
  const float height = scene.real("ring.base") + scene.real("ring.hop") * (1.0f - h * h);
  for (int i = 1; i <= count; ++i) {
    const float angle = kPi * (2.0f * i / count - 4.0f * t);
    glm::mat4 model = glm::rotate(glm::mat4(1), angle, {0, 1, 0});
    model = glm::translate(model, {0, height, scene.real("ring.radius")});
    model = glm::scale(model, glm::vec3(scene.real("ring.scale")));

    gg::Material own = scene.material("object");
    own.ambient *= glm::vec4(objectColor(i), 1);
    own.diffuse *= glm::vec4(objectColor(i), 1);
    material.load(own);

    program.set("uProjection", projection);
    program.set("uView", view);
    program.set("uModel", model);
    program.set("uNormal", gg::cofactor(view * model));
    mesh.draw();
  }
}

// Can this view show a reflection? Not if the effect is off, the floor reflects nothing, the eye is
// not above the floor, or the whole floor lies outside one side of the view volume.
bool showsReflection(const gg::Scene& scene, const glm::mat4& clipFromWorld) {
  if (!scene.flag("effects.mirror")) return false;
  if (scene.flag("debug.draw_all_passes")) return true;
  if (glm::vec3(scene.material("floor").specular) == glm::vec3(0)) return false;
  if (scene.camera.position.y <= 0) return false;

  const float x = scene.real("floor.width") / 2, z = scene.real("floor.depth") / 2;
  const glm::vec4 corners[] = {
      clipFromWorld * glm::vec4(-x, 0, -z, 1), clipFromWorld * glm::vec4(x, 0, -z, 1),
      clipFromWorld * glm::vec4(-x, 0, z, 1), clipFromWorld * glm::vec4(x, 0, z, 1)};
  for (int axis = 0; axis < 3; ++axis) {
    for (float side : {-1.0f, 1.0f}) {
      const auto outside = [&](const glm::vec4& corner) { return side * corner[axis] > corner.w; };
      if (std::all_of(std::begin(corners), std::end(corners), outside)) return false;
    }
  }
  return true;
}

} // namespace

void app(const gg::Scene& scene) {
  gg::Window window("floor", scene.size);

  const gg::Program objectProgram({"object.vert", "object.frag"});
  const gg::Program mirrorProgram({"mirror.vert", "object.frag"});
  const gg::Program tileProgram({"tile.vert", "tile.frag"});

  const gg::Mesh object = gg::loadMesh(scene.text("mesh"));
  const gg::Mesh rectangle = gg::plane(scene.real("floor.width"), scene.real("floor.depth"));
  const gg::UniformBuffer<gg::Light> light(gg::kLightBinding);
  const gg::UniformBuffer<gg::Material> material(gg::kMaterialBinding);
  Reflection reflection;

  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glClearColor(scene.background.r, scene.background.g, scene.background.b, 1);

  while (window) {
    const double time = glfwGetTime();
    const glm::mat4 projection = scene.camera.projection(window.aspect()); // clip from eye
    const glm::mat4 view = scene.camera.view();                            // eye from world
    const bool mirror = showsReflection(scene, projection * view);

    // Pass "mirror": the objects as the floor sees them, into the framebuffer object.
    if (mirror) {
      if (reflection.size == 0) makeReflection(reflection, scene.integer("quality.mirror_size"));

      // TODO(mirror.2): draw into the framebuffer object instead of the window.
      //   Given:  `reflection`.
      //   Do:     bind its framebuffer, set the viewport to its size, clear colour and depth.
      //           Below, at the end of the pass: bind the window (0), set its viewport again.
      //   Expect: the picture still doesn't change.                   (handout: step 2)
      // BEGIN SOLUTION(mirror.2)
      glBindFramebuffer(GL_FRAMEBUFFER, reflection.framebuffer);
      glViewport(0, 0, reflection.size, reflection.size);
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      // END SOLUTION(mirror.2)

      // TODO(mirror.5): a mirror turns every triangle round: cull the front faces here, the back
      //   faces again below, and negate the normal in mirror.vert.
      //   Expect: solid objects in the floor, lit like the real ones. (handout: step 5)
      // BEGIN SOLUTION(mirror.5)
      glCullFace(GL_FRONT);
      // END SOLUTION(mirror.5)

      // TODO(mirror.6): clip away what lies below the floor: enable GL_CLIP_DISTANCE0 here,
      //   disable it below, and write gl_ClipDistance[0] in mirror.vert.
      //   Expect: sunken objects no longer stick out of the floor.    (handout: step 6)
      // BEGIN SOLUTION(mirror.6)
      const bool clip = scene.integer("quality.mirror_clip") > 0;
      mirrorProgram.set("uClip", clip);
      if (clip) glEnable(GL_CLIP_DISTANCE0);
      // END SOLUTION(mirror.6)

      // TODO(mirror.4): draw the objects mirrored at the plane y = 0.
      //   Given:  `projection`, `view`, drawObjects(), `mirrorProgram`, `light`.
      //   Do:     the mirrored view is the view times a scale of (1, -1, 1); load the light in the
      //           space of that view (scene.light.in(...)); draw with `mirrorProgram`.
      //   Expect: coloured shapes appear in the floor, inside out.    (handout: step 4)
      // BEGIN SOLUTION(mirror.4)
      const glm::mat4 mirroredView = view * glm::scale(glm::mat4(1), glm::vec3(1, -1, 1));
      light.load(scene.light.in(mirroredView));
      mirrorProgram.use();
      drawObjects(mirrorProgram, projection, mirroredView, object, material, scene, time);
      // END SOLUTION(mirror.4)

      // TODO(mirror.6) and TODO(mirror.5) end here, then TODO(mirror.2).
      // BEGIN SOLUTION(mirror.6)
      glDisable(GL_CLIP_DISTANCE0);
      // END SOLUTION(mirror.6)
      // BEGIN SOLUTION(mirror.5)
      glCullFace(GL_BACK);
      // END SOLUTION(mirror.5)
      // BEGIN SOLUTION(mirror.2)
      glBindFramebuffer(GL_FRAMEBUFFER, 0);
      glViewport(0, 0, window.width(), window.height());
      // END SOLUTION(mirror.2)
    }

    // Pass "objects": into the window.
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    light.load(scene.light.in(view));
    objectProgram.use();
    drawObjects(objectProgram, projection, view, object, material, scene, time);

    // Pass "floor": into the window.
    tileProgram.use();
    tileProgram.set("uProjection", projection);
    tileProgram.set("uView", view);
    tileProgram.set("uTilesPerUnit", scene.real("floor.tiles_per_unit"));
    tileProgram.set("uViewport", glm::vec2(window.width(), window.height()));
    tileProgram.set("uMirror", mirror);
    tileProgram.set("uBlurSigma", scene.real("mirror.blur"));
    tileProgram.set("uBlurSamples", scene.integer("quality.blur_samples"));
    tileProgram.set("uReflection", 0); // texture unit
    // TODO(mirror.3): let the floor sample the reflection: bind its colour texture to unit 0 here,
    //   and add it in tile.frag.
    //   Expect: the floor takes on the tint of the background.        (handout: step 3)
    // BEGIN SOLUTION(mirror.3)
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, reflection.color);
    // END SOLUTION(mirror.3)
    material.load(scene.material("floor"));
    rectangle.draw();

    window.swapBuffers();
  }
}
