// Motion blur at its ends: nothing that moves, half a pixel, jumps across the picture, what was
// behind the eye, time that stands still or runs backwards. However velocities are found.

#include "drawn.hpp"
#include "extremes_resized.hpp"

#include <glm/vec3.hpp>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

using namespace extremes;

namespace {

/// A small window in which all moves.
class PostMotionBlur : public testing::TestWithParam<int> {
protected:
  json scene(const json& patch = json::object()) const {
    json all = {{"size", {120, 90}}, {"quality", {{"velocity", GetParam()}}}};
    all.merge_patch(patch);
    return sceneOf("post", {"motion_blur"}, all);
  }
  /// Without any blur.
  std::vector<Image> sharpFrames(const std::vector<double>& times) const {
    return draw("post", scene({{"effects", {{"motion_blur", false}}}}), times).frames;
  }
  /// What the passes left of velocities in a frame: texture coordinates a frame.
  Image velocities(const Drawn& drawn, std::size_t frame) const {
    const std::uint32_t first = drawn.trace.indexOf(drawn.trace.passesOf(frame)[0]);
    const bool ofCamera = GetParam() == 0;
    const auto* const copy = drawn.trace.copyOf(first + (ofCamera ? 1 : 0), ofCamera ? 0 : 1);
    if (copy == nullptr) throw std::runtime_error("there are no velocities");
    return drawn.trace.image(*copy);
  }
};

INSTANTIATE_TEST_SUITE_P(
    Velocities, PostMotionBlur, testing::Values(0, 1, 2), [](const auto& info) {
      return std::string(info.param == 0 ? "Camera" : info.param == 1 ? "Objects" : "Neighbours");
    });

/// Length of a velocity, pixels.
float pixels(const Image& velocity, int x, int y) {
  return std::hypot(velocity.at(x, y, 0) * float(velocity.width()),
                    velocity.at(x, y, 1) * float(velocity.height()));
}

float fastest(const Image& velocity) {
  float most = 0;
  for (int y = 0; y < velocity.height(); ++y)
    for (int x = 0; x < velocity.width(); ++x) most = std::max(most, pixels(velocity, x, y));
  return most;
}

/// Pixels whose colour isn't found, channel by channel, within `reach` pixels of the sharp picture.
int strangers(const Image& blurred, const Image& sharp, int reach) {
  int found = 0;
  for (int y = 0; y < sharp.height(); ++y)
    for (int x = 0; x < sharp.width(); ++x)
      for (int c = 0; c < 3; ++c) {
        float least = 1, most = 0;
        for (int j = std::max(y - reach, 0); j <= std::min(y + reach, sharp.height() - 1); ++j)
          for (int i = std::max(x - reach, 0); i <= std::min(x + reach, sharp.width() - 1); ++i)
            least = std::min(least, sharp.at(i, j, c)), most = std::max(most, sharp.at(i, j, c));
        const float value = blurred.at(x, y, c), rounding = 1.01f / 255;
        if (value < least - rounding || value > most + rounding) {
          ++found;
          break;
        }
      }
  return found;
}

TEST_P(PostMotionBlur, WhatNeedsNoBlurStaysBitForBit) {
  const Drawn drawn = draw("post", scene(), {0.7, 0.702, 0.702, 0.6});
  const std::vector<Image> sharp = sharpFrames({0.7, 0.702, 0.6});
  EXPECT_EQ(differing(drawn.frames[0], sharp[0], 0), 0) << "the first frame has no past";
  ASSERT_GT(fastest(velocities(drawn, 1)), 0.01f);
  ASSERT_LT(fastest(velocities(drawn, 1)), 0.5f);
  EXPECT_EQ(differing(drawn.frames[1], sharp[1], 0), 0) << "less than half a pixel";
  EXPECT_EQ(differing(drawn.frames[2], sharp[1], 0), 0) << "time stood still";
  EXPECT_GT(differing(drawn.frames[3], sharp[2]), 0.02) << "a clock that was put back blurs, too";
}

TEST_P(PostMotionBlur, HalfAPixelIsWhereItBegins) {
  if (GetParam() == 2) return; // there, it is the neighbours that count
  const Drawn drawn = draw("post", scene({{"motion", {{"shutter", 1}}}}), {0.7, 0.72});
  const Image sharp = sharpFrames({0.72})[0], velocity = velocities(drawn, 1);
  int less = 0, lessChanged = 0, more = 0, moreChanged = 0;
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 120; ++x) {
      const bool changed = distance(drawn.frames[1].pixel(x, y), sharp.pixel(x, y)) > 0;
      if (pixels(velocity, x, y) < 0.499f) ++less, lessChanged += changed;
      if (pixels(velocity, x, y) > 0.501f) ++more, moreChanged += changed;
    }
  EXPECT_GT(less, 100);
  EXPECT_GT(more, 100);
  EXPECT_EQ(lessChanged, 0);
  EXPECT_GT(moreChanged, 20);
}

