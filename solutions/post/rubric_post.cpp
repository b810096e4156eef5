#include "rubric_post.hpp"

namespace post_rubric {

namespace {

/// The sum of differences in a region, pixel by pixel.
double difference(const Image& a, const Image& b, const Mask& region) {
  double sum = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (region.at(x, y))
        for (int c = 0; c < 3; ++c) sum += std::abs(double(a.at(x, y, c)) - double(b.at(x, y, c)));
  return sum;
}

} // namespace

double apart(const View& view, std::size_t frame, const Effect& effect) {
  const Mask region = dilate(effect.changed(frame), kNear);
  const Image& wanted = effect.with(frame);
  return difference(view.frames.at(frame), wanted, region) /
         std::max(difference(effect.without(frame), wanted, region), 1e-6);
}

Verdict shows(const View& view, const Effect& effect, double free, double gone,
              const std::string& what) {
  const Mask region = effect.changed(0);
  if (tooSmall(region)) return {1, gg::say("{}: nothing of it shows here", what)};
  const double off = apart(view, 0, effect);
  const Mask wrong =
      differenceMask(view.frames.at(0), effect.with(0), kLeastChange) & dilate(region, kNear);
  return {qualityOf(off, free, gone),
          gg::say("{}: the picture is off by {:.0f}% of what it changes{}", what, 100 * off,
                  densestAt(densestWindow(wrong)))};
}

Verdict pictured(const View& view, const Mask& region, double free, double gone,
                 const std::string& what) {
  CompareOptions options;
  options.mask = &region;
  options.radius = 0;
  const Comparison found = compare(view.frames.at(0), view.scene.reference.at(0), options);
  return {qualityOf(found.wrongShare, free, gone),
          gg::say("{}: {:.1f}% of {} pixels differ{}", what, 100 * found.wrongShare,
                  found.judgedPixels, densestAt(found.densest))};
}

Verdict leftAlone(const View& view, std::size_t frame, const Effect& effect) {
  const Mask rest = ~dilate(effect.changed(frame), kNear);
  const Mask wrong = differenceMask(view.frames.at(frame), effect.with(frame), kLeastChange) & rest;
  const double share = double(wrong.count()) / double(std::max<std::size_t>(rest.count(), 1));
  return {unharmed(share), gg::say("{:.1f}% of the rest of the picture has changed{}", 100 * share,
                                   densestAt(densestWindow(wrong)))};
}

} // namespace post_rubric
