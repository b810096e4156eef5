#include "rubric/measures.hpp"

#include "words/words.hpp"

#include <algorithm>

namespace ggrade::rubric {

namespace {

/// Share of the pixels that differ between two frames of a scene that moves.
constexpr double kMoves = 0.002;

} // namespace

double qualityOf(double wrongShare, double nothingLeft) {
  return qualityOf(wrongShare, kOtherWays, nothingLeft);
}

double qualityOf(double apart, double free, double gone) {
  return std::clamp((gone - apart) / (gone - free), 0.0, 1.0);
}

Mask shown(const Image& probe) {
  return differenceMask(probe, Image(probe.width(), probe.height(), probe.channels()), 0.1f);
}

Agreement agreement(const Mask& wanted, const Mask& found, int reach) {
  return {(wanted & ~dilate(found, reach)).count(), (found & ~dilate(wanted, reach)).count(),
          std::max<std::size_t>(wanted.count(), 1)};
}

std::string densestAt(const Window& window) {
  if (window.pixels == 0) return "";
  return gg::say(", densest at ({},{})", window.x + window.width / 2, window.y + window.height / 2);
}

Verdict within(const Image& found, const Image& wanted, const Mask& region,
               const std::string& what) {
  CompareOptions options;
  options.mask = &region;
  const Comparison comparison = compare(found, wanted, options);
  const double quality = qualityOf(comparison.wrongShare, kNothingLeft);
  return {quality, gg::say("{}: {:.1f}% of {} pixels differ{}", what, 100 * comparison.wrongShare,
                           comparison.judgedPixels, densestAt(comparison.densest))};
}

Verdict within(const View& view, std::size_t frame, const Mask& region, const std::string& what) {
  return within(view.frames.at(frame), view.scene.reference.at(frame), region, what);
}

bool frozen(const View& view) {
  const Frames& reference = view.scene.reference;
  bool moves = false;
  for (std::size_t i = 1; i < view.frames.size(); ++i) {
    if (!std::ranges::equal(view.frames[i].values(), view.frames[0].values())) return false;
    moves = moves || compare(reference.at(i), reference.at(0)).wrongShare > kMoves;
  }
  return moves;
}

Judge moving(Judge judge) {
  return [judge = std::move(judge)](const View& view) -> Verdict {
    if (frozen(view)) return {0, gg::say("the picture stays as it is, although time passes")};
    return judge(view);
  };
}

bool tooSmall(const Mask& region) {
  return region.count() < 50;
}

} // namespace ggrade::rubric
