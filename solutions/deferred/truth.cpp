// Both parts held against forward shading without any texture.

#include "truth_light.hpp"

#include <algorithm>
#include <cmath>

using namespace deferred_truth;

namespace {

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

Wanted figure(const truth::Rendered& rendered) {
  const World world(rendered.scene, rendered.time, rendered.window.width(),
                    rendered.window.height());
  const std::vector<truth::Surface> surfaces = look(world);
  const std::vector<dvec3> light =
      lightOf(world, surfaces, skyOf(rendered.scene),
              rendered.truth.is_object() && rendered.truth.value("visibility", false));
  Wanted wanted{Image(world.width, world.height, 3), smooth(world, surfaces)};
  for (std::size_t i = 0; i < light.size(); ++i) {
    wanted.counts[i] = wanted.counts[i] && surfaces[i].id >= 0;
    for (int c = 0; c < 3; ++c)
      wanted.picture.values()[3 * i + std::size_t(c)] = float(display(light[i])[c]);
  }
  return wanted;
}

/// Errors, 0 to 1 as the window shows it, in channels of the pixels that count:
///   mean error     mean of |found - wanted|
///   largest error
/// Left out are pixels whose eight neighbours are not all on the same smooth piece of a surface;
/// with `figure` the background, too, which has no surface to light.
truth::Answer judged(const truth::Rendered& rendered, const Wanted& wanted) {
  double sum = 0, largest = 0;
  std::size_t count = 0;
  for (int y = 0; y < rendered.window.height(); ++y)
    for (int x = 0; x < rendered.window.width(); ++x) {
      if (!wanted.counts[std::size_t(y) * std::size_t(rendered.window.width()) + std::size_t(x)])
        continue;
      for (int c = 0; c < 3; ++c) {
        const double off =
            std::abs(double(rendered.window.at(x, y, c)) - double(wanted.picture.at(x, y, c)));
        sum += off, largest = std::max(largest, off), ++count;
      }
    }
  truth::Answer answer;
  answer.errors = {{"mean error", count > 0 ? sum / double(count) : 0}, {"largest error", largest}};
  answer.truth = wanted.picture;
  answer.rendered = firstChannels(rendered.window, 3);
  answer.difference = truth::shownDifference(answer.truth, answer.rendered);
  return answer;
}

GGRADE_TRUTH("targets", [](const truth::Rendered& rendered) {
  return judged(rendered, *truth::kept<Wanted>(rendered, targets));
});

/// truth: { "visibility": true } keeps the light off that comes from where something stands in the
/// way, as occlusion should; without it all of the environment is seen from everywhere.
GGRADE_TRUTH("figure", [](const truth::Rendered& rendered) {
  return judged(rendered, *truth::kept<Wanted>(rendered, figure));
});

} // namespace
