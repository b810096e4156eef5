#pragma once
// Where shadows are: in a frame of the window, and in the stencil buffer.

#include "rubric/light.hpp"
#include "rubric/measures.hpp"

#include <string>
#include <vector>

namespace shadow_volume_rubric {

using namespace ggrade;
using namespace ggrade::rubric;

/// Pixels that the edge of a shadow may move.
inline constexpr int kEdge = 1;

/// What a frame of a scene shows where, in the reference.
struct Regions {
  Mask caster;            // all of it that is seen
  Mask onWalls, onCaster; // where light makes a difference, one pixel away from outlines
  Mask shadow;            // of both
  Mask averted; // where light makes no difference: nobody can tell what is in shadow there
};
const Regions& regionsOf(const SceneEvidence& scene, std::size_t frame);

const Image& probe(const View& view, const char* name, std::size_t frame);
LightRange lightOf(const View& view, std::size_t frame);

/// The frame as it must be without the volume shown in white.
const Image& wanted(const SceneEvidence& scene, std::size_t frame);

/// Pixels that get less than half of the light in one of the view's frames.
Mask shadowIn(const View& view, std::size_t frame);

/// Where shadows were found.
enum class Where { window, stencil };

/// Do the pixels of `found` lie in shadow where the reference has one? The worse of walls and
/// caster.
Verdict agree(const View& view, std::size_t frame, const Mask& found, Where where);

/// The shadows in the window, the worst frame's.
Verdict shadowsInWindow(const View& view);

/// Of the first frame, after every pass that can have changed a stencil: the pixels that differ
/// from what it was cleared to. Zero and not zero is all that the light's pass asks, so the sign of
/// counts, and how often one pixel was counted, don't matter.
std::vector<Mask> stencils(const trace::Trace& trace);

/// The best of the stencils, or where none is right, the shadows in the window.
Verdict counted(const View& view);

} // namespace shadow_volume_rubric
