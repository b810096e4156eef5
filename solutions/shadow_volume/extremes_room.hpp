#pragma once
// The solution's pictures of the Cornell box, held against the truth: what its tests at the ends of
// what a scene may ask for share.

#include "drawn.hpp"
#include "truth_room.hpp"

#include <gmock/gmock.h>

namespace shadow_volume_extremes {

using namespace extremes;
using shadow_volume_truth::Counts;
using shadow_volume_truth::Room;

/// A small window, a lamp that stands still, and light so bright that it shows at any angle;
/// `patch` over it.
inline json room(const json& patch = json::object()) {
  json all = {{"size", {128, 128}},
              {"orbit", {{"radius", 0}}},
              {"light",
               {{"ambient", {0.2, 0.2, 0.2}}, {"diffuse", {20, 20, 20}}, {"specular", {0, 0, 0}}}}};
  all.merge_patch(patch);
  return sceneOf("shadow_volume", {}, all);
}

/// The name of a test with these quality numbers: edges1passes2.
inline std::string nameOfQuality(const testing::TestParamInfo<json>& info) {
  std::string name;
  for (const auto& [key, value] : info.param.items()) name += key + value.dump();
  return name;
}

/// A frame of the solution against the truth.
inline Counts countsOf(const json& scene, double time, const Image& window) {
  const ggrade::truth::Rendered rendered{scene, time, window};
  return count(
      *ggrade::truth::kept<shadow_volume_truth::Shadows>(rendered, shadow_volume_truth::shadowsOf),
      window);
}

/// What the solution draws in the scene is right, to the pixel, at every time. Returns what was
/// compared, all times together.
///   prints: what the program should say
///   most: so many pixels of a frame may be wrong all the same; say why
inline Counts expectRight(const json& scene, const std::vector<double>& times = {0},
                          const testing::Matcher<std::string>& prints = "", std::size_t most = 0) {
  const Drawn drawn = draw("shadow_volume", scene, times, {}, prints);
  Counts sum;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Counts counts = countsOf(scene, times[i], drawn.frames.at(i));
    EXPECT_LE(counts.falseShadow, most) << "of " << counts.lit << " lit pixels, at " << times[i];
    EXPECT_LE(counts.falseLight, most) << "of " << counts.dark << " in shadow, at " << times[i];
    EXPECT_EQ(counts.strange, 0u) << "neither lit nor dark, at " << times[i];
    sum.lit += counts.lit, sum.dark += counts.dark;
  }
  return sum;
}

} // namespace shadow_volume_extremes
