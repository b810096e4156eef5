#pragma once
/// \file
/// What the three rubrics of post measure alike: how near a picture is to the reference, as a share
/// of what the effect changes.

#include "rubric/measures.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cmath>

namespace post_rubric {

using namespace ggrade;
using namespace ggrade::rubric;

/// Least difference that counts as the effect's, of 1.
inline constexpr float kLeastChange = 6.0f / 255;

/// An effect, or a part of it: what the reference draws with it and without.
struct Effect {
  const SceneEvidence& scene;
  std::string probe = "plain"; ///< the scene without it, see scenes.json

  const Image& with(std::size_t frame) const { return scene.reference.at(frame); }
  const Image& without(std::size_t frame) const { return scene.probes.at(probe).at(frame); }
  /// Where it changes what is seen.
  Mask changed(std::size_t frame) const {
    return differenceMask(with(frame), without(frame), kLeastChange);
  }
};

/// The sum of differences in a region, pixel by pixel.
inline double difference(const Image& a, const Image& b, const Mask& region) {
  double sum = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (region.at(x, y))
        for (int c = 0; c < 3; ++c) sum += std::abs(double(a.at(x, y, c)) - double(b.at(x, y, c)));
  return sum;
}

/// How far a frame is from the reference where the effect shows: 0 is the same, 1 as far as the
/// scene without it.
inline double apart(const View& view, std::size_t frame, const Effect& effect) {
  const Mask region = effect.changed(frame);
  const Image& wanted = effect.with(frame);
  return difference(view.frames.at(frame), wanted, region) /
         std::max(difference(effect.without(frame), wanted, region), 1e-6);
}

/// 1 down to 0 while `apart` rises from `free` to `gone`.
inline double qualityBetween(double apart, double free, double gone) {
  return std::clamp((gone - apart) / (gone - free), 0.0, 1.0);
}

/// The first frame, where the effect shows.
inline Verdict shows(const View& view, const Effect& effect, double free, double gone,
                     const std::string& what) {
  const Mask region = effect.changed(0);
  if (tooSmall(region)) return {1, gg::say("{}: nothing of it shows here", what)};
  const double off = apart(view, 0, effect);
  const Mask wrong = differenceMask(view.frames.at(0), effect.with(0), kLeastChange) & region;
  return {qualityBetween(off, free, gone),
          gg::say("{}: the picture is off by {:.0f}% of what it changes{}", what, 100 * off,
                  densestAt(densestWindow(wrong)))};
}

/// A picture to look at (edges, velocities), pixel by pixel.
inline Verdict pictured(const View& view, const Mask& region, double free, double gone,
                        const std::string& what) {
  CompareOptions options;
  options.mask = &region;
  options.radius = 0;
  const Comparison found = compare(view.frames.at(0), view.scene.reference.at(0), options);
  return {qualityBetween(found.wrongShare, free, gone),
          gg::say("{}: {:.1f}% of {} pixels differ{}", what, 100 * found.wrongShare,
                  found.judgedPixels, densestAt(found.densest))};
}

/// An item about the first frame: nothing of it is worth anything if later ones are the same.
inline Judge moving(Judge judge) {
  return [judge = std::move(judge)](const View& view) -> Verdict {
    if (frozen(view)) return {0, gg::say("the picture stays as it is, although time passes")};
    return judge(view);
  };
}

/// How much of what the effect leaves alone has changed.
inline Verdict leftAlone(const View& view, std::size_t frame, const Effect& effect) {
  const Mask rest = ~dilate(effect.changed(frame), 2);
  const Mask wrong = differenceMask(view.frames.at(frame), effect.with(frame), kLeastChange) & rest;
  const double share = double(wrong.count()) / double(std::max<std::size_t>(rest.count(), 1));
  return {unharmed(share), gg::say("{:.1f}% of the rest of the picture has changed{}", 100 * share,
                                   densestAt(densestWindow(wrong)))};
}

} // namespace post_rubric
