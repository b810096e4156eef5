// What the floor's judges say about pictures that are changed by a known amount.

#include "truth/truth.hpp"

#include "assignment/assignment.hpp"

#include <gmock/gmock.h>

#include <cmath>

using namespace ggrade;
using nlohmann::json;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace {

constexpr int kWidth = 160, kHeight = 120;

truth::Rendered black(const std::string& part, const json& change = json::object()) {
  json scene = readJson(GGRADE_SOURCE_DIR "/assignments/floor/scene.json");
  if (!part.empty()) scene["effects"][part] = true;
  scene.merge_patch(change);
  return {scene, 0.4, Image(kWidth, kHeight, 4), nullptr};
}

/// The window as the truth has it.
truth::Rendered perfect(const std::string& part, const json& change = json::object()) {
  truth::Rendered rendered = black(part, change);
  rendered.window = truth::judgeOf(part)(rendered).truth;
  return rendered;
}

double error(const truth::Judgement& answer, const std::string& name) {
  for (const truth::Error& one : answer.errors)
    if (one.name == name) return one.value;
  ADD_FAILURE() << "no error is named " << name;
  return std::nan("");
}

TEST(TruthJudges, NamesThePartsThereAre) {
  EXPECT_THAT([] { truth::judgeOf("fog"); },
              ThrowsMessage<std::invalid_argument>(testing::ContainsRegex(
                  "part fog has no truth; there are: .*bloom, .*mirror, .*shadow")));
}

TEST(TruthJudges, TheTruthHasNoError) {
  for (const char* part : {"mirror", "shadow"})
    for (const truth::Error& one : truth::judgeOf(part)(perfect(part)).errors)
      EXPECT_LT(one.value, 1e-7) << part << " " << one.name;
}

TEST(TruthJudges, TheFirstErrorIsWhatSettingsAreComparedBy) {
  EXPECT_EQ(truth::judgeOf("mirror")(black("mirror")).errors.at(0).name, "reflection RMSE");
  EXPECT_EQ(truth::judgeOf("shadow")(black("shadow")).errors.at(0).name, "wrong pixels");
}

TEST(TruthJudges, MirrorMeasuresTheWindowsValues) {
  truth::Rendered rendered = perfect("mirror");
  for (float& value : rendered.window.values()) value += 0.25f;
  const truth::Judgement answer = truth::judgeOf("mirror")(rendered);
  EXPECT_NEAR(error(answer, "reflection RMSE"), 0.25, 1e-6);
  EXPECT_NEAR(error(answer, "edge RMSE"), 0.25, 1e-6);
  EXPECT_NEAR(double(answer.difference.at(80, 110, 1)), 1, 1e-6) << "four times as strong";
}

TEST(TruthJudges, MirrorLeavesOutEdgesAndWhatIsNoFloor) {
  // Moved by half the window: off its edges the floor's own pattern differs as well, but the
  // background above the floor counts nowhere.
  truth::Rendered rendered = perfect("mirror");
  for (int x = 0; x < kWidth; ++x) rendered.window.at(x, 0, 0) = 1;
  EXPECT_LT(error(truth::judgeOf("mirror")(rendered), "edge RMSE"), 1e-7);
  // One pixel to the side: most of that is at edges.
  const Image& right = rendered.window;
  Image moved = right;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 1; x < kWidth; ++x)
      for (int c = 0; c < 3; ++c) moved.at(x, y, c) = right.at(x - 1, y, c);
  rendered.window = moved;
  const truth::Judgement answer = truth::judgeOf("mirror")(rendered);
  EXPECT_GT(error(answer, "edge RMSE"), 0.01);
  EXPECT_GT(error(answer, "edge RMSE"), error(answer, "reflection RMSE"));
}

