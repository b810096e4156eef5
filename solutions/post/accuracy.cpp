// Smooth edges, motion blur and afterglow against rays: is the truth itself right, and how near
// does each method come?

#include "drawn.hpp"

#include "truth/truth.hpp"

#include <glm/vec2.hpp>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace ggrade;
using nlohmann::json;

namespace {

constexpr double kPi = 3.14159265358979323846;

/// As tone.frag shows light, and the light of the screen before that.
double toned(double light) {
  return 1 - std::exp(-light);
}
double encoded(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

/// The truth of a scene in which nothing has been drawn.
Image truthOf(const std::string& part, const json& scene, double time, const json& told = {}) {
  const auto size = scene.at("size").get<std::vector<int>>();
  return truth::judgeOf(part)(
             {.scene = scene, .time = time, .window = Image(size[0], size[1], 4), .truth = told})
      .truth;
}

/// Without shading: what an object is lit by is its own colour.
const json kFlat = {{"ambient", {1, 1, 1}}, {"diffuse", {0, 0, 0}}, {"specular", {0, 0, 0}}};

/// The area of a unit square below the line normal * p = 0, by its corners: the square's middle
/// lies `away` from the line.
double areaBelow(glm::dvec2 normal, double away) {
  normal = {std::max(std::abs(normal.x), 1e-9), std::max(std::abs(normal.y), 1e-9)};
  double sum = 0;
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5}) {
      const double below = std::max(away - normal.x * x - normal.y * y, 0.0);
      sum += (x * y > 0 ? 1 : -1) * below * below / 2;
    }
  return sum / (normal.x * normal.y);
}

TEST(PostTruthItself, AnEdgeCoversItsAreaAtEveryAngle) {
  // Straight onto one side of a wire that is wider than the window, as are the gaps between them.
  constexpr int kSide = 12;
  constexpr double kThick = 0.1, kAway = 2, kFov = 0.02, kBeside = 0.0013;
  for (const int wire : {0, 1, 2, 3, 5, 6}) {
    const double angle = 2 * kPi * wire / 25; // of the wire, from upright
    const glm::dvec2 along(-std::sin(angle), std::cos(angle)),
        across(std::cos(angle), std::sin(angle));
    const double front = -1.2 + kThick / 2;
    const glm::dvec2 middle =
        glm::dvec2(-1.7, 1.15) + 0.8 * along + (kThick / 2 + kBeside) * across;
    const json scene = extremes::sceneOf("post", {"antialias"},
                                         {{"size", {kSide, kSide}},
                                          {"background", {0.1, 0.2, 2}},
                                          {"ground", {{"size", 0}}},
                                          {"light", kFlat},
                                          {"wires", {{"thickness", kThick}}},
                                          {"camera",
                                           {{"position", {middle.x, middle.y, front + kAway}},
                                            {"target", {middle.x, middle.y, front}},
                                            {"near", kAway - 0.1},
                                            {"far", kAway + 0.05},
                                            {"fov", kFov}}}});
    const Image truth = truthOf("antialias", scene, 0);
    const double pixel = 2 * kAway * std::tan(kFov / 2) / kSide; // world units
    double worst = 0;
    int partly = 0;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const glm::dvec2 from(x + 0.5 - kSide / 2.0, kSide / 2.0 - y - 0.5); // pixels, y is up
        const double share =
            areaBelow(across, -(from.x * across.x + from.y * across.y + kBeside / pixel));
        partly += share > 0.01 && share < 0.99;
        const double light = share * toned(0.08) + (1 - share) * toned(2);
        worst = std::max(worst, std::abs(double(truth.at(x, y, 2)) - encoded(light)));
      }
    EXPECT_GT(partly, 8) << wire;
    EXPECT_LT(worst, 0.025) << wire;
    RecordProperty("wire " + std::to_string(wire), std::to_string(worst));
  }
}

