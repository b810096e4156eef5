// Afterglow at its ends: many and few frames a second, time that stands still or runs backwards, no
// past, a past of another size, few bits, a lamp as bright as can be.

#include "drawn.hpp"
#include "extremes_resized.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

using namespace extremes;

namespace {

/// A small window in the dark: nothing but the lamp has any light.
json scene(const json& patch = json::object()) {
  json all = {{"size", {120, 90}},
              {"background", {0, 0, 0}},
              {"light", {{"ambient", {0, 0, 0}}, {"diffuse", {0, 0, 0}}, {"specular", {0, 0, 0}}}}};
  all.merge_patch(patch);
  return sceneOf("post", {"afterglow"}, all);
}
json plain(json patch = json::object()) {
  patch["effects"]["afterglow"] = false;
  return scene(patch);
}

/// As tone.frag shows it.
double shown(double light) {
  const double toned = 1 - std::exp(-light);
  return toned <= 0.0031308 ? 12.92 * toned : 1.055 * std::pow(toned, 1 / 2.4) - 0.055;
}

/// Pixels that the lamp covers at the first of these times and at no later one.
std::vector<std::pair<int, int>> leftByTheLamp(const json& scene,
                                               const std::vector<double>& times) {
  const std::vector<Image> frames = draw("post", scene, times).frames;
  std::vector<std::pair<int, int>> found;
  for (int y = 0; y < frames[0].height(); ++y)
    for (int x = 0; x < frames[0].width(); ++x) {
      bool later = false;
      for (std::size_t i = 1; i < frames.size(); ++i) later |= frames[i].at(x, y, 0) > 0;
      if (frames[0].at(x, y, 0) > 0 && !later) found.emplace_back(x, y);
    }
  return found;
}

TEST(PostAfterglow, ThirtyAndSixtyFramesASecondGlowAlike) {
  // So fast that what the lamp left doesn't lie under what it leaves later.
  const json fast = {{"motion", {{"speed", 6}}}, {"afterglow", {{"seconds", 0.07}}}};
  std::vector<double> thirty, sixty;
  for (int i = 0; i <= 8; ++i) {
    if (i % 2 == 0) thirty.push_back(0.1 + i / 60.0);
    sixty.push_back(0.1 + i / 60.0);
  }
  const auto left = leftByTheLamp(plain(fast), sixty);
  ASSERT_GT(left.size(), 5u);
  const Image a = draw("post", scene(fast), thirty).frames.back();
  const Image b = draw("post", scene(fast), sixty).frames.back();
  const double decay = std::exp(-(8 / 60.0) / 0.07);
  for (const auto& [x, y] : left) {
    EXPECT_NEAR(a.at(x, y, 0), b.at(x, y, 0), 1.01 / 255) << x << "," << y;
    EXPECT_NEAR(a.at(x, y, 0), shown(8 * decay), 1.01 / 255) << x << "," << y;
    EXPECT_NEAR(a.at(x, y, 2), shown(8 * 0.5 * decay), 1.01 / 255) << x << "," << y;
  }
}

TEST(PostAfterglow, TimeThatStandsStillOrRunsBackwardsTakesNothingAway) {
  const std::vector<Image> frames = draw("post", scene(), {0.5, 0.6, 0.6, 0.4, 100}).frames;
  const std::vector<Image> dark = draw("post", plain(), {0.5, 100}).frames;
  EXPECT_EQ(differing(frames[0], dark[0], 0), 0) << "the first frame has no past";
  EXPECT_EQ(differing(frames[1], frames[2], 0), 0) << "time stood still";
  int less = 0;
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 120; ++x)
      for (int c = 0; c < 3; ++c) less += frames[3].at(x, y, c) < frames[2].at(x, y, c);
  EXPECT_EQ(less, 0) << "time ran backwards";
  EXPECT_EQ(differing(frames[4], dark[1], 0), 0) << "a long time leaves nothing";
}

