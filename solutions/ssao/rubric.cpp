// The rubric of ssao. Titles and points stand in assignment.json.
//
// Where points lie, how noise is made and what removes it is everybody's own, so occlusion is
// compared after a mean over some pixels, wherever one pixel doesn't matter.

#include "rubric_open.hpp"

#include "rubric/follows.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cmath>

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
  return gg::say("the occlusion differs from the reference by {:.0f}% of what that keeps out",
                 100 * apart);
}

// ---- position, samples, range: the occlusion itself

constexpr double kPointsFree = 0.3, kPointsGone = 0.42;
/// Of positions that aren't shown: the reference's own points would find nearly the same.
constexpr double kOtherwiseFree = 0.1, kOtherwiseGone = 0.25;

Verdict positions(const View& view) {
  Verdict verdict = within(view, 0, regionsOf(view.scene, 0).covered, gg::say("positions"));
  // Positions that are kept in another way still make the right occlusion.
  double least = 1;
  for (const Opening& opening : openings(view))
    least = std::min(least, likeness(view, opening.open));
  const double otherwise = qualityOf(least, kOtherwiseFree, kOtherwiseGone);
  if (otherwise > verdict.quality) verdict = {otherwise, keptOut(least)};
  return verdict;
}
GGRADE_ITEM("ssao.position", moving(positions));

/// Of the scene's occlusion, what another radius must change, and what noise may.
constexpr double kRadiusChange = 0.5, kRadiusNoise = 0.2;

/// Does the submission's occlusion change as the reference's does where only the radius is another
/// one? By how much in all: where points lie is everybody's own.
Verdict followsRadius(const View& view) {
  const SceneEvidence &scene = view.scene, &base = *view.base;
  const Mask& covered = regionsOf(scene, 0).covered;
  const auto changed = [&](const Frames& before, const Frames& after) {
    return apart(smoothed(firstChannels(after.at(0), 1), covered, kNoise),
                 smoothed(firstChannels(before.at(0), 1), covered, kNoise), covered);
  };
  const double expected = changed(base.reference, scene.reference);
  const double found = changed(base.student, scene.student);
  return {qualityOf(1 - found / expected, 1 - kRadiusChange, 1 - kRadiusNoise),
          gg::say("the occlusion changed by {:.0f}% of what it keeps out, {:.0f}% in the reference",
                  100 * found, 100 * expected)};
}

Verdict pointsCounted(const View& view) {
  if (view.base) return followsRadius(view);
  const double least = best(view, [&](const Image& open) { return likeness(view, open); });
  return {qualityOf(least, kPointsFree, kPointsGone), keptOut(least)};
}
GGRADE_ITEM("ssao.samples", moving(pointsCounted));

/// Less is open, and more than this too dark: a seam.
constexpr float kOpen = 0.9f, kSeam = 0.06f;
constexpr double kSeamsFree = 0.13, kSeamsGone = 0.18;

/// The pixels that are open in the reference, and those of them that are too dark in `open`.
struct Seams {
  Mask open, dark;
};
Seams seams(const View& view, const Image& open) {
  const Regions& regions = regionsOf(view.scene, 0);
  const Image found = smoothed(open, regions.covered, 2);
  const Image wanted = smoothed(regions.open, regions.covered, 2);
  const Mask isOpen = regions.covered & ~below(wanted, kOpen);
  Seams all{isOpen, isOpen};
  for (int y = 0; y < open.height(); ++y)
    for (int x = 0; x < open.width(); ++x)
      all.dark.set(x, y, isOpen.at(x, y) && found.at(x, y) < wanted.at(x, y) - kSeam);
  return all;
}

Verdict rangeChecked(const View& view) {
  const Image open = shownOpen(view, 0);
  const auto [wanted, dark] = seams(view, open);
  // As a share of what lies near an edge, where seams are.
  const Mask near = dilate(regionsOf(view.scene, 0).edges, 10) & wanted;
  const double share =
      double((dark & near).count()) / double(std::max<std::size_t>(near.count(), 1));
  const double like = likeness(view, open);
  return {qualityOf(like, 0.5, 1) * qualityOf(share, kSeamsFree, kSeamsGone),
          gg::say("{:.0f}% of the open surface near edges is too dark{}; {}", 100 * share,
                  densestAt(densestWindow(dark)), keptOut(like))};
}
GGRADE_ITEM("ssao.range", moving(rangeChecked));

/// The first texture that a pass over the whole screen left: what is blurred.
GGRADE_PASS("ssao.range", [](const View& view) -> std::vector<PassOutput> {
  const std::vector<Opening> all = openings(view);
  if (all.empty()) return {};
  return {{all.front().drawn.copy->pass, all.front().drawn.attachment}};
});