TEST(PostTruthItself, WhatMovesEvenlyFadesEvenly) {
  // The slow ball, five times as fast, along the window's middle row: while the shutter is open
  // both its ends go as far.
  constexpr int kWidth = 160, kHeight = 3;
  constexpr double kSpeed = 5, kOpen = 0.8 * 0.04, kDistance = 5;
  const double aspect = double(kWidth) / kHeight, half = 0.8; // what is seen at the ball, units
  const double tangent = half / kDistance;                    // along rows
  const json scene = extremes::sceneOf("post", {"motion_blur"},
                                       {{"size", {kWidth, kHeight}},
                                        {"background", {0, 0, 0}},
                                        {"ground", {{"size", 0}}},
                                        {"light", kFlat},
                                        {"motion", {{"speed", kSpeed}, {"turn", 0}}},
                                        {"camera",
                                         {{"position", {0, 0.5, kDistance - 0.2}},
                                          {"target", {0, 0.5, -0.2}},
                                          {"near", kDistance - 0.7},
                                          {"far", kDistance + 0.6},
                                          {"fov", 2 * std::atan(tangent / aspect)}}}});
  const Image truth = truthOf("motion_blur", scene, 2.5 / kSpeed, {{"seconds", 0.04}});
  const double length = 0.9 * 2 * kPi / 5 * kSpeed * kOpen; // of its way, units; to the left
  // Seen from near by, a ball hides more than its radius.
  const double radius = 0.5 / std::sqrt(1 - 0.25 / (kDistance * kDistance));
  for (int x = 0; x < kWidth; ++x) {
    const double at = half * (2 * (x + 0.5) / kWidth - 1);
    const double covered = std::clamp((radius - std::abs(at)) / length + 0.5, 0.0, 1.0);
    EXPECT_NEAR(truth.at(x, 1, 0), encoded(toned(0.8 * covered)), 0.02) << x;
  }
}

TEST(PostTruthItself, TheLampsGlowGoesOutByE) {
  const json nothing = {0, 0, 0};
  const json scene = extremes::sceneOf(
      "post", {"afterglow"},
      {{"size", {120, 90}},
       {"background", nothing},
       {"light", {{"ambient", nothing}, {"diffuse", nothing}, {"specular", nothing}}},
       {"camera", {{"position", {1.5, 1.75, 4}}, {"target", {1.5, 1.75, 0}}}}});
  // At a quarter of its period the lamp is before the camera.
  for (const double ago : {0.3, 0.5, 0.9}) {
    const Image truth = truthOf("afterglow", scene, 0.55 + ago, {{"before", {ago}}});
    for (int c = 0; c < 3; ++c) {
      const double light = 8 * (c == 0 ? 1 : c == 1 ? 0.85 : 0.5) * std::exp(-ago / 0.25);
      EXPECT_NEAR(truth.at(60, 45, c), encoded(toned(light)), 1e-4) << ago;
    }
    EXPECT_EQ(truth.at(5, 85, 0), 0);
  }
}

/// A part's solution, drawn and judged.
truth::Judgement ask(const std::string& part, const json& patch, double time,
                     const std::vector<double>& before = {}, const json& told = {}) {
  json all = {{"size", {160, 120}}};
  all.merge_patch(patch);
  const json scene = extremes::sceneOf("post", {part}, all);
  std::vector<double> times;
  for (const double ago : before) times.push_back(time - ago);
  times.push_back(time);
  const extremes::Drawn drawn = extremes::draw("post", scene, times);
  // The trace is of all frames, judges look at its first.
  truth::Judgement answer = truth::judgeOf(part)({.scene = scene,
                                                  .time = time,
                                                  .window = drawn.frames.back(),
                                                  .trace = before.empty() ? &drawn.trace : nullptr,
                                                  .truth = told});
  std::cout << patch.dump();
  for (const truth::Error& error : answer.errors) {
    std::cout << "; " << error.name << " " << error.value;
    testing::Test::RecordProperty(error.name, std::to_string(error.value));
  }
  std::cout << "\n";
  return answer;
}

double value(const truth::Judgement& judgement, const std::string& name) {
  for (const truth::Error& error : judgement.errors)
    if (error.name == name) return error.value;
  ADD_FAILURE() << "no error is named " << name;
  return 0;
}

/// The wires alone, at every angle, as wide as some pixels.
const json kFan = {
    {"ground", {{"size", 0}}},
    {"wires", {{"thickness", 0.08}}},
    {"camera",
     {{"position", {-1.7, 1.15, 1.2}}, {"target", {-1.7, 1.15, -1.2}}, {"far", 3}, {"fov", 0.9}}}};

class PostAntialiasTruth : public testing::Test {
protected:
  truth::Judgement with(const json& quality, bool on = true) const {
    json patch = look;
    patch["size"] = {120, 90};
    patch["effects"]["antialias"] = on;
    patch["quality"] = quality;
    return ask("antialias", patch, 0.733);
  }
  json look = json::object();
  const char *atEdges = "mean error at edges", *damage = "damage away from edges";
};

