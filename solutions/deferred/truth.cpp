// Both parts held against forward shading without any texture.

#include "truth_light.hpp"

#include "rubric/passes.hpp"

#include <algorithm>
#include <cmath>

using namespace deferred_truth;

namespace {

/// Where this share of the light or more arrives, nothing counts as dark.
constexpr double kOpen = 0.9;

/// A picture as a window should show it, and the pixels that are looked at.
struct Wanted {
  Image picture;
  std::vector<bool> counts;
};

Wanted targets(const truth::Rendered& rendered) {
  const World world(rendered.scene, rendered.time, rendered.window.width(),
                    rendered.window.height());
  const std::vector<truth::Surface> surfaces = look(world);
  const std::vector<dvec3> light = compose(world, shade(world, surfaces, rendered.scene),
                                           rendered.scene.at("effects").at("edges").get<bool>());
  Wanted wanted{Image(world.width, world.height, 3), smooth(world, surfaces)};
  for (std::size_t i = 0; i < light.size(); ++i)
    for (int c = 0; c < 3; ++c)
      wanted.picture.values()[3 * i + std::size_t(c)] = float(truth::cut(light[i])[c]);
  return wanted;
}

double sumOf(const dvec3& light) {
  return light.x + light.y + light.z;
}

Wanted figure(const truth::Rendered& rendered) {
  const World world(rendered.scene, rendered.time, rendered.window.width(),
                    rendered.window.height());
  const std::vector<truth::Surface> surfaces = look(world);
  const Sky sky = skyOf(rendered.scene);
  const bool visibility = rendered.truth.is_object() && rendered.truth.value("visibility", false);
  const std::vector<dvec3> open = lightOf(world, surfaces, sky, false);
  const std::vector<dvec3> light = visibility ? lightOf(world, surfaces, sky, true) : open;
  Wanted wanted{Image(world.width, world.height, 3), smooth(world, surfaces)};
  for (std::size_t i = 0; i < light.size(); ++i) {
    const bool isDark = sumOf(light[i]) < kOpen * sumOf(open[i]);
    wanted.counts[i] = wanted.counts[i] && surfaces[i].id >= 0 && (isDark || !visibility);
    for (int c = 0; c < 3; ++c)
      wanted.picture.values()[3 * i + std::size_t(c)] = float(display(light[i])[c]);
  }
  return wanted;
}

/// The composition as a window of more than 8 bits a channel would show it; if the trace doesn't
/// have it, the window itself.
Image compositionOf(const truth::Rendered& rendered) {
  if (!rendered.trace) return firstChannels(rendered.window, 3);
  for (const rubric::Drawn& drawn : rubric::sampledLater(*rendered.trace)) {
    if (drawn.uniform != "uComposition") continue;
    Image image = firstChannels(rendered.trace->image(*drawn.copy), 3);
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const auto pixel = image.pixel(x, y);
        const dvec3 shown = display({pixel[0], pixel[1], pixel[2]});
        for (int c = 0; c < 3; ++c) image.at(x, y, c) = float(shown[c]);
      }
    return image;
  }
  return firstChannels(rendered.window, 3);
}

/// Errors of what is shown, 0 to 1, in channels of the pixels that count:
///   mean error     mean of |found - wanted|
///   largest error
/// Left out are pixels whose eight neighbours are not all on the same smooth piece of a surface.
truth::Judgement judged(const Image& found, const Wanted& wanted) {
  double sum = 0, largest = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < found.values().size(); ++i) {
    if (!wanted.counts[i / 3]) continue;
    const double off = std::abs(double(found.values()[i]) - double(wanted.picture.values()[i]));
    sum += off, largest = std::max(largest, off), ++count;
  }
  truth::Judgement answer;
  answer.errors = {{"mean error", count > 0 ? sum / double(count) : 0}, {"largest error", largest}};
  answer.truth = wanted.picture;
  answer.rendered = found;
  answer.difference = truth::shownDifference(answer.truth, answer.rendered);
  return answer;
}

GGRADE_TRUTH("targets", [](const truth::Rendered& rendered) {
  return judged(firstChannels(rendered.window, 3), *truth::kept<Wanted>(rendered, targets));
});

/// Of the composition before it is rounded to the window's 8 bits; the background, which has no
/// surface to light, doesn't count.
///   truth: { "visibility": true } keeps the light off that comes from where something stands in
///   the way, as occlusion should, and looks only where that takes a tenth of the light or more.
///   Without it all of the environment is seen from everywhere.
GGRADE_TRUTH("figure", [](const truth::Rendered& rendered) {
  return judged(compositionOf(rendered), *truth::kept<Wanted>(rendered, figure));
});

} // namespace
