// The rubric of ssao. Titles and points stand in assignment.json.
//
// Where points lie, how noise is made and what removes it is everybody's own, so occlusion is
// compared after a mean over some pixels, wherever one pixel doesn't matter.

#include "rubric_open.hpp"

#include "rubric/follows.hpp"

#include <fmt/format.h>

#include <algorithm>

using namespace ssao_rubric;

namespace {

/// Pixels to each side over which noise is averaged.
constexpr int kNoise = 4;

/// How near to the reference's occlusion a picture of it is, whatever its noise.
double likeness(const View& view, const Image& open) {
  const Regions& regions = regionsOf(view.scene, 0);
  const Image found = smoothed(open, regions.covered, kNoise);
  const Image wanted = smoothed(regions.open, regions.covered, kNoise);
  return apart(found, wanted, regions.covered);
}

/// The least of what `measure` says of the window's picture of the occlusion and of every texture
/// that may hold it: who has it has it.
template <class Measure> double best(const View& view, Measure measure) {
  double least = measure(shownOpen(view, 0));
  for (const Opening& opening : openings(view)) least = std::min(least, measure(opening.open));
  return least;
}

std::string keptOut(double apart) {
  return fmt::format("differs from the reference by {:.0f}% of what that keeps out", 100 * apart);
}

// ---- position, samples, range: the occlusion itself

constexpr double kPointsFree = 0.2, kPointsGone = 0.8;

GGRADE_ITEM("ssao.position", [](const View& view) {
  Verdict verdict = within(view, 0, regionsOf(view.scene, 0).covered, "positions");
  // Positions that are kept in another way still make the right occlusion.
  double least = 1;
  for (const Opening& opening : openings(view))
    least = std::min(least, likeness(view, opening.open));
  const double otherwise = qualityOf(least, kPointsFree, kPointsGone);
  if (otherwise > verdict.quality) verdict = {otherwise, "the occlusion " + keptOut(least)};
  return verdict;
});

GGRADE_ITEM("ssao.samples", [](const View& view) -> Verdict {
  const double least = best(view, [&](const Image& open) { return likeness(view, open); });
  return {qualityOf(least, kPointsFree, kPointsGone), "the occlusion " + keptOut(least)};
});

/// Where a later pass may take its occlusion from: the first texture that is like the reference's.
GGRADE_PASS("ssao.samples", [](const View& view) -> std::vector<PassOutput> {
  const std::vector<Opening> all = openings(view);
  if (all.empty()) return {};
  return {{all.front().drawn.copy->pass, all.front().drawn.attachment}};
});

/// Less is open, and more than this too dark: a seam.
constexpr float kOpen = 0.9f, kSeam = 0.06f;
constexpr double kSeamsFree = 0.02, kSeamsGone = 0.2;

/// Of the pixels that are open in the reference, the share that is too dark.
Mask seams(const View& view, const Image& open) {
  const Regions& regions = regionsOf(view.scene, 0);
  const Image found = smoothed(open, regions.covered, 1);
  Mask mask(open.width(), open.height());
  for (int y = 0; y < open.height(); ++y)
    for (int x = 0; x < open.width(); ++x)
      mask.set(x, y,
               regions.covered.at(x, y) && regions.open.at(x, y) > kOpen &&
                   found.at(x, y) < regions.open.at(x, y) - kSeam);
  return mask;
}

GGRADE_ITEM("ssao.range", [](const View& view) -> Verdict {
  const Regions& regions = regionsOf(view.scene, 0);
  const Image open = shownOpen(view, 0);
  const Mask dark = seams(view, open);
  // As a share of what lies near an edge, where seams are.
  const Mask near = dilate(regions.edges, 10) & regions.covered & ~below(regions.open, kOpen);
  const double share =
      double((dark & near).count()) / double(std::max<std::size_t>(near.count(), 1));
  const double like = qualityOf(likeness(view, open), 0.4, 1);
  return {like * qualityOf(share, kSeamsFree, kSeamsGone),
          fmt::format("{:.0f}% of the open surface near edges is too dark{}; the occlusion {}",
                      100 * share, densestAt(densestWindow(dark)), keptOut(likeness(view, open)))};
});

// ---- blur

constexpr double kBlurFree = 0.15, kBlurGone = 0.6;

/// Pixel by pixel: noise counts, and so do edges that are lost.
Verdict blurred(const View& view, std::size_t frame, const Image& open) {
  const Regions& regions = regionsOf(view.scene, frame);
  const double inside = apart(open, regions.open, regions.covered & ~regions.edges);
  const double edges = apart(open, regions.open, regions.covered & regions.edges);
  return {std::min(qualityOf(inside, kBlurFree, kBlurGone), qualityOf(edges, kBlurFree, kBlurGone)),
          fmt::format("away from edges the occlusion {}, near them by {:.0f}%", keptOut(inside),
                      100 * edges)};
}

GGRADE_ITEM("ssao.blur", [](const View& view) {
  Verdict verdict = blurred(view, 0, openInWindow(view, 0));
  for (const Opening& opening : openings(view)) {
    const Verdict one = blurred(view, 0, opening.open);
    if (one.quality > verdict.quality) verdict = one;
  }
  return verdict;
});

// ---- what the light makes of it

constexpr double kLightFree = 0.08, kLightGone = 0.5;
/// Least difference that ambient light makes for a pixel to tell how much of it there is.
constexpr float kLeastLight = 20.0f / 255;

/// Does the window's light follow the reference's occlusion, or else the submission's own?
Verdict applied(const View& view) {
  const Regions& regions = regionsOf(view.scene, 0);
  const Mask region = regions.covered & ~regions.edges &
                      differenceMask(view.scene.probes.at("unlit").at(0),
                                     view.scene.probes.at("unoccluded").at(0), kLeastLight);
  if (tooSmall(region)) return {0, "there is no ambient light to see it by"};
  const Image found = openInWindow(view, 0);
  double least = apart(found, regions.open, region);
  for (const Opening& opening : openings(view)) {
    // It must keep out something to be followed: half of what the reference does.
    if (apart(opening.open, regions.open, region) < 0.8)
      least = std::min(least, apart(found, opening.open, region));
  }
  return {qualityOf(least, kLightFree, kLightGone),
          fmt::format("the ambient light differs by {:.0f}% of what the occlusion keeps out",
                      100 * least)};
}

GGRADE_ITEM("ssao.apply", applied);
GGRADE_ITEM("ssao.direct", applied);

GGRADE_ITEM("ssao.horizons", [](const View& view) -> Verdict {
  const double least = best(view, [&](const Image& open) { return likeness(view, open); });
  return {qualityOf(least, 0.08, 0.25), "the occlusion " + keptOut(least)};
});

// ---- what must stay

GGRADE_ITEM("ssao.keep_picture", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) -> Verdict {
    const auto& probes = view.scene.probes;
    const LightRange light{probes.at("unlit").at(i), probes.at("unoccluded").at(i)};
    const Mask all(view.frames[i].width(), view.frames[i].height(), true);
    const Mask wrong = unexplained(view.frames[i], view.scene.reference.at(i), light, all);
    const double share = double(wrong.count()) / double(all.count());
    return {unharmed(share), fmt::format("{:.1f}% of the pixels differ in another way than by less "
                                         "ambient light{}",
                                         100 * share, densestAt(densestWindow(wrong)))};
  });
});

