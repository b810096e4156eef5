// The rubric of part "motion_blur". Titles and points stand in assignment.json. The first frame of
// each scene has one before it, so that there is a last frame's place of everything.

#include "rubric_post.hpp"

using namespace post_rubric;

namespace {

GGRADE_ITEM("motion_blur.velocity", moving([](const View& view) {
              const Image& wanted = view.scene.reference.at(0);
              Image rest(wanted.width(), wanted.height(), 3);
              for (float& value : rest.values()) value = 128.0f / 255;
              const Mask moves = differenceMask(wanted, rest, kLeastChange) |
                                 differenceMask(view.frames.at(0), rest, kLeastChange);
              return pictured(view, moves, 0.02, 0.15, gg::say("velocities"));
            }));

GGRADE_ITEM("motion_blur.camera", moving([](const View& view) {
              return shows(view, {view.scene}, 0.03, 0.25, gg::say("what the camera blurs"));
            }));

GGRADE_ITEM("motion_blur.objects", moving([](const View& view) {
              return shows(view, {view.scene}, 0.03, 0.25, gg::say("what moves"));
            }));

GGRADE_ITEM("motion_blur.picture", moving([](const View& view) {
              return shows(view, {view.scene}, 0.06, 0.4, gg::say("the whole picture"));
            }));

GGRADE_ITEM("motion_blur.neighbours", moving([](const View& view) {
              return shows(view, {view.scene}, 0.02, 0.15, gg::say("blur beyond the outline"));
            }));

/// Nothing moves: every bit must stay.
GGRADE_ITEM("motion_blur.keep_still", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) -> Verdict {
    const Mask wrong = differenceMask(view.frames.at(i), view.scene.reference.at(i), 0);
    const double share = double(wrong.count()) / (double(wrong.width()) * double(wrong.height()));
    return {1 - std::clamp(share / 0.05, 0.0, 1.0),
            gg::say("nothing moves, and {:.1f}% of the pixels have changed", 100 * share)};
  });
});

GGRADE_ITEM("motion_blur.keep_picture",
            [](const View& view) { return leftAlone(view, 0, {view.scene}); });

} // namespace
