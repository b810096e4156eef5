// post: what is done to a picture after it was drawn. Each can be switched off in scene.json.
//
// The passes of one frame:
//   scene         everything, in linear light                      -> a texture
//   mean          of a pixel's samples, if there are several       -> a texture
//   velocity      how far everything moved since the last frame    -> a texture
//   tiles         the fastest velocity of each tile, of its neighbours (if asked for)
//   motion blur   the picture, blurred along that                  -> a texture
//   afterglow     what is left of the last frame's glow, added     -> one of two textures, in turn
//   tone          as the screen shows it                           -> a texture, or the window
//   antialias     its edges made smooth                            -> the window

#include "afterglow.hpp"
#include "antialias.hpp"
#include "motion_blur.hpp"
#include "samples.hpp"
#include "world.hpp"

#include <optional>

void app(const gg::Scene& scene) {
  gg::Window window("post", scene.size);

  const gg::Program toneProgram({"screen.vert", "tone.frag"});
  const gg::Program showProgram({"screen.vert", "show.frag"});
  const gg::UniformBuffer<gg::Light> light(gg::kLightBinding);
  const gg::UniformBuffer<gg::Material> material(gg::kMaterialBinding);
  const World world;
  const Screen screen;
  SceneTarget target;
  // What a scene can't show isn't made.
  std::optional<MotionBlur> motion;
  std::optional<Glow> glow;
  std::optional<Antialias> antialias;
  if (showsMotion(scene)) motion.emplace();
  if (showsGlow(scene)) glow.emplace();
  std::optional<Samples> samples;
  if (scene.flag("effects.antialias")) {
    const auto method = static_cast<Method>(scene.integer("quality.antialias"));
    if (method == kMultisampled || method == kSupersampled)
      samples.emplace(method);
    else
      antialias.emplace(method);
  }

  const int picture = scene.integer("debug.picture");
  const auto velocity = static_cast<Velocity>(scene.integer("quality.velocity"));
  const int longest = scene.integer("quality.longest"); // of a blur, pixels
  const bool ofObjects = motion && velocity != kOfTheCamera;
  glm::ivec2 madeFor(0);
  std::optional<Moment> kept; // the last frame's, if there was one

  glEnable(GL_CULL_FACE);

  while (window) {
    const glm::ivec2 size(window.width(), window.height());
    if (madeFor != size) {
      makeSceneTarget(target, size, ofObjects);
      if (samples) makeSamples(*samples, size, ofObjects);
      if (motion) makeMotionBlur(*motion, size, velocity, longest);
      if (glow)
        makeGlow(*glow, size, scene.integer("quality.glow_bits") == 8 ? GL_RGBA8 : GL_RGBA16F);
      if (antialias) makeAntialias(*antialias, size);
      madeFor = size;
    }

    const double time = glfwGetTime();
    const Moment now{time, scene.camera.projection(window.aspect()), viewAt(scene, time)};
    const double sinceLast = kept ? time - kept->time : 0;
    Moment last = now; // as if nothing had moved
    // TODO(motion_blur.1): the last frame's moment, if there was a last frame.
    //   Given:  `kept`, which is the last frame's moment or empty.
    //   Expect: with velocity.frag, colours in the picture of velocities. (motion_blur.md, step 1)
    // BEGIN SOLUTION(motion_blur.1)
    if (kept) last = *kept;
    // END SOLUTION(motion_blur.1)
    kept = now;

    // Pass "scene".
    glBindFramebuffer(GL_FRAMEBUFFER, samples ? samples->framebuffer : target.framebuffer);
    const glm::ivec2 drawn = samples ? samples->size : size;
    glViewport(0, 0, drawn.x, drawn.y);
    const GLfloat background[4] = {scene.background.r, scene.background.g, scene.background.b, 1};
    const GLfloat nothing[4] = {0, 0, 0, 0}, farthest = 1;
    glClearBufferfv(GL_COLOR, 0, background);
    if (ofObjects) glClearBufferfv(GL_COLOR, 1, nothing);
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    glEnable(GL_DEPTH_TEST);
    light.load(scene.light.in(now.view));
    drawWorld(target.program, world, scene, material, kPattern, now, last);
    if (samples) drawMean(*samples, target, size, ofObjects, screen); // pass "mean"
    glDisable(GL_DEPTH_TEST);
    GLuint color = target.color; // the light so far

    if (motion) {
      // Pass "velocity": the objects have left theirs, or else all is at rest but the camera.
      if (velocity == kOfTheCamera) {
        const glm::dmat4 lastFromClip =
            glm::dmat4(last.clipFromWorld()) * glm::inverse(glm::dmat4(now.clipFromWorld()));
        glBindFramebuffer(GL_FRAMEBUFFER, motion->velocity.framebuffer);
        bind(kDepth, target.depth);
        motion->fromDepth.set("uDepth", int(kDepth));
        motion->fromDepth.set("uLastFromClip", glm::mat4(lastFromClip));
        screen.draw(motion->fromDepth);
      }
      bind(kVelocity, ofObjects ? target.velocity : motion->velocity.texture);

      // Passes "tiles" and "motion blur".
      bind(kColor, color);
      bind(kDepth, target.depth);
      if (velocity == kOfTheNeighbours) drawTiles(*motion, size, longest, screen);
      glBindFramebuffer(GL_FRAMEBUFFER, motion->blurred.framebuffer);
      const gg::Program& blur = velocity == kOfTheNeighbours ? motion->gather : motion->blur;
      blur.set("uColor", int(kColor));
      blur.set("uVelocity", int(kVelocity));
      blur.set("uShutter", scene.real("motion.shutter"));
      blur.set("uSamples", scene.integer("quality.samples"));
      blur.set("uLongest", float(longest));
      if (velocity == kOfTheNeighbours) {
        blur.set("uDepth", int(kDepth));
        blur.set("uNeighbours", int(kTiles));
        blur.set("uProjection", now.projection);
      }
      screen.draw(blur);
      color = motion->blurred.texture;
    }

    // Pass "afterglow".
    if (glow) {
      color =
          addGlow(*glow, color, decayAfter(sinceLast, scene.number("afterglow.seconds")), screen);
    }

    // Pass "tone".
    glBindFramebuffer(GL_FRAMEBUFFER, antialias ? GLuint(antialias->picture.framebuffer) : 0);
    bind(kColor, color);
    toneProgram.set("uColor", int(kColor));
    screen.draw(toneProgram);

    // Pass "antialias".
    if (antialias) {
      glBindFramebuffer(GL_FRAMEBUFFER, 0);
      drawAntialiased(*antialias, scene, screen);
    }

    // A picture to look at instead.
    if (picture == 3 && motion) {
      glBindFramebuffer(GL_FRAMEBUFFER, 0);
      showProgram.set("uVelocity", int(kVelocity));
      screen.draw(showProgram);
    }

    window.swapBuffers();
  }
}
