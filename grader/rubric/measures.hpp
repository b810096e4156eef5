#pragma once
/// \file
/// What rubrics measure alike: masks that agree, colours in a region, frames that stay right.

#include "image/compare.hpp"
#include "image/mask.hpp"
#include "rubric/rubric.hpp"

#include <string>

namespace ggrade::rubric {

/// Share of wrong pixels at which an item about a region has nothing left.
inline constexpr double kNothingLeft = 0.4;
/// Share that costs nothing: other ways to the same picture differ by that much. Measured over 12
/// seeds: a texture of 2048 pixels differs by up to 0.1%, one of half floats by 0.9%. One of 512 is
/// coarser than the window: up to 3.5% of the densest window show the wrong object, 2.8 points.
inline constexpr double kOtherWays = 0.02;

/// 1 down to 0 while the wrong share rises from kOtherWays to `nothingLeft`.
double qualityOf(double wrongShare, double nothingLeft = kNothingLeft);

/// 1 down to 0 while any other measure of what is off rises from `free` to `gone`.
double qualityOf(double apart, double free, double gone);

/// Pixels that a probe with a black background shows something in.
Mask shown(const Image& probe);

/// Where two masks agree, an edge may move by `reach` pixels.
struct Agreement {
  std::size_t missing = 0; ///< wanted but not found
  std::size_t extra = 0;   ///< found but not wanted
  std::size_t wanted = 0;  ///< at least 1
  double wrongShare() const { return double(missing + extra) / double(wanted); }
};
Agreement agreement(const Mask& wanted, const Mask& found, int reach);

/// ", densest at (x,y)", or nothing when nothing is wrong.
std::string densestAt(const Window& window);

/// The tolerant comparison of a picture inside `region`, as a verdict.
Verdict within(const Image& found, const Image& wanted, const Mask& region,
               const std::string& what);

/// The same of a frame with the reference's.
Verdict within(const View& view, std::size_t frame, const Mask& region, const std::string& what);

/// Do all frames show the very same, although the reference's don't? That is a picture, and no
/// program: nothing of it is worth anything.
bool frozen(const View& view);

/// An item about the first frame: nothing of it is worth anything if later ones are the same.
Judge moving(Judge judge);

/// A region so small that a frame can't show the item.
bool tooSmall(const Mask& region);

/// The worst of the frames. `judge(frame)` gives a Verdict.
template <class Judge> Verdict worstFrame(const View& view, Judge judge) {
  Verdict worst{2, ""};
  for (std::size_t i = 0; i < view.frames.size(); ++i) {
    const Verdict one = judge(i);
    if (one.quality < worst.quality) worst = one;
  }
  return worst;
}

/// How much worse later frames are than the first. `wrong(frame, where)` gives the share of spoiled
/// pixels and says where.
template <class Wrong> Verdict laterFrames(const View& view, Wrong wrong) {
  std::string where, later;
  const double first = wrong(0, where);
  double worst = 0;
  for (std::size_t i = 1; i < view.frames.size(); ++i) {
    const double share = wrong(i, where);
    if (share - first > worst)
      worst = share - first, later = "frame " + std::to_string(i + 1) + ": " + where;
  }
  if (worst < 0.005) return {1, "later frames are as right as the first"};
  return {1 - std::clamp((worst - 0.005) / 0.1, 0.0, 1.0), later + ", the first frame did not"};
}

/// What a share of spoiled pixels leaves of the rest of the picture.
inline double unharmed(double share) {
  return 1 - std::clamp((share - 0.005) / 0.25, 0.0, 1.0);
}

} // namespace ggrade::rubric