TEST_P(PostMotionBlur, NoBlurIsLongerThanTheLongest) {
  // In 0.7 s the box crosses the whole picture.
  for (const int longest : {1, 1024}) {
    const Drawn drawn =
        draw("post", scene({{"motion", {{"shutter", 1}}}, {"quality", {{"longest", longest}}}}),
             {0.25, 0.95});
    EXPECT_GT(fastest(velocities(drawn, 1)), 20);
    if (longest <= 10) {
      EXPECT_EQ(strangers(drawn.frames[1], sharpFrames({0.95})[0], longest / 2 + 2), 0) << longest;
    }
  }
}

TEST_P(PostMotionBlur, TheMostSamplesOfTheBrightestLight) {
  const json white = {65504, 65504, 65504};
  const json all = {{"ambient", white}, {"diffuse", white}, {"specular", white}};
  draw("post",
       scene({{"size", {24, 18}},
              {"quality", {{"samples", 1024}}},
              {"background", white},
              {"light", all},
              {"materials", {{"matt", all}, {"glitter", all}}}}),
       {0.7, 0.74});
}

TEST_P(PostMotionBlur, OfAnySpeed) {
  draw("post", scene({{"motion", {{"speed", -1e3}, {"turn", 1e3}, {"shutter", 1}}}}),
       {0.1, 0.15, 3, 1e3, 1});
}

TEST_P(PostMotionBlur, WhatWasBehindTheEye) {
  // From within, along the box's way: it comes from behind.
  const json look = {
      {"camera",
       {{"position", {0, 0.4, 0.6}}, {"target", {0.02, 0.4, 0.6}}, {"near", 0.001}, {"fov", 2.5}}},
      {"motion", {{"turn", 20}, {"shutter", 1}}}};
  draw("post", scene(look), {0.25, 0.95, 1.0, 1.05, 1.1, 1.37, 1.4, 1.43});
}

TEST_P(PostMotionBlur, WhatWasBesideTheEye) {
  // A face of the box, seen straight on, lay in the eye's own plane a frame before, but for a
  // hundred thousandth: its last w is hardly more than 0.
  const double turned = 0.5, way = 1.2; // of the box: radians, units to either side
  const glm::dvec3 normal(std::sin(turned), 0, std::cos(turned));
  const glm::dvec3 eye = glm::dvec3(-way, 0.42, 0.6) + (0.25 + 2 * way * normal.x + 1e-5) * normal;
  const double moment = 1.4 * std::asin(way / 1.6) / (2 * std::acos(-1.0)); // seconds
  const json look = {{"camera",
                      {{"position", {eye.x, eye.y, eye.z}},
                       {"target", {eye.x - normal.x, eye.y, eye.z - normal.z}},
                       {"near", 0.01}}},
                     {"motion", {{"turn", 0}, {"shutter", 1}}},
                     {"debug", {{"draw_all_passes", true}}}};
  const Drawn drawn = draw("post", scene(look), {1.4 - moment, 1.4 + moment});
  if (GetParam() != 0) {
    EXPECT_GT(fastest(velocities(drawn, 1)), 1000) << "the face wasn't beside the eye";
  }
}

TEST_P(PostMotionBlur, AnySize) {
  for (const auto& [width, height] : {std::pair{1, 300}, std::pair{300, 1}}) {
    const Drawn drawn = draw("post", scene({{"size", {width, height}}}), {0.7, 0.74});
    EXPECT_EQ(drawn.frames[1].width(), width);
    EXPECT_EQ(drawn.frames[1].height(), height);
  }
}

TEST_P(PostMotionBlur, AnotherSizeBetweenTwoFrames) {
  const Image alone = draw("post", scene({{"size", {100, 80}}}), {0.7, 0.74}).frames.at(1);
  const std::vector<Image> frames =
      resized("post", scene(), {{0.6, 120, 90}, {0.66, 140, 60}, {0.7, 100, 80}, {0.74, 100, 80}});
  ASSERT_EQ(frames.size(), 4u);
  EXPECT_EQ(differing(frames[3], alone, 0), 0) << "something is left of the other size";
}

TEST_P(PostMotionBlur, WhatIsLeftOutWouldChangeNothing) {
  struct Case {
    json patch;
    bool blurs;
  };
  const bool objects = GetParam() != 0;
  for (Case one :
       {Case{{{"motion", {{"speed", 0}, {"turn", 0}}}}, false},
        Case{{{"motion", {{"shutter", 0}}}}, false}, Case{{{"motion", {{"turn", 0}}}}, objects}}) {
    const Drawn less = draw("post", scene(one.patch), {0.7, 0.74});
    const std::size_t passes = GetParam() == 0 ? 4 : GetParam() == 1 ? 3 : 5;
    EXPECT_EQ(less.trace.passesOf(1).size(), one.blurs ? passes : 2u) << one.patch;
    const auto velocity = ggrade::trace::ImageKind(less.trace.passesOf(1)[0].images[1].kind);
    EXPECT_EQ(velocity != ggrade::trace::ImageKind::none, one.blurs && objects) << one.patch;
    one.patch["debug"]["draw_all_passes"] = true;
    const Drawn all = draw("post", scene(one.patch), {0.7, 0.74});
    EXPECT_EQ(all.trace.passesOf(1).size(), passes) << one.patch;
    EXPECT_EQ(differing(less.frames[1], all.frames[1], 0), 0) << one.patch;
  }
}

} // namespace