TEST_F(PostAntialiasTruth, EveryMethodIsBetterThanNone) {
  const truth::Judgement none = with(json::object(), false);
  EXPECT_EQ(value(none, damage), 0);
  for (const int method : {0, 1, 2, 3, 4}) {
    const truth::Judgement one = with({{"antialias", method}});
    EXPECT_LT(value(one, atEdges), 0.9 * value(none, atEdges)) << method;
    EXPECT_LT(value(one, "under a pixel"), 0.9 * value(none, "under a pixel")) << method;
    EXPECT_LT(value(one, damage), 0.01) << method;
  }
}

TEST_F(PostAntialiasTruth, WhatIsSmallerThanAPixelNeedsSeveralSamples) {
  look["wires"]["thickness"] = 0.02; // two fifths of a pixel
  std::vector<double> thin, glitter;
  for (const int method : {0, 1, 2, 3, 4}) {
    const truth::Judgement one = with({{"antialias", method}});
    thin.push_back(value(one, "under a pixel"));
    glitter.push_back(value(one, "in highlights"));
  }
  for (const int afterwards : {0, 1, 2})
    for (const int several : {3, 4}) EXPECT_LT(thin[several], thin[afterwards]) << afterwards;
  EXPECT_LT(glitter[4], 0.8 * glitter[3]) << "shading is once a pixel";
}

TEST_F(PostAntialiasTruth, AnEdgeThatIsNearlyLevelNeedsALongSearch) {
  look = kFan;
  const truth::Judgement none = with(json::object(), false), fxaa = with({{"antialias", 0}}),
                         near = with({{"antialias", 0}, {"search_steps", 1}}),
                         mlaa = with({{"antialias", 2}}),
                         low = with({{"antialias", 1}, {"smaa_preset", 0}}),
                         ultra = with({{"antialias", 1}, {"smaa_preset", 3}});
  for (const truth::Judgement& one : {fxaa, mlaa, low, ultra})
    EXPECT_LT(value(one, atEdges), 0.8 * value(none, atEdges));
  EXPECT_LT(value(fxaa, atEdges), value(near, atEdges));
  const char* const blended = "at edges, blended as displayed";
  EXPECT_LE(value(ultra, blended), value(low, blended));
  EXPECT_LT(value(ultra, blended), 0.5 * value(none, blended));
}

/// The interval between the frames, seconds.
constexpr double kFrame = 0.05;

TEST(PostMotionBlurTruth, MoreSamplesAndMoreVelocitiesComeNearer) {
  const auto with = [](const json& quality, bool blur = true) {
    return ask("motion_blur",
               {{"size", {120, 90}},
                {"effects", {{"motion_blur", blur}}},
                {"motion", {{"turn", 0}, {"speed", 2}}},
                {"quality", quality}},
               0.733, {kFrame}, {{"seconds", kFrame}});
  };
  const auto settings = [](int velocity, int samples) {
    return json{{"velocity", velocity}, {"samples", samples}};
  };
  const truth::Judgement none = with(settings(1, 64), false), camera = with(settings(0, 64)),
                         objects = with(settings(1, 64)), neighbours = with(settings(2, 64)),
                         few = with(settings(1, 4));
  const char* const moving = "mean error where something moves";
  EXPECT_LT(value(objects, moving), value(none, moving));
  EXPECT_LT(value(objects, moving), value(camera, moving));
  EXPECT_LT(value(objects, moving), value(few, moving));
  EXPECT_LT(value(objects, "inside outlines"), value(camera, "inside outlines"));
  EXPECT_LT(value(neighbours, "beyond outlines"), value(objects, "beyond outlines"));
}

TEST(PostAfterglowTruth, EightBitsAreWorseThanHalfFloats) {
  std::vector<double> before;
  for (int i = 20; i > 0; --i) before.push_back(i / 30.0);
  const auto with = [&](json patch) {
    patch["size"] = {120, 90};
    patch["ground"]["size"] = 0; // its texture's filter is not what is looked at
    return ask("afterglow", patch, 1.4, before, {{"before", before}});
  };
  const truth::Judgement floats = with({{"quality", {{"glow_bits", 16}}}});
  const truth::Judgement bytes = with({{"quality", {{"glow_bits", 8}}}});
  const truth::Judgement none = with({{"effects", {{"afterglow", false}}}});
  const char* const glows = "mean error where it glows";
  EXPECT_LT(value(floats, glows), 0.01);
  EXPECT_LT(8 * value(floats, glows), value(bytes, glows));
  EXPECT_LT(value(bytes, glows), value(none, glows));
}

} // namespace
