// The occlusion against ray tracing: how near each method and setting comes.

#include "drawn.hpp"

#include "truth/truth.hpp"

#include <glm/vec3.hpp>
#include <gmock/gmock.h>

#include <cmath>
#include <iostream>

using namespace ggrade;
using nlohmann::json;

namespace {

class SsaoTruth : public testing::Test {
protected:
  /// Of the occlusion alone, in a small window.
  truth::Answer ask(const json& quality, const json& change = json::object(), double time = 3) {
    json patch = {{"size", {240, 180}}, {"debug", {{"picture", 3}}}, {"quality", quality}};
    patch.merge_patch(change);
    const json scene = extremes::sceneOf("ssao", {"ssao"}, patch);
    const extremes::Drawn drawn = extremes::draw("ssao", scene, {time});
    const truth::Answer answer =
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
    const truth::Answer answer = truth::judgeOf("ssao")({scene, 0, Image(1, 1, 4), nullptr});
    EXPECT_NEAR(answer.truth.at(0, 0), x < 1 ? openBeforeAWall(x) : 1, 0.005) << x;
  }
}

/// Another view than the handout's, a larger radius.
const json kElsewhere = {{"camera", {{"position", {-2.4, 2.6, -2.9}}, {"fov", 0.7}}},
                         {"ao", {{"radius", 0.8}}}};

TEST_F(SsaoTruth, HorizonsAreWithinAHalfTenth) {
  EXPECT_LT(error(settings(1, 64, 2)), 0.05);
  EXPECT_LT(error(settings(1, 256, 2)), 0.05);
  EXPECT_LT(error(settings(1, 256, 2), kElsewhere), 0.05);
}

TEST_F(SsaoTruth, PointsAreWithinATenth) {
  EXPECT_LT(error(settings(0, 16, 4)), 0.08);
  EXPECT_LT(error(settings(0, 16, 4), kElsewhere), 0.1);
  EXPECT_LT(error(settings(0, 16, 2, 2)), 0.08) << "half resolution";
}

// The lower bound: what is known to be worse is told.
TEST_F(SsaoTruth, TellsAPictureWithoutOcclusion) {
  EXPECT_GT(error(settings(0, 16, 4), {{"effects", {{"ssao", false}}}}), 0.2);
  EXPECT_GT(error(settings(0, 16, 4), {{"effects", {{"ssao", false}}}, {"ao", {{"radius", 0.2}}}}),
            0.2);
}

TEST_F(SsaoTruth, TellsNoiseFromItsAverage) {
  for (const int method : {0, 1})
    EXPECT_GT(error(settings(method, 4, 0)), 1.1 * error(settings(method, 4, 2))) << method;
}

TEST_F(SsaoTruth, HorizonsComeNearerWithMoreSamples) {
  double last = 1;
  for (const int samples : {4, 16, 64, 256}) {
    const double now = error(settings(1, samples, 2));
    EXPECT_LT(now, last) << samples;
    last = now;
  }
}

} // namespace
