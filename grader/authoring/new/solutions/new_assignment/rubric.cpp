// The rubric of new_assignment. Titles and points stand in assignment.json.
//
// Where the object is is learned from a probe (scenes.json): the reference in a scene that shows it
// white on black. Nothing here knows how a student has drawn it.

#include "rubric/rubric.hpp"
#include "image/compare.hpp"

#include <fmt/format.h>

#include <algorithm>

using namespace ggrade;
using rubric::Verdict;
using rubric::View;

namespace {

/// Share of the object's pixels that costs nothing when it differs, and at which nothing is left.
constexpr double kOtherWays = 0.02, kNothingLeft = 0.4;

/// How many of the object's pixels in a frame are as the reference has them.
Verdict judgeFrame(const View& view, std::size_t frame) {
  const Image& probe = view.scene.probes.at("object").at(frame);
  const Image black(probe.width(), probe.height(), probe.channels());
  const Mask object = differenceMask(probe, black, 0.5f);
  CompareOptions options;
  options.mask = &object;
  const Comparison found = compare(view.frames.at(frame), view.scene.reference.at(frame), options);
  const double quality = (kNothingLeft - found.wrongShare) / (kNothingLeft - kOtherWays);
  return {std::clamp(quality, 0.0, 1.0), fmt::format("{:.1f}% of the object's {} pixels differ",
                                                     100 * found.wrongShare, object.count())};
}

GGRADE_ITEM("new_assignment.diffuse", [](const View& view) {
  Verdict worst{2, ""};
  for (std::size_t frame = 0; frame < view.frames.size(); ++frame) {
    const Verdict one = judgeFrame(view, frame);
    if (one.quality < worst.quality) worst = one;
  }
  return worst;
});

} // namespace
