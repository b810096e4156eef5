// The rubric of part "antialias". Titles and points stand in assignment.json.

#include "rubric_post.hpp"

using namespace post_rubric;

namespace {

/// Where the reference or the submission sees an edge: both pictures are black elsewhere.
Mask edges(const View& view) {
  return shown(view.scene.reference.at(0)) | shown(view.frames.at(0));
}

GGRADE_ITEM("antialias.edges", moving([](const View& view) {
              return pictured(view, edges(view), 0.05, 0.5, gg::say("edges"));
            }));

GGRADE_ITEM("antialias.directions", moving([](const View& view) {
              return pictured(view, edges(view), 0.05, 0.6, gg::say("how edges lie"));
            }));

GGRADE_ITEM("antialias.search", moving([](const View& view) {
              return shows(view, {view.scene}, 0.15, 0.8, gg::say("smooth edges"));
            }));

GGRADE_ITEM("antialias.single", moving([](const View& view) {
              return shows(view, {view.scene, "unshifted"}, 0.15, 0.8, gg::say("single pixels"));
            }));

GGRADE_ITEM("antialias.picture", moving([](const View& view) {
              return shows(view, {view.scene}, 0.15, 0.8, gg::say("the whole picture"));
            }));

GGRADE_ITEM("antialias.smaa_edges", moving([](const View& view) {
              return pictured(view, edges(view), 0.05, 0.5, gg::say("SMAA's edges"));
            }));

GGRADE_ITEM("antialias.smaa", moving([](const View& view) {
              return shows(view, {view.scene}, 0.15, 0.8, gg::say("smooth edges"));
            }));

GGRADE_ITEM("antialias.keep_picture", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) { return leftAlone(view, i, {view.scene}); });
});

} // namespace