TEST(PostAfterglow, AnotherSizeLeavesNothing) {
  const std::vector<Image> frames = resized("post", scene(), {{0.5, 120, 90}, {0.55, 100, 80}});
  ASSERT_EQ(frames.size(), 2u);
  const json small = {{"size", {100, 80}}};
  EXPECT_EQ(differing(frames[1], draw("post", plain(small), {0.55}).frames[0], 0), 0);
}

TEST(PostAfterglow, AnySize) {
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{1, 300}, std::pair{300, 1}})
    draw("post", scene({{"size", {width, height}}}), {0.5, 0.55, 0.6});
}

TEST(PostAfterglow, ALampAsBrightAsCanBe) {
  // 1e4 / e^12 is 0.06, yet of light that was cut at 1 nothing would be left.
  json patch = {{"lamp", {{"brightness", 1e4}}}, {"afterglow", {{"seconds", 0.05}}}};
  const auto left = leftByTheLamp(plain(patch), {0.1, 0.7});
  ASSERT_GT(left.size(), 5u);
  const Image frame = draw("post", scene(patch), {0.1, 0.7}).frames[1];
  for (const auto& [x, y] : left)
    EXPECT_NEAR(frame.at(x, y, 0), shown(1e4 * std::exp(-12)), 2.01 / 255) << x << "," << y;
  patch["quality"]["glow_bits"] = 8;
  draw("post", scene(patch), {0.1, 0.15, 0.2});
}

/// What the glow's texture holds of a lamp that was seen once, after some frames: the most of red,
/// light.
///   first: what the first of these frames leaves, 0 to 1;  share: what each later one does
double remains(int bits, double first, double share, int frames) {
  const double seconds = 0.3;
  const json patch = {{"afterglow", {{"seconds", seconds}}}, {"quality", {{"glow_bits", bits}}}};
  std::vector<double> times = {0.55, 0.55 - seconds * std::log(first)};
  for (int i = 0; i < frames; ++i) times.push_back(times.back() - seconds * std::log(share));
  const auto left = leftByTheLamp(plain(patch), times);
  EXPECT_GT(left.size(), 5u) << "the lamp doesn't go, or comes back";
  const Drawn drawn = draw("post", scene(patch), times);
  const auto passes = drawn.trace.passesOf(times.size() - 1);
  const Image glow = drawn.leftBy(drawn.trace.indexOf(passes[1]));
  float most = 0;
  for (const auto& [x, y] : left) most = std::max(most, glow.at(x, y, 0));
  return double(most);
}

TEST(PostAfterglow, EightBitsLeaveGhosts) {
  // A step of less than half of 1/255 is none.
  EXPECT_NEAR(255 * remains(8, 20.0 / 255, 0.95, 40), 9, 1.01);
  EXPECT_NEAR(255 * remains(8, 60.0 / 255, 0.99, 40), 49, 1.01);
}

TEST(PostAfterglow, HalfFloatsLeaveNone) {
  EXPECT_NEAR(remains(16, 20.0 / 255, 0.95, 40) / (8 * 20.0 / 255 * std::pow(0.95, 40)), 1, 0.05);
}

TEST(PostAfterglow, WhatIsLeftOutWouldChangeNothing) {
  for (const double seconds : {0.0, 0.25}) {
    json patch = {{"afterglow", {{"seconds", seconds}}}};
    const Drawn less = draw("post", scene(patch), {0.5, 0.55});
    EXPECT_EQ(less.trace.passesOf(1).size(), seconds > 0 ? 3u : 2u);
    patch["debug"]["draw_all_passes"] = true;
    const Drawn all = draw("post", scene(patch), {0.5, 0.55});
    EXPECT_EQ(all.trace.passesOf(1).size(), 3u);
    for (const std::size_t frame : {0, 1})
      EXPECT_EQ(differing(less.frames[frame], all.frames[frame], 0), 0) << seconds;
  }
  EXPECT_EQ(draw("post", plain(), {0.5, 0.55}).trace.passesOf(1).size(), 2u);
}

} // namespace