// ---- blur

constexpr double kNoiseFree = 0.15, kNoiseGone = 0.4;
/// As shares of what a blur across edges makes wrong near them.
constexpr double kEdgesFree = 0.6, kEdgesGone = 0.9;
/// Of the noise, in one direction. Right answers leave at most 0.05, a blur along rows alone 0.3.
constexpr double kStripesFree = 0.12, kStripesGone = 0.25;
/// Share of the noise of the reference's occlusion, from which on another one has some to be
/// removed.
constexpr double kHasNoise = 0.3;

/// What a blur that keeps edges makes of it: the mean of the pixels nearby that show the same
/// surface, by its normal and colour.
Image blurredWell(const Image& open, const View& view) {
  constexpr float kAlike = 16.0f / 255;
  const int reach = view.scene.scene.at("quality").at("blur").get<int>();
  const Image &normals = view.scene.probes.at("normals").at(0),
              &colors = view.scene.probes.at("unoccluded").at(0);
  const auto alike = [&](int x, int y, int u, int v) {
    for (int c = 0; c < 3; ++c)
      if (std::abs(normals.at(x, y, c) - normals.at(u, v, c)) > kAlike ||
          std::abs(colors.at(x, y, c) - colors.at(u, v, c)) > kAlike)
        return false;
    return true;
  };
  Image out(open.width(), open.height(), 1);
  for (int y = 0; y < open.height(); ++y)
    for (int x = 0; x < open.width(); ++x) {
      double sum = 0, count = 0;
      for (int v = std::max(y - reach, 0); v <= std::min(y + reach, open.height() - 1); ++v)
        for (int u = std::max(x - reach, 0); u <= std::min(x + reach, open.width() - 1); ++u)
          if (alike(x, y, u, v)) sum += double(open.at(u, v)), ++count;
      out.at(x, y) = float(sum / count);
    }
  return out;
}

/// The reference's occlusion before its blur.
Image noiseOf(const View& view) {
  return openings({view.scene, view.scene.reference, view.scene.referenceTrace}).at(0).open;
}

/// How far a blur of the reference's noise that doesn't look at what pixels show is from the
/// reference, near edges.
double lostAcross(const View& view, const Image& noise) {
  const Regions& regions = regionsOf(view.scene, 0);
  const Mask everywhere(noise.width(), noise.height(), true);
  const int reach = view.scene.scene.at("quality").at("blur").get<int>();
  return apart(smoothed(noise, everywhere, reach), regions.open, regions.covered & regions.edges);
}

/// How different neighbours are in one direction: the mean over `region`.
double roughness(const Image& open, const Mask& region, int alongX, int alongY) {
  double sum = 0, count = 0;
  for (int y = 0; y + alongY < open.height(); ++y)
    for (int x = 0; x + alongX < open.width(); ++x)
      if (region.at(x, y) && region.at(x + alongX, y + alongY)) {
        sum += std::abs(double(open.at(x + alongX, y + alongY)) - double(open.at(x, y)));
        ++count;
      }
  return sum / std::max(count, 1.0);
}

/// The share of the noise that is left in the direction in which more is, away from edges. A blur
/// along one direction alone leaves stripes.
double stripes(const View& view, const Image& open, const Image& noise) {
  const Regions& regions = regionsOf(view.scene, 0);
  const Mask inside = regions.covered & ~regions.edges;
  double most = 0;
  for (const auto& [x, y] : {std::pair{1, 0}, {0, 1}}) {
    const double least = roughness(regions.open, inside, x, y);
    most = std::max(most, (roughness(open, inside, x, y) - least) /
                              std::max(roughness(noise, inside, x, y) - least, 1e-6));
  }
  return most;
}

/// Pixel by pixel: noise counts, and so do edges that are lost.
///   noise: of the reference
Verdict blurred(const View& view, const Image& open, const Image& wanted, const Image& noise) {
  const Regions& regions = regionsOf(view.scene, 0);
  const double across = lostAcross(view, noise);
  const double left = apart(open, wanted, regions.covered & ~regions.edges);
  const double edges = apart(open, wanted, regions.covered & regions.edges);
  const double striped = stripes(view, open, noise);
  return {std::min({qualityOf(left, kNoiseFree, kNoiseGone),
                    qualityOf(edges / across, kEdgesFree, kEdgesGone),
                    qualityOf(striped, kStripesFree, kStripesGone)}),
          gg::say("the occlusion differs from a blur by {:.0f}% of what it keeps out, near "
                  "edges by {:.0f}% ({:.0f}% would be a blur across them); along rows or columns "
                  "{:.0f}% of the noise is left",
                  100 * left, 100 * edges, 100 * across, 100 * std::max(striped, 0.0))};
}

