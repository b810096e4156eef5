// The rubric of shadow_volume: what the window shows. Titles and points stand in assignment.json.

#include "rubric_shadows.hpp"

#include "rubric/follows.hpp"

#include <fmt/format.h>

#include <algorithm>

using namespace shadow_volume_rubric;

namespace {

/// A stencil that light can be judged by leaves out and lets through at least this share of what
/// the reference does.
constexpr double kLeastOfBoth = 0.2;

/// Does the light of the first frame spare what the submission itself has counted?
Verdict sparesOwnStencil(const View& view, const Mask& stencil) {
  const Regions& regions = regionsOf(view.scene, 0);
  const Mask place = regions.onWalls | regions.onCaster;
  const auto share = [](const Mask& part, const Mask& of) {
    return double(part.count()) / double(std::max<std::size_t>(of.count(), 1));
  };
  const Mask dark = stencil & place, light = place & ~stencil;
  if (share(dark, regions.shadow) < kLeastOfBoth ||
      share(light, place & ~regions.shadow) < kLeastOfBoth)
    return {0, "the stencil is the same nearly everywhere"};
  const Mask found = shadowIn(view, 0) & place;
  Agreement pixels = agreement(dark, found, kEdge);
  pixels.wanted = std::min(dark.count(), light.count());
  return {qualityOf(pixels.wrongShare()),
          fmt::format("{} pixels that differ in the stencil are lit, {} that don't are in shadow",
                      pixels.missing, pixels.extra)};
}

Verdict lit(const View& view) {
  Verdict best = agree(view, 0, shadowIn(view, 0), "window");
  const Mask& place = regionsOf(view.scene, 0).caster;
  for (const Mask& stencil : stencils(view.trace)) {
    if (stencil.width() != place.width() || stencil.height() != place.height()) continue;
    const Verdict one = sparesOwnStencil(view, stencil);
    if (one.quality > best.quality) best = one;
  }
  return best;
}

GGRADE_ITEM("shadow_volume.light", lit);

/// Colours where the submission and the reference both have a shadow.
Verdict sharedShadow(const View& view, std::size_t frame) {
  const Mask both = regionsOf(view.scene, frame).shadow & shadowIn(view, frame);
  const Mask region = erode(both, 1);
  if (tooSmall(region)) return {0, "the submission and the reference share no shadow"};
  return within(view, frame, region, "colours in the shadow");
}

GGRADE_ITEM("shadow_volume.ambient", [](const View& view) {
  Verdict verdict = sharedShadow(view, 0);
  verdict.quality *= lit(view).quality; // all in shadow is not lit rightly
  return verdict;
});

/// Share of the pixels away from shadows that no amount of light explains, over the walls and the
/// caster; the greater share counts, because the caster is a small part of the picture.
double spoiled(const View& view, std::size_t frame, std::string& where) {
  const Image& image = view.frames.at(frame);
  const Regions& regions = regionsOf(view.scene, frame);
  // The colour of a shadow is another item's.
  const Mask places = regions.onWalls | regions.onCaster;
  const Mask region =
      ~dilate(regions.shadow | (shadowIn(view, frame) & places), kEdge) & ~regions.averted;
  const Mask wrong =
      unexplained(image, view.scene.reference.at(frame), lightOf(view, frame), region);
  double share = 0;
  const Mask all(image.width(), image.height(), true);
  for (const auto& [part, name] : {std::pair{&all, "pixels"},
                                   {&regions.onWalls, "walls' pixels"},
                                   {&regions.onCaster, "caster's pixels"}}) {
    const Mask judged = region & *part;
    if (tooSmall(judged)) continue;
    const double one = double((wrong & judged).count()) / double(judged.count());
    if (one < share) continue;
    share = one;
    where = fmt::format("{:.1f}% of the {} away from shadows differ{}", 100 * share, name,
                        densestAt(densestWindow(wrong)));
  }
  return share;
}

GGRADE_ITEM("shadow_volume.keep_picture", [](const View& view) -> Verdict {
  std::string where;
  const double share = spoiled(view, 0, where);
  return {unharmed(share), where};
});

GGRADE_ITEM("shadow_volume.keep_state", [](const View& view) {
  Verdict rest =
      laterFrames(view, [&](std::size_t i, std::string& where) { return spoiled(view, i, where); });
  // Shadows that are wrong already may be more so or less as the lamp moves.
  if (agree(view, 0, shadowIn(view, 0), "").quality < kNearlyAll) return rest;
  const Verdict shadows = shadowsInWindow(view);
  if (shadows.quality < std::min(rest.quality, kNearlyAll))
    return Verdict{shadows.quality, "a later frame: " + shadows.message};
  return rest;
});

GGRADE_ITEM("shadow_volume.keep_following", [](const View& view) {
  const Effect shadows = [](const View& of, std::size_t frame) {
    return shadowIn(of, frame) & regionsOf(of.scene, frame).onWalls;
  };
  return follows(view, shadows, "shadow");
});

} // namespace