TEST(TruthJudges, ABlurredReflectionIsAnotherTruth) {
  const truth::Judgement sharp = truth::judgeOf("mirror")(black("mirror"));
  const truth::Judgement blurred =
      truth::judgeOf("mirror")(black("mirror", {{"mirror", {{"blur", 0.05}}}}));
  double apart = 0;
  for (std::size_t i = 0; i < sharp.truth.values().size(); ++i)
    apart = std::max(apart, std::abs(double(sharp.truth.values()[i] - blurred.truth.values()[i])));
  EXPECT_GT(apart, 0.1);
}

TEST(TruthJudges, ShadowCountsWrongPixelsBySide) {
  // All light: what is in shadow is false light, and nothing else.
  truth::Rendered rendered = perfect("shadow");
  rendered.window = perfect("mirror", {{"effects", {{"mirror", false}}}}).window;
  const truth::Judgement lit = truth::judgeOf("shadow")(rendered);
  EXPECT_EQ(error(lit, "false light"), 1);
  EXPECT_EQ(error(lit, "false shadow"), 0);
  EXPECT_EQ(error(lit, "false shadow or light"), 1);
  EXPECT_GT(error(lit, "wrong pixels"), 0.02);
  EXPECT_LT(error(lit, "wrong pixels"), 0.5);
  // All dark.
  const truth::Judgement dark = truth::judgeOf("shadow")(black("shadow"));
  EXPECT_EQ(error(dark, "false light"), 0);
  EXPECT_EQ(error(dark, "false shadow"), 1);
  EXPECT_NEAR(error(dark, "wrong pixels") + error(lit, "wrong pixels"), 1, 1e-12);
}

TEST(TruthJudges, ShadowForgivesEdgesByTheMapsTexel) {
  // Shadows moved by one pixel: all wrong pixels lie at edges. In a coarse map they are within the
  // band, in a fine one beyond it.
  truth::Rendered rendered = perfect("shadow");
  Image moved = rendered.window;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 2; x < kWidth; ++x)
      for (int c = 0; c < 3; ++c) moved.at(x, y, c) = rendered.window.at(x - 2, y, c);
  rendered.window = moved;
  const auto outsideBand = [&](int size) {
    rendered.scene["quality"]["shadow_size"] = size;
    return error(truth::judgeOf("shadow")(rendered), "false light");
  };
  const double coarse = outsideBand(64), fine = outsideBand(8192);
  EXPECT_LT(coarse, 0.5 * fine);
  EXPECT_GT(fine, 0.02);
}

TEST(TruthJudges, ASoftShadowIsAnotherTruth) {
  truth::Rendered rendered = perfect("shadow"); // of a point
  rendered.truth = {{"light_radius", 0.2}};
  const truth::Judgement soft = truth::judgeOf("shadow")(rendered);
  EXPECT_GT(error(soft, "penumbra RMSE"), 0.05);
  EXPECT_LT(error(soft, "soft RMSE"), error(soft, "penumbra RMSE") / 2);
  rendered.window = soft.truth;
  EXPECT_NEAR(error(truth::judgeOf("shadow")(rendered), "penumbra RMSE"), 0, 1e-5);
  // A tiny light throws the shadow of a point.
  rendered = perfect("shadow");
  rendered.truth = {{"light_radius", 1e-4}};
  EXPECT_LT(error(truth::judgeOf("shadow")(rendered), "soft RMSE"), 0.005);
}

TEST(TruthJudges, SayWhatTheyCannotJudge) {
  const json bloom = {{"effects", {{"bloom", true}}}};
  for (const char* part : {"mirror", "shadow"})
    EXPECT_THAT([&] { truth::judgeOf(part)(black(part, bloom)); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("set effects.bloom to false")));
  EXPECT_THAT([&] { truth::judgeOf("bloom")(black("bloom")); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("needs the passes")));
  const trace::Trace nothing;
  truth::Rendered rendered = black("bloom");
  rendered.trace = &nothing;
  EXPECT_THAT([&] { truth::judgeOf("bloom")(rendered); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("finds no pass")));
}

} // namespace
