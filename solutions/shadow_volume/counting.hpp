// What the stencil buffer counts, and what it lets through.
#pragma once

#include "volume_buffer.hpp"

#include <gg/gg.hpp>

#include <optional>
#include <vector>

// TODO(shadow_volume.3): count. What is seen of the volume from the front is a way in, what is seen
//   from the back a way out.
//   Given:  `volume`, and its draw().
//   Goal:   from 0 in every frame, the stencil holds ways in less ways out that lie before each
//           pixel's surface, of all volumes; below 0 it goes on from 255. Colours and depths are as
//           they were. After each volume, so is all state.
//   Expect: the picture doesn't change; ./ggrade inspect shows the stencil. (README.md, step 3)
inline void clearCount() {
  // BEGIN SOLUTION(shadow_volume.3)
  glClear(GL_STENCIL_BUFFER_BIT);
  // END SOLUTION(shadow_volume.3)
}

inline void beginCounting() {
  // BEGIN SOLUTION(shadow_volume.3)
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, 0, 0xff);
  glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
  glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  // END SOLUTION(shadow_volume.3)
}

inline void drawCounted(const VolumeBuffer& volume, const gg::Scene& scene) {
  // BEGIN SOLUTION(shadow_volume.3)
  if (scene.integer("quality.passes") == 1) {
    volume.draw();
  } else { // as before there was a two-sided stencil: front faces, then back faces
    glEnable(GL_CULL_FACE);
    volume.draw();
    glCullFace(GL_FRONT);
    volume.draw();
    glCullFace(GL_BACK);
  }
  // END SOLUTION(shadow_volume.3)
}

inline void endCounting() {
  // BEGIN SOLUTION(shadow_volume.3)
  glEnable(GL_CULL_FACE);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_STENCIL_TEST);
  // END SOLUTION(shadow_volume.3)
}

// TODO(shadow_volume.4): add light only where the stencil is 0. Afterwards, no stencil test.
//   Given:  the light is drawn between these two functions.
//   Expect: shadows.                                         (README.md, step 4)
inline void beginLight() {
  // BEGIN SOLUTION(shadow_volume.4)
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_EQUAL, 0, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  // END SOLUTION(shadow_volume.4)
}

inline void endLight() {
  // BEGIN SOLUTION(shadow_volume.4)
  glDisable(GL_STENCIL_TEST);
  // END SOLUTION(shadow_volume.4)
}

// TODO(shadow_volume.5): if the scene's quality.method is 1, count what is hidden instead, so that
//   it doesn't matter where the eye is.
//   Given:  called after beginCounting() and before endCounting(), around the draw.
//   Goal:   the stencil holds ways out less ways in that lie behind each pixel's surface, and
//           neither the near nor the far plane cuts a volume off, until it is drawn.
//   Expect: right also with the eye in a shadow.           (README.md, step 5)
inline void beginCountingHidden(const gg::Scene& scene) {
  // BEGIN SOLUTION(shadow_volume.5)
  if (scene.integer("quality.method") == 1) {
    glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
    glStencilOpSeparate(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
    glEnable(GL_DEPTH_CLAMP);
  }
  // END SOLUTION(shadow_volume.5)
}

inline void endCountingHidden() {
  // BEGIN SOLUTION(shadow_volume.5)
  glDisable(GL_DEPTH_CLAMP);
  // END SOLUTION(shadow_volume.5)
}

// The pass "volume": counts, in the stencil buffer, how many volumes each pixel's surface lies in.
//   memory: of a mesh of several parts, else nothing
inline void volumePass(const std::vector<VolumeBuffer>& volumes,
                       const std::optional<CountMemory>& memory, const gg::Program& program,
                       const gg::Scene& scene) {
  if (volumes.empty()) return;
  clearCount();
  if (memory) glStencilMask(0x7f);
  for (const VolumeBuffer& volume : volumes) {
    if (&volume != &volumes.front()) memory->remember();
    program.use();
    beginCounting();
    beginCountingHidden(scene);
    drawCounted(volume, scene);
    endCountingHidden();
    endCounting();
  }
  glStencilMask(0xff);
}