/// Share of the pixels that may differ between two frames that must be equal, and at which nothing
/// is left: the same program draws the same, so that all there is counts.
constexpr double kSame = 0.001, kAllLeft = 0.01;

GGRADE_ITEM("ssao.keep_state", [](const View& view) -> Verdict {
  const Frames& reference = view.scene.reference;
  for (std::size_t i = view.frames.size() - 1; i > 0; --i) {
    if (compare(reference[i], reference[0]).wrongPixels > 0) continue;
    const Comparison changed = compare(view.frames[i], view.frames[0]);
    return {1 - std::clamp((changed.wrongShare - kSame) / kAllLeft, 0.0, 1.0),
            fmt::format("frame {}, with everything where it was in frame 1: {:.1f}% of the pixels "
                        "have changed{}",
                        i + 1, 100 * changed.wrongShare, densestAt(changed.densest))};
  }
  return {1, "nothing is ever where it was"};
});

GGRADE_ITEM("ssao.keep_following", [](const View& view) {
  const Effect occlusion = [](const View& of, std::size_t frame) {
    const Regions& regions = regionsOf(of.scene, frame);
    return below(openInWindow(of, frame), 0.8f) & regions.covered & ~regions.edges;
  };
  return follows(view, occlusion, "occlusion");
});

} // namespace
