// Bloom held against its pyramid in double precision, and against exact Gaussians of the true
// light.

#include "truth_pyramid.hpp"
#include "truth_world.hpp"

#include "image/statistics.hpp"
#include "rubric_pyramid.hpp"

#include <cmath>
#include <stdexcept>

using namespace floor_truth;
using truth::Light;

namespace {

/// The lecture's number of levels.
constexpr int kLevels = 6;

/// The light that arrives at the eye, before anything is stored or cut off.
Light sceneLight(const truth::Rendered& rendered) {
  const World world = worldOf(rendered);
  Light light(world.width, world.height);
  for (int y = 0; y < world.height; ++y)
    for (int x = 0; x < world.width; ++x) {
      const Seen seen = world.seen(x, y);
      light.at(x, y) = world.shown(seen, world.visibility(seen.surface));
    }
  return light;
}

/// The sRGB curve (IEC 61966-2-1), after what a display can't show is cut off.
Image displayed(const Light& light) {
  Image image = imageOf(light);
  for (float& value : image.values()) {
    const double cut = std::min(double(value), 1.0);
    value = float(cut > 0.0031308 ? 1.055 * std::pow(cut, 1 / 2.4) - 0.055 : 12.92 * cut);
  }
  return image;
}

/// Of the scene and the sum of levels.
Light composite(const Light& scene, const Light& sum, int kind, truth::Edge edge) {
  Light all = finite(scene);
  addTo(all, 1, apply(sum, upFilter(kind, {sum.width, sum.height}, {all.width, all.height}, edge)));
  return all;
}

/// Errors; the light that is judged is the largest level after the last addition:
///   difference from the exact Gaussians
///       Against the true light (ray traced, nothing stored), its bright pass, and the mean of the
///       lecture's six Gaussians, each with the variance that the filter's way to that level and
///       back has: the sum of |found - wanted| as a share of all wanted light. What is lost by
///       fewer levels, by a filter that is not round or by a coarse format shows here, so settings
///       are compared by it. A filter is not blamed for being wider or narrower than another.
///   bloom relative error, bloom mean relative error, energy
///       Against the recorded scene through the very same levels and filter in double precision:
///       what rounding has changed. |found - wanted| / wanted where more than 1e-3 is wanted, else
///       / 1e-3, so that 1% stands for 1e-5 there; the greatest and the mean over all pixels and
///       channels; and how far the sums are apart.
///   window RMSE
///       The window against the recorded scene and that sum, 0 to 1 as displayed.
truth::Judgement judge(const truth::Rendered& rendered) {
  if (!rendered.trace)
    throw std::invalid_argument("the bloom's truth needs the passes that were recorded");
  const floor_rubric::Pyramid recorded = floor_rubric::ownPyramid(*rendered.trace);
  if (recorded.scene.empty())
    throw std::invalid_argument("the bloom's truth finds no pass that draws the scene into a "
                                "texture: set effects.bloom to true and record passes with copies");
  const json& quality = rendered.scene.at("quality");
  const int count = quality.at("bloom_levels").get<int>();
  const int kind = quality.at("bloom_filter").get<int>();
  const auto edge =
      quality.at("bloom_edge").get<int>() == 0 ? truth::Edge::clamp : truth::Edge::mirror;
  const double threshold = rendered.scene.at("bloom").at("threshold").get<double>();

  const Light scene = truth::lightOf(recorded.scene);
  const Light wanted = levelSum(brightPass(scene, threshold), count, kind, edge);
  // Where nothing is bright no level is drawn.
  const Light found = recorded.levels.empty() ? Light(wanted.width, wanted.height)
                                              : truth::lightOf(recorded.levels[0].up);
  const auto light = kept<Light>(rendered, sceneLight);
  const Light ideal = gaussianSum(brightPass(*light, threshold), kLevels, kind, edge);

  truth::Judgement answer;
  answer.truth = displayed(composite(scene, wanted, kind, edge));
  answer.rendered = firstChannels(rendered.window, 3);
  answer.difference = shownDifference(answer.rendered, answer.truth);
  const LightErrors errors = compareLight(found, wanted);
  answer.errors = {{"difference from the exact Gaussians", compareLight(found, ideal).misplaced},
                   {"bloom relative error", errors.greatest},
                   {"bloom mean relative error", errors.mean},
                   {"energy", errors.energy},
                   {"window RMSE", errorStatistics(answer.rendered, answer.truth).rmsError}};
  return answer;
}

GGRADE_TRUTH("bloom", judge);

} // namespace
