// The rubric of part "afterglow". Titles and points stand in assignment.json. Frames come before
// the first one that is looked at, so that there is something that can glow.

#include "rubric_post.hpp"

#include "rubric/passes.hpp"

using namespace post_rubric;

namespace {

/// Is there a texture over the whole window that a pass over the screen drew this frame's light
/// into, and what is that off by? Light that goes on glowing may only add to it.
double leastMissing(const View& view) {
  const Image& window = view.scene.reference.at(0);
  const std::vector<Drawn> wanted = sampledLater(view.scene.referenceTrace);
  const auto scene = std::find_if(wanted.begin(), wanted.end(),
                                  [](const Drawn& drawn) { return drawn.ofObjects; });
  if (scene == wanted.end()) return 1;
  const Image light = view.scene.referenceTrace.image(*scene->copy);
  double least = 1;
  for (const Drawn& drawn : sampledLater(view.trace)) {
    if (drawn.ofObjects || drawn.attachment >= trace::kColors) continue;
    const Image found = view.trace.image(*drawn.copy);
    if (found.width() != window.width() || found.height() != window.height() ||
        light.width() != found.width() || light.height() != found.height())
      continue;
    double missing = 0;
    for (int y = 0; y < found.height(); ++y)
      for (int x = 0; x < found.width(); ++x)
        for (int c = 0; c < 3; ++c)
          missing += found.at(x, y, c) < std::min(light.at(x, y, c), 1.0f) - kLeastChange ? 1 : 0;
    least = std::min(least, missing / (3.0 * found.width() * found.height()));
  }
  return least;
}

GGRADE_ITEM("afterglow.turns", moving([](const View& view) -> Verdict {
              const Verdict picture = shows(view, {view.scene}, 0.1, 0.9, gg::say("the trail"));
              const double missing = leastMissing(view);
              const Verdict texture{
                  qualityOf(missing, 0.01, 0.2),
                  missing >= 1 ? gg::say("no texture is drawn that holds the frame's light")
                               : gg::say("{:.1f}% of the frame's light is missing from the texture",
                                         100 * missing)};
              return texture.quality >= picture.quality ? texture : picture;
            }));

GGRADE_ITEM("afterglow.trail", moving([](const View& view) {
              return shows(view, {view.scene}, 0.05, 0.2, gg::say("the trail"));
            }));

GGRADE_ITEM("afterglow.seconds", moving([](const View& view) {
              return shows(view, {view.scene}, 0.06, 0.18, gg::say("the trail"));
            }));

GGRADE_ITEM("afterglow.keep_picture",
            [](const View& view) { return leftAlone(view, 0, {view.scene}); });

/// After the window has got another size, nothing has glowed yet, or what did still glows in its
/// place: a trail is small, and light is only added.
GGRADE_ITEM("afterglow.keep_resized", [](const View& view) -> Verdict {
  const Image &found = view.frames.at(0), &wanted = view.scene.reference.at(0);
  Mask darker(found.width(), found.height()), brighter = darker;
  for (int y = 0; y < found.height(); ++y)
    for (int x = 0; x < found.width(); ++x)
      for (int c = 0; c < 3; ++c) {
        const float difference = found.at(x, y, c) - wanted.at(x, y, c);
        if (difference < -kLeastChange) darker.set(x, y);
        if (difference > kLeastChange) brighter.set(x, y);
      }
  constexpr double kTrail = 0.03; // of the picture, at most
  const double all = double(found.width()) * double(found.height());
  const double share =
      double(darker.count()) / all + std::max(double(brighter.count()) / all - kTrail, 0.0);
  return {unharmed(share), gg::say("{:.1f}% of the picture is darker than it should be, or too "
                                   "much of it glows{}",
                                   100 * share, densestAt(densestWindow(darker | brighter)))};
});

} // namespace
