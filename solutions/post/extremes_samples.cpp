// Several samples a pixel at their ends: equal samples, samples of any brightness, windows that are
// one pixel high, what later passes get of them. Multisampled, and two by two pixels for one.

#include "drawn.hpp"
#include "extremes_resized.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

using namespace extremes;

namespace {

class PostSamples : public testing::TestWithParam<int> {
protected:
  json scene(const json& patch = json::object(), bool several = true) const {
    json all = {{"size", {120, 90}},
                {"effects", {{"antialias", several}, {"motion_blur", false}, {"afterglow", false}}},
                {"quality", {{"antialias", GetParam()}}}};
    all.merge_patch(patch);
    return sceneOf("post", {}, all);
  }
};

INSTANTIATE_TEST_SUITE_P(Methods, PostSamples, testing::Values(3, 4), [](const auto& info) {
  return std::string(info.param == 3 ? "Multisampled" : "Supersampled");
});

/// High above it all, eyes up: nothing but the background.
const json kSky = {{"camera", {{"position", {0, 50, 0}}, {"target", {0, 60, 1}}}}};

float darkest(const Image& image) {
  float least = 1;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; c < 3; ++c) least = std::min(least, image.at(x, y, c));
  return least;
}

TEST_P(PostSamples, TheMeanOfEqualSamplesIsEachOfThemBitForBit) {
  for (const double light : {0.0, 1e-6, 0.4, 7.0, 3e4}) {
    json patch = kSky;
    patch["background"] = {light, light / 2, light / 3};
    const Drawn drawn = draw("post", scene(patch)), one = draw("post", scene(patch, false));
    EXPECT_EQ(differing(drawn.frames[0], one.frames[0], 0), 0) << light;
  }
}

TEST_P(PostSamples, AnyBrightnessIsAMeanOfWhatIsShown) {
  // Nothing of the scene is black; what isn't a number is.
  for (const double lamp : {1.0, 88.0, 1e4}) {
    const json patch = {{"lamp", {{"brightness", lamp}}}, {"background", {0.2, 0.2, 0.2}}};
    const Drawn drawn = draw("post", scene(patch));
    const Image& window = drawn.frames[0];
    const Image one = draw("post", scene(patch, false)).frames[0];
    EXPECT_GT(darkest(window), darkest(one) - 0.1f) << lamp;
    EXPECT_GT(differing(window, one), 0.02) << lamp;
  }
}

TEST_P(PostSamples, AnySize) {
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{1, 300}, std::pair{300, 1}}) {
    const Drawn drawn = draw("post", scene({{"size", {width, height}}}));
    EXPECT_EQ(drawn.frames[0].width(), width);
    EXPECT_EQ(drawn.frames[0].height(), height);
  }
}

TEST_P(PostSamples, VelocitiesAndDepthsGoOnToMotionBlur) {
  for (const int velocity : {0, 1, 2}) {
    const auto blurred = [&](bool several, bool blur) {
      return draw("post",
                  scene({{"effects", {{"motion_blur", blur}}},
                         {"quality", {{"velocity", velocity}}},
                         {"motion", {{"turn", 0.6}}}},
                        several),
                  {0.7, 0.733})
          .frames[1];
    };
    const auto apart = [](const Image& a, const Image& b) {
      double sum = 0;
      for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) sum += std::abs(double(a.at(x, y, 1) - b.at(x, y, 1)));
      return sum;
    };
    const double blur = apart(blurred(true, true), blurred(true, false)),
                 without = apart(blurred(false, true), blurred(false, false));
    EXPECT_GT(without, 1) << velocity;
    EXPECT_NEAR(blur / without, 1, 0.5) << velocity;
  }
}

TEST_P(PostSamples, AWindowOfAnotherSize) {
  const std::vector<Image> frames =
      resized("post", scene(), {{0.5, 120, 90}, {0.5, 100, 80}, {0.5, 120, 90}});
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_EQ(frames[1].width(), 100);
  EXPECT_EQ(differing(frames[0], frames[2], 0), 0);
}

TEST_P(PostSamples, OneMoreIsDrawnThanWithoutThem) {
  const auto passes = [&](bool several) {
    return draw("post", scene(json::object(), several), {0.5, 0.6}).trace.passesOf(1).size();
  };
  EXPECT_EQ(passes(false), 2u) << "scene, tone";
  EXPECT_EQ(passes(true), 3u) << "scene, mean, tone";
}

} // namespace
