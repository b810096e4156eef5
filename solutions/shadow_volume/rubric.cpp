// The rubric of shadow_volume: what the window shows. Titles and points stand in assignment.json.

#include "rubric_shadows.hpp"

#include "rubric/follows.hpp"
#include "words/words.hpp"

#include <algorithm>

using namespace shadow_volume_rubric;

namespace {

/// Does the light of the first frame spare what the submission itself has counted?
Verdict sparesOwnStencil(const View& view, const Mask& stencil) {
  const Regions& regions = regionsOf(view.scene, 0);
  const Mask place = regions.onWalls | regions.onCaster;
  const Mask dark = stencil & place, light = place & ~stencil;
  if (tooSmall(dark) || tooSmall(light))
    return {0, gg::say("the stencil is the same nearly everywhere")};
  const Mask found = shadowIn(view, 0) & place;
  Agreement pixels = agreement(dark, found, kEdge);
  pixels.wanted = std::min(dark.count(), light.count());
  return {qualityOf(pixels.wrongShare()),
          gg::say("{} pixels that differ in the stencil are lit, {} that don't are in shadow",
                  pixels.missing, pixels.extra)};
}

Verdict lit(const View& view) {
  Verdict best = agree(view, 0, shadowIn(view, 0), Where::window);
  if (frozen(view)) return best;
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
  if (tooSmall(region)) return {0, gg::say("the submission and the reference share no shadow")};
  return within(view, frame, region, gg::say("colours in the shadow"));
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
  for (const auto& [part, name] : {std::pair{&all, gg::say("pixels")},
                                   {&regions.onWalls, gg::say("walls' pixels")},
                                   {&regions.onCaster, gg::say("caster's pixels")}}) {
    const Mask judged = region & *part;
    if (tooSmall(judged)) continue;
    const double one = double((wrong & judged).count()) / double(judged.count());
    if (one < share) continue;
    share = one;
    where = gg::say("{:.1f}% of the {} away from shadows differ{}", 100 * share, name,
                    densestAt(densestWindow(wrong)));
  }
  return share;
}

GGRADE_ITEM("shadow_volume.keep_picture", [](const View& view) -> Verdict {
  std::string where;
  const double share = spoiled(view, 0, where);
  return {unharmed(share), where};
});

/// Share of the pixels that may differ between two frames that must be equal, and at which nothing
/// is left: the same program draws the same, so that all there is counts.
constexpr double kNoise = 0.001, kAllLeft = 0.004;

GGRADE_ITEM("shadow_volume.keep_state", [](const View& view) -> Verdict {
  const Frames& reference = view.scene.reference;
  for (std::size_t i = view.frames.size() - 1; i > 0; --i) {
    // Nothing moves but the lamp; where the reference is as it was, the lamp is.
    if (compare(reference[i], reference[0]).wrongPixels > 0) continue;
    const Comparison changed = compare(view.frames[i], view.frames[0]);
    return {1 - std::clamp((changed.wrongShare - kNoise) / kAllLeft, 0.0, 1.0),
            gg::say("frame {}, with the lamp where it was in frame 1: {:.1f}% of the pixels "
                    "have changed{}",
                    i + 1, 100 * changed.wrongShare, densestAt(changed.densest))};
  }
  return {1, gg::say("the lamp is never where it was")};
});

GGRADE_ITEM("shadow_volume.keep_following", [](const View& view) {
  const Effect shadows = [](const View& of, std::size_t frame) {
    return shadowIn(of, frame) & regionsOf(of.scene, frame).onWalls;
  };
  return follows(view, shadows, gg::say("shadow"));
});

} // namespace
