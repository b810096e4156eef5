// The figure gives no more light than it gets: white things in a furnace, and the sun apart from
// the sky. Expected values come from sums over directions in double precision, and from closed
// forms.

#include "truth_light.hpp"

#include "drawn.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <iostream>
#include <numbers>

using namespace ggrade;
using namespace deferred_truth;

namespace {

constexpr double kFurnace = 0.5; // radiance from everywhere

/// A ground, a matt knot, a glossy sphere and a metal box, all of this albedo: the materials undo
/// the objects' own colours.
json furnace(double albedo, int samples) {
  const auto undo = [&](double r, double g, double b) {
    return json{albedo / r, albedo / g, albedo / b};
  };
  json scene = {
      {"size", {320, 240}},
      {"camera", {{"fov", 0.36}}},
      {"ring", {{"count", 3}, {"radius", 1.0}}},
      {"sky", {{"uniform", true}}},
      {"sun", {{"brightness", 0}}},
      {"materials",
       {{"ground", {{"diffuse", {albedo, albedo, albedo}}, {"specular", {0.2, 0.2, 0.2}}}},
        {"matt", {{"diffuse", undo(0.8, 0.4, 0.4)}}},
        {"gloss", {{"diffuse", undo(0.4, 0.8, 0.4)}}},
        {"metal", {{"diffuse", undo(0.8, 0.8, 0.4)}}}}},
      {"quality", {{"format", 2}, {"normal", 0}, {"ao_samples", samples}}}};
  return extremes::sceneOf("deferred", {"figure"}, scene);
}

/// What the passes left of it, and what leaves the surfaces by sums over all directions.
struct InFurnace {
  Image composition;
  std::vector<dvec3> expected;
  std::vector<bool> counts; ///< not at an outline, where a pixel stands for two surfaces

  InFurnace(const json& scene, double time) {
    const extremes::Drawn drawn = extremes::draw("deferred", scene, {time});
    composition = drawn.leftBy(drawn.writerOf("uComposition"));
    const World world(scene, time, composition.width(), composition.height());
    const std::vector<truth::Surface> surfaces = look(world);
    expected = lightOf(world, surfaces, skyOf(scene), false);
    counts = smooth(world, surfaces);
    for (std::size_t i = 0; i < surfaces.size(); ++i) counts[i] = counts[i] && surfaces[i].id >= 0;
  }

  /// The largest difference of any channel, as a share of 1 or of what is expected if that is more.
  double off() const {
    double largest = 0;
    for (std::size_t i = 0; i < expected.size(); ++i)
      for (int c = 0; c < 3; ++c)
        if (counts[i])
          largest = std::max(largest, std::abs(light(i, c) - expected[i][c]) /
                                          std::max(expected[i][c], 1.0));
    return largest;
  }
  double light(std::size_t i, int c) const {
    const int width = composition.width();
    return double(composition.at(int(i) % width, int(i) / width, c));
  }
};

/// Whatever a white surface doesn't mirror it scatters: it can't be told from what is behind it.
TEST(DeferredEnergy, WhiteVanishesInAFurnace) {
  const InFurnace white(furnace(1, 0), 7);
  for (std::size_t i = 0; i < white.expected.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      ASSERT_NEAR(white.expected[i][c], kFurnace, 3e-4) << i; // the sum's steps
      ASSERT_NEAR(white.light(i, c), kFurnace, 1e-4) << i;
    }
}

/// Grey mirrors its share in full, and scatters half of the rest.
TEST(DeferredEnergy, GreyLosesHalfOfWhatItDoesNotMirror) {
  const InFurnace grey(furnace(0.5, 0), 7);
  EXPECT_LE(grey.off(), 1e-4);
  double least = 1, most = 0;
  for (std::size_t i = 0; i < grey.expected.size(); ++i)
    if (grey.counts[i]) {
      least = std::min(least, grey.light(i, 2)), most = std::max(most, grey.light(i, 2));
    }
  EXPECT_NEAR(least, 0.5 * kFurnace, 1e-3); // matt
  EXPECT_GT(most, 0.7 * kFurnace);          // at the sphere's rim
  EXPECT_LE(most, kFurnace);
}

/// Occlusion takes light away that would come from the neighbours: the model's loss, never a gain.
TEST(DeferredEnergy, OcclusionLosesLightAndMakesNone) {
  const InFurnace white(furnace(1, 16), 0); // as in the handout
  double least = 1, sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < white.expected.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      ASSERT_LE(white.light(i, c), kFurnace + 1e-4);
      if (!white.counts[i]) continue;
      least = std::min(least, white.light(i, c)), sum += white.light(i, c), ++count;
    }
  std::cout << "of the furnace's light surfaces have " << sum / double(count) / kFurnace
            << ", in the darkest crease " << least / kFurnace << "\n";
  EXPECT_LT(least, 0.8 * kFurnace);
  EXPECT_GT(sum / double(count), 0.9 * kFurnace);
}

/// Whether the sun is hidden is nothing that the share of open sky can tell.
TEST(DeferredEnergy, OcclusionLeavesTheSunsLightAlone) {
  const auto scene = [](int samples, double sky) {
    return extremes::sceneOf(
        "deferred", {"figure"},
        {{"size", {320, 240}},
         {"sky", {{"brightness", sky}}},
         {"quality", {{"format", 2}, {"normal", 0}, {"ao_samples", samples}}}});
  };
  const InFurnace sun(scene(32, 0), 7);
  std::cout << "the sun's light alone is off by " << sun.off() << "\n";
  EXPECT_LE(sun.off(), 0.01);
  const InFurnace occluded(scene(32, 1), 7); // the expected values are those of an open sky
  EXPECT_GT(occluded.off(), 0.1);
}

} // namespace
