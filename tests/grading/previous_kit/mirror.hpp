// The mirror: where the reflection is drawn, and whether it can be seen.
#pragma once

#include <gg/gg.hpp>

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
//   Do:     storage for `color` (linear filter, clamp to edge) and `depth`; attach both to
//           `framebuffer`; throw std::runtime_error if it isn't complete; bind the window again.
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
