// The mirror: where the reflection is drawn, the pass that draws it, and whether it can be seen.
#pragma once

#include <gg/gg.hpp>

#include <functional>

// Draws all objects: draw(program, projection, view).
//   projection: clip from eye;  view: eye from world
using Draw = std::function<void(const gg::Program& program, const glm::mat4& projection,
                                const glm::mat4& view)>;

// The framebuffer object that the mirror pass draws into. The floor samples `color`; nobody reads
// `depth` afterwards, so a renderbuffer is enough for it.
struct Reflection {
  gg::Texture color;
  gg::Renderbuffer depth;
  gg::Framebuffer framebuffer;
  GLsizei size = 0; // pixels, width and height
};

// TODO(mirror.1): make the framebuffer object of the reflection.
//   Given:  `size` (pixels), `format` (GL_RGBA8; with bloom GL_RGBA16F, for light beyond 1) and the
//           names in `reflection` (made, still empty). Its size, set here, says that it was made.
//   Goal:   `framebuffer` is complete, with `color`, which the floor will sample, and `depth`; if
//           it isn't, std::runtime_error is thrown. Afterwards the window is bound.
//   Expect: the picture doesn't change yet.                             (mirror.md, step 1)
inline void makeReflection(Reflection& reflection, GLsizei size, GLenum format) {
  reflection.size = size;
  // BEGIN SOLUTION(mirror.1)
  glBindTexture(GL_TEXTURE_2D, reflection.color);
  glTexImage2D(GL_TEXTURE_2D, 0, format, size, size, 0, GL_RGBA, GL_FLOAT, nullptr);
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
  glBindTexture(GL_TEXTURE_2D, 0); // so that nobody samples it by chance
}

// TODO(mirror.2): draw into the framebuffer object instead of the window, and come back.
//   Given:  `reflection`; `window`, the window's size (pixels).
//   Goal:   what is drawn between these two functions covers all of the texture, where nothing is
//           left of the last frame; what is drawn after them covers all of the window.
//   Expect: the picture still doesn't change.                           (mirror.md, step 2)
inline void beginMirrorPass(const Reflection& reflection) {
  // BEGIN SOLUTION(mirror.2)
  glBindFramebuffer(GL_FRAMEBUFFER, reflection.framebuffer);
  glViewport(0, 0, reflection.size, reflection.size);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  // END SOLUTION(mirror.2)
}

inline void endMirrorPass(const glm::ivec2& window) {
  // BEGIN SOLUTION(mirror.2)
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, window.x, window.y);
  // END SOLUTION(mirror.2)
}

// TODO(mirror.3): let the floor sample the reflection, through texture unit 0.
//   Given:  `reflection`. The floor is drawn next; then read it in tile.frag.
//   Expect: the floor takes on the tint of the background.              (mirror.md, step 3)
inline void sampleReflection(const Reflection& reflection) {
  // BEGIN SOLUTION(mirror.3)
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, reflection.color);
  // END SOLUTION(mirror.3)
}

// TODO(mirror.4): draw the objects mirrored at the plane y = 0.
//   Given:  draw(), with `program`; `projection` and `view` of the eye; scene.light, which is in
//           world space, and `light`, from which the shaders take it in the space of the view that
//           they draw with.
//   Goal:   the mirror image of each object, lit as the object is.
//   Expect: coloured shapes appear in the floor, inside out.            (mirror.md, step 4)
inline void drawMirrored(const gg::Program& program, const glm::mat4& projection,
                         const glm::mat4& view, const gg::UniformBuffer<gg::Light>& light,
                         const gg::Scene& scene, const Draw& draw) {
  // BEGIN SOLUTION(mirror.4)
  const glm::mat4 mirroredView = view * glm::scale(glm::mat4(1), glm::vec3(1, -1, 1));
  light.load(scene.light.in(mirroredView));
  program.use();
  draw(program, projection, mirroredView);
  // END SOLUTION(mirror.4)
}

// TODO(mirror.5): a mirror turns every triangle round, and its normal inside.
//   Goal:   between these two functions, the sides are drawn that face the eye; after them all is
//           as before. The normal is turned in mirror.vert.
//   Expect: solid objects in the floor, lit like the real ones.         (mirror.md, step 5)
inline void turnCulling() {
  // BEGIN SOLUTION(mirror.5)
  glCullFace(GL_FRONT);
  // END SOLUTION(mirror.5)
}

inline void restoreCulling() {
  // BEGIN SOLUTION(mirror.5)
  glCullFace(GL_BACK);
  // END SOLUTION(mirror.5)
}

// TODO(mirror.6): cut away what lies below the floor.
//   Given:  `program`; `clip`: does the scene want it? (You need not ask.)
//   Goal:   between these two functions, OpenGL clips by the distance that mirror.vert gives each
//           vertex.
//   Expect: what is sunken is no longer reflected above the floor.      (mirror.md, step 6)
inline void beginClipping(const gg::Program& program, bool clip) {
  // BEGIN SOLUTION(mirror.6)
  program.set("uClip", clip);
  if (clip) glEnable(GL_CLIP_DISTANCE0);
  // END SOLUTION(mirror.6)
}

inline void endClipping() {
  // BEGIN SOLUTION(mirror.6)
  glDisable(GL_CLIP_DISTANCE0);
  // END SOLUTION(mirror.6)
}

// The pass "mirror": the objects as the floor sees them, into the framebuffer object. It is made of
// TODO(mirror.2), TODO(mirror.4), TODO(mirror.5) and TODO(mirror.6).
//   window: its size, pixels;  projection: clip from eye;  view: eye from world
inline void mirrorPass(const Reflection& reflection, const glm::ivec2& window,
                       const gg::Program& program, const glm::mat4& projection,
                       const glm::mat4& view, const gg::UniformBuffer<gg::Light>& light,
                       const gg::Scene& scene, const Draw& draw) {
  beginMirrorPass(reflection);
  turnCulling();
  beginClipping(program, scene.integer("quality.mirror_clip") > 0);
  drawMirrored(program, projection, view, light, scene, draw);
  endClipping();
  restoreCulling();
  endMirrorPass(window);
}

// Can this view show a reflection? Not if the effect is off, the floor reflects nothing, the eye is
// not above the floor, or the whole floor lies outside one side of the view volume.
inline bool showsReflection(const gg::Scene& scene, const glm::mat4& clipFromWorld) {
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
