// The occlusion against ray tracing: how near each method and setting comes.

#include "drawn.hpp"

#include "truth/truth.hpp"

#include <glm/vec3.hpp>
#include <gmock/gmock.h>

#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <vector>

using namespace ggrade;
using nlohmann::json;

namespace {

class SsaoTruth : public testing::Test {
protected:
  /// Of the occlusion alone, in a small window.
  truth::Judgement ask(const json& quality, const json& change = json::object(), double time = 3) {
    json patch = {{"size", {240, 180}}, {"debug", {{"picture", 3}}}, {"quality", quality}};
    patch.merge_patch(change);
    const json scene = extremes::sceneOf("ssao", {"ssao"}, patch);
    const extremes::Drawn drawn = extremes::draw("ssao", scene, {time});
    const truth::Judgement answer =
        truth::judgeOf("ssao")({scene, time, drawn.frames.at(0), &drawn.trace});
    std::cout << quality.dump() << " " << change.dump();
    for (const truth::Error& error : answer.errors) {
      std::cout << "; " << error.name << " " << error.value;
      RecordProperty(error.name, std::to_string(error.value));
    }
    std::cout << "\n";
    return answer;
  }
  double error(const json& quality, const json& change = json::object()) {
    return ask(quality, change).errors.at(0).value;
  }
};

json settings(int method, int samples, int blur, int resolution = 1) {
  return {{"method", method}, {"samples", samples}, {"blur", blur}, {"resolution", resolution}};
}

/// Ground at the foot of a wall that is far higher and longer than the radius.
///   x: distance to it, in radii
/// Seen from above, directions weighed by the cosine fill a disc evenly; a direction that goes
/// towards the wall by u is hidden by 1 - x / u from u = x on, over a chord of 2 sqrt(1 - u^2).
double openBeforeAWall(double x) {
  const double root = std::sqrt(1 - x * x);
  const double chords = (std::acos(-1.0) / 2 - x * root - std::asin(x)) / 2;
  const double weighed = x * (std::log((1 + root) / x) - root);
  return 1 - 2 / std::acos(-1.0) * (chords - weighed);
}

TEST(SsaoTruthItself, IsRightBeforeAWall) {
  // The back of the wide box: its middle, and the way away from it.
  const double turn = 0.1, radius = 0.1;
  const glm::dvec3 away(-std::sin(turn), 0, -std::cos(turn));
  const glm::dvec3 middle = glm::dvec3(0.10, 0, -0.95) + 0.125 * away;
  for (const double x : {0.02, 0.1, 0.3, 0.7, 1.5}) {
    const glm::dvec3 point = middle + x * radius * away;
    const json scene = extremes::sceneOf(
        "ssao", {"ssao"},
        {{"debug", {{"picture", 3}}},
         {"ao", {{"radius", radius}}},
         {"camera", {{"position", {point.x, 0.5, point.z}}, {"target", {point.x, 0, point.z}}}}});
    const truth::Judgement answer = truth::judgeOf("ssao")({scene, 0, Image(1, 1, 4), nullptr});
    EXPECT_NEAR(answer.truth.at(0, 0), x < 1 ? openBeforeAWall(x) : 1, 0.005) << x;
  }
}

/// A camera, a radius, and how far off the preset `accurate` may be there.
struct View {
  std::string name;
  json change;
  double limit = 0.05;
};
json seenFrom(const json& position, double radius) {
  return {{"camera", {{"position", position}}}, {"ao", {{"radius", radius}}}};
}
const std::vector<View> kViews = {{"the handout's view", json::object()},
                                  {"the handout's view and size, radius 0.25",
                                   {{"size", {480, 360}}, {"ao", {{"radius", 0.25}}}}},
                                  {"the handout's view, radius 1", seenFrom({2.7, 1.7, 3.3}, 1)},
                                  {"from behind, radius 0.8", seenFrom({-2.6, 2.8, -3.2}, 0.8)},
                                  {"from the left, radius 0.4", seenFrom({-4.2, 1.9, 0.9}, 0.4)},
                                  {"low, radius 0.5", seenFrom({-3.4, 0.6, 1.6}, 0.5)},
                                  // Hardly a wall is seen, only what stands on it.
                                  {"from above, radius 0.3", seenFrom({0.6, 4.6, 1.2}, 0.3), 0.08}};

/// The first error of a picture of 1 everywhere.
double errorOfNothing(const Image& truth) {
  double sum = 0, count = 0;
  for (int y = 0; y < truth.height(); ++y)
    for (int x = 0; x < truth.width(); ++x)
      if (truth.at(x, y) < 0.9f) ++count, sum += 1 - double(truth.at(x, y));
  return sum / count;
}

TEST_F(SsaoTruth, AccurateIsWithinAHalfTenth) {
  for (const View& view : kViews) {
    std::cout << view.name << ": ";
    const truth::Judgement answer = ask("accurate", view.change);
    EXPECT_LE(answer.errors.at(0).value, view.limit) << view.name;
    EXPECT_GT(errorOfNothing(answer.truth), 0.2) << view.name;
    RecordProperty(view.name, std::to_string(answer.errors.at(0).value));
  }
}

TEST_F(SsaoTruth, Presets) {
  const double nothing = errorOfNothing(ask("reference").truth);
  const std::map<std::string, double> limits = {
      {"fast", 0.75 * nothing}, {"balanced", 0.5 * nothing}, {"reference", 0.05}};
  for (const auto& [preset, limit] : limits) {
    const double found = error(preset);
    EXPECT_LE(found, limit) << preset;
    RecordProperty(preset, std::to_string(found));
  }
}

TEST_F(SsaoTruth, PointsAreWithinATenth) {
  EXPECT_LT(error(settings(0, 16, 4)), 0.08);
  EXPECT_LT(error(settings(0, 16, 4), kViews.at(3).change), 0.1);
  EXPECT_LT(error(settings(0, 16, 2, 2)), 0.08) << "half resolution";
}

// The lower bound: what is known to be worse is told.
TEST_F(SsaoTruth, TellsAPictureWithoutOcclusion) {
  EXPECT_GT(error(settings(0, 16, 4), {{"effects", {{"ssao", false}}}}), 0.2);
  EXPECT_GT(error(settings(0, 16, 4), {{"effects", {{"ssao", false}}}, {"ao", {{"radius", 0.2}}}}),
            0.2);
}

/// Close to the back of the wide box, so that nothing is behind anything else.
TEST_F(SsaoTruth, WhereEverythingIsSeenTheMarchFindsWhatRaysDo) {
  const json corner = {
      {"camera",
       {{"position", {-0.03, 0.6, -2.27}}, {"target", {0.08, 0.08, -1.12}}, {"fov", 0.25}}},
      {"ao", {{"radius", 0.2}}}};
  const truth::Judgement answer = ask(settings(1, 256, 2), corner, 0);
  EXPECT_LT(answer.errors.at(5).value, 0.03) << "what is not seen";
  EXPECT_LT(answer.errors.at(4).value, 0.015) << "off what is seen";
  EXPECT_GT(ask(settings(1, 256, 2)).errors.at(5).value, 0.05) << "what is not seen";
}

TEST_F(SsaoTruth, TellsNoiseFromItsAverage) {
  for (const int method : {0, 1})
    EXPECT_GT(error(settings(method, 4, 0)), 1.1 * error(settings(method, 4, 2))) << method;
}

TEST_F(SsaoTruth, HorizonsComeNearerWithMoreSamples) {
  double last = 1;
  for (const int samples : {4, 16, 64}) {
    const double now = error(settings(1, samples, 2));
    EXPECT_LT(now, last) << samples;
    last = now;
  }
  EXPECT_LT(error(settings(1, 256, 2)), 1.05 * last) << "what is left isn't in the depth buffer";
}

} // namespace
