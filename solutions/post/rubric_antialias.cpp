// The rubric of part "antialias". Titles and points stand in assignment.json.

#include "rubric_post.hpp"

using namespace post_rubric;

namespace {

/// Where the reference or the submission sees an edge, however faint: both pictures are black
/// elsewhere.
Mask edges(const View& view) {
  const Image &wanted = view.scene.reference.at(0), &found = view.frames.at(0);
  const Image nothing(wanted.width(), wanted.height(), 3);
  return differenceMask(wanted, nothing, kLeastChange) |
         differenceMask(found, nothing, kLeastChange);
}

/// Where there is but one answer to how an edge lies. What is as steep along rows as along columns,
/// or on both sides, may lie either way: a rounding decides.
Mask decided(const View& view) {
  const Image& plain = view.scene.probes.at("plain").at(0);
  const auto luma = [&](int x, int y) {
    x = std::clamp(x, 0, plain.width() - 1), y = std::clamp(y, 0, plain.height() - 1);
    return 0.299 * plain.at(x, y, 0) + 0.587 * plain.at(x, y, 1) + 0.114 * plain.at(x, y, 2);
  };
  constexpr double kStep = 1.0 / 255; // what a luma of eight bits may be off by
  Mask mask(plain.width(), plain.height());
  for (int y = 0; y < plain.height(); ++y)
    for (int x = 0; x < plain.width(); ++x) {
      double columns = 0, rows = 0; // second differences
      for (int i = -1; i <= 1; ++i) {
        const double weight = i == 0 ? 2 : 1;
        columns += weight * std::abs(luma(x + i, y - 1) - 2 * luma(x + i, y) + luma(x + i, y + 1));
        rows += weight * std::abs(luma(x - 1, y + i) - 2 * luma(x, y + i) + luma(x + 1, y + i));
      }
      const double m = luma(x, y);
      const double sides = columns >= rows
                               ? std::abs(luma(x, y - 1) - m) - std::abs(luma(x, y + 1) - m)
                               : std::abs(luma(x - 1, y) - m) - std::abs(luma(x + 1, y) - m);
      if (std::abs(columns - rows) > 8 * kStep && std::abs(sides) > 4 * kStep) mask.set(x, y);
    }
  return mask;
}

GGRADE_ITEM("antialias.edges", moving([](const View& view) {
              return pictured(view, edges(view), 0.065, 0.095, gg::say("the picture of edges"));
            }));

GGRADE_ITEM("antialias.directions", moving([](const View& view) {
              return pictured(view, edges(view) & decided(view), 0.02, 0.07,
                              gg::say("how edges lie"));
            }));

GGRADE_ITEM("antialias.search", moving([](const View& view) {
              // Where there are long edges alone, right ways draw nearly the same.
              const bool alone = view.scene.has("long");
              return shows(view, {view.scene}, alone ? 0.08 : 0.15, alone ? 0.25 : 0.3,
                           gg::say("smooth edges"));
            }));

GGRADE_ITEM("antialias.single", moving([](const View& view) {
              return shows(view, {view.scene, "unshifted"}, 0.1, 0.4, gg::say("single pixels"));
            }));

GGRADE_ITEM("antialias.picture", moving([](const View& view) {
              return shows(view, {view.scene}, 0.16, 0.5, gg::say("the whole picture"));
            }));

GGRADE_ITEM("antialias.smaa_edges", moving([](const View& view) {
              return pictured(view, edges(view), 0.04, 0.2, gg::say("SMAA's edges"));
            }));

GGRADE_ITEM("antialias.smaa", moving([](const View& view) {
              return shows(view, {view.scene}, 0.12, 0.5, gg::say("smooth edges"));
            }));

GGRADE_ITEM("antialias.keep_picture", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) { return leftAlone(view, i, {view.scene}); });
});

} // namespace
