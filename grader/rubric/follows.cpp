#include "rubric/follows.hpp"

#include "words/words.hpp"

#include <algorithm>
#include <cmath>

namespace ggrade::rubric {

using gg::say;

namespace {

/// Pixels that an edge may move without counting as a change.
constexpr int kStill = 2;
/// The reference must change by so much for a scene to show anything.
constexpr double kVisibleChange = 0.2;
/// Shares of the reference's change: what edges and noise make, and what is a change like any. A
/// right bloom of another filter, with wider halos, changes by 0.7 of it.
constexpr double kNoise = 0.2, kAChange = 0.5;
/// A submission has an effect if it covers so much of what it does in the reference.
constexpr double kThere = 0.2;

/// How different two masks are: 0 equal to `kStill` pixels, 1 nothing in common.
double change(const Mask& before, const Mask& after) {
  const Agreement pixels = agreement(before, after, kStill);
  return double(pixels.missing + pixels.extra) /
         double(std::max<std::size_t>(before.count() + after.count(), 1));
}

/// Of two frames: both masks and how much there is of them.
struct Pair {
  Mask before, after;
  std::size_t pixels() const { return before.count() + after.count(); }
};

/// `passes`: time did. A changed scene's name says what was changed, and stands before the message.
Verdict responds(const Pair& student, const Pair& reference, bool passes, const std::string& what) {
  const double expected = change(reference.before, reference.after);
  if (expected < kVisibleChange) return {1, say("the change is too small to see")};
  const double found = change(student.before, student.after);
  const double share = found / expected;
  return {std::clamp((share - kNoise) / (kAChange - kNoise), 0.0, 1.0),
          passes ? say("time passed: {:.0f}% of the {} changed place, {:.0f}% in the reference",
                       100 * found, what, 100 * expected)
                 : say("{:.0f}% of the {} changed place, {:.0f}% in the reference", 100 * found,
                       what, 100 * expected)};
}

Verdict stays(const Pair& student, const Pair& reference, const Image& before, const Image& after,
              const std::string& what) {
  const double expected = change(reference.before, reference.after);
  const double found = change(student.before, student.after);
  return {1 - std::clamp((found - expected - 0.1) / 0.3, 0.0, 1.0),
          say("the window became {} instead of {}: {:.0f}% of the {} changed place, {:.0f}% in the "
              "reference",
              after.sizeText(), before.sizeText(), 100 * found, what, 100 * expected)};
}

} // namespace

Mask throughWindow(const Mask& mask, int width, int height, Mask& seen) {
  Mask out(width, height);
  seen = Mask(width, height);
  const double scale = double(height) / double(mask.height());
  for (int y = 0; y < height; ++y) {
    const int fromY = std::min(int((y + 0.5) / scale), mask.height() - 1);
    for (int x = 0; x < width; ++x) {
      const double fromX = std::floor((x + 0.5 - 0.5 * width) / scale + 0.5 * mask.width());
      if (fromX < 0 || fromX >= mask.width()) continue;
      seen.set(x, y);
      out.set(x, y, mask.at(int(fromX), fromY));
    }
  }
  return out;
}

Verdict follows(const View& view, const Effect& effect, const std::string& what) {
  const SceneEvidence& scene = view.scene;
  const View reference{scene, scene.reference, scene.referenceTrace};
  const bool passes = scene.like.empty();
  if (passes ? view.frames.size() < 2 : !view.base) return {1, say("nothing to compare with")};

  Pair wanted, found;
  wanted.after = effect(reference, passes ? 1 : 0);
  found.after = effect(view, passes ? 1 : 0);
  if (passes) {
    wanted.before = effect(reference, 0);
    found.before = effect(view, 0);
  } else {
    const SceneEvidence& base = *view.base;
    wanted.before = effect({base, base.reference, base.referenceTrace}, 0);
    found.before = effect({base, base.student, base.studentTrace}, 0);
  }
  const Image& before = passes ? scene.reference[0] : view.base->reference[0];
  const Image& after = scene.reference[passes ? 1 : 0];
  const bool resized = !sameSize(before, after);
  if (resized)
    for (Pair* pair : {&wanted, &found}) {
      Mask seen;
      pair->before = throughWindow(pair->before, after.width(), after.height(), seen);
      pair->after = pair->after & seen;
    }
  if (double(found.pixels()) < kThere * double(wanted.pixels()))
    return {1, say("there is no {} that could follow", what)};
  if (resized) return stays(found, wanted, before, after, what);
  return responds(found, wanted, passes, what);
}

} // namespace ggrade::rubric