/// In the window or in any texture; as the reference's, or as a blur makes it of the submission's
/// own noise.
Verdict blurredAtLast(const View& view) {
  const Regions& regions = regionsOf(view.scene, 0);
  const std::vector<Opening> all = openings(view);
  std::vector<Image> found = {openInWindow(view, 0)}, wanted = {regions.open};
  for (const Opening& opening : all) found.push_back(opening.open);
  const Image noise = noiseOf(view);
  // However dark it is; but what has no noise has none to be removed.
  if (!all.empty() && stripes(view, all.front().open, noise) > kHasNoise)
    wanted.push_back(blurredWell(all.front().open, view));
  Verdict best{-1, ""};
  for (const Image& one : found)
    for (const Image& goal : wanted) {
      const Verdict verdict = blurred(view, one, goal, noise);
      if (verdict.quality > best.quality) best = verdict;
    }
  return best;
}
GGRADE_ITEM("ssao.blur", moving(blurredAtLast));

// ---- what the light makes of it

constexpr double kLightFree = 0.25, kLightGone = 0.8;
/// Least difference that ambient light makes for a pixel to tell how much of it there is.
constexpr float kLeastLight = 20.0f / 255;

/// How alike two occlusions are, however dark each is: Pearson's correlation over the region, -1 to
/// 1, and 0 where one of them is the same everywhere.
double correlation(const Image& a, const Image& b, const Mask& region) {
  double count = 0, sumA = 0, sumB = 0, sumAA = 0, sumBB = 0, sumAB = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      if (!region.at(x, y)) continue;
      const auto u = double(a.at(x, y)), v = double(b.at(x, y));
      count += 1, sumA += u, sumB += v, sumAA += u * u, sumBB += v * v, sumAB += u * v;
    }
  const double spread = (count * sumAA - sumA * sumA) * (count * sumBB - sumB * sumB);
  return spread > 0 ? (count * sumAB - sumA * sumB) / std::sqrt(spread) : 0;
}

/// Does the window's light follow the reference's occlusion, or else the submission's own?
Verdict applied(const View& view) {
  const Regions& regions = regionsOf(view.scene, 0);
  const Mask region = regions.covered & ~regions.edges &
                      differenceMask(view.scene.probes.at("unlit").at(0),
                                     view.scene.probes.at("unoccluded").at(0), kLeastLight);
  if (tooSmall(region)) return {0, gg::say("there is no ambient light to see it by")};
  constexpr int kReach = 2; // a texture may be coarser than the window
  const Image found = smoothed(openInWindow(view, 0), region, kReach);
  double least = apart(found, smoothed(regions.open, region, kReach), region);
  for (const Opening& opening : openings(view)) {
    const Image own = smoothed(opening.open, region, kReach);
    // What is followed must be an occlusion, however dark.
    if (apart(own, regions.open, region) < 0.8 || correlation(own, regions.open, region) > 0.7)
      least = std::min(least, apart(found, own, region));
  }
  return {
      qualityOf(least, kLightFree, kLightGone),
      gg::say("the ambient light differs by {:.0f}% of what the occlusion keeps out", 100 * least)};
}

GGRADE_ITEM("ssao.apply", moving(applied));

Verdict byHorizons(const View& view) {
  const double least = best(view, [&](const Image& open) { return likeness(view, open); });
  return {qualityOf(least, 0.08, 0.25), keptOut(least)};
}
GGRADE_ITEM("ssao.horizons", moving(byHorizons));

// ---- what must stay

GGRADE_ITEM("ssao.keep_picture", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) -> Verdict {
    const auto& probes = view.scene.probes;
    const LightRange light{probes.at("unlit").at(i), probes.at("unoccluded").at(i)};
    const Mask all(view.frames[i].width(), view.frames[i].height(), true);
    const Mask wrong = unexplained(view.frames[i], view.scene.reference.at(i), light, all);
    const double share = double(wrong.count()) / double(all.count());
    return {unharmed(share), gg::say("{:.1f}% of the pixels differ in another way than by less "
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
            gg::say("frame {}, with everything where it was in frame 1: {:.1f}% of the pixels "
                    "have changed{}",
                    i + 1, 100 * changed.wrongShare, densestAt(changed.densest))};
  }
  return {1, gg::say("nothing is ever where it was")};
});

GGRADE_ITEM("ssao.keep_following", [](const View& view) {
  const Effect occlusion = [](const View& of, std::size_t frame) {
    const Regions& regions = regionsOf(of.scene, frame);
    return below(openInWindow(of, frame), 0.8f) & regions.covered & ~regions.edges;
  };
  return follows(view, occlusion, gg::say("occlusion"));
});

} // namespace
