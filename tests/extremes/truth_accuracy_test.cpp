// The reference's pictures against the truth at the settings that it has by default.

#include "drawn.hpp"

#include "truth/truth.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <iostream>

using namespace ggrade;
using nlohmann::json;

namespace {

/// What a part's truth says about the reference in the part's scene with `change`.
class Truth : public testing::Test {
protected:
  truth::Judgement ask(const std::string& part, const json& change = json::object(),
                       double time = 0.4) {
    const json scene = extremes::sceneOf("floor", {part}, change);
    const extremes::Drawn drawn = extremes::draw("floor", scene, {time});
    const truth::Judgement answer =
        truth::judgeOf(part)({scene, time, drawn.frames.at(0), &drawn.trace});
    for (const truth::Error& error : answer.errors) {
      std::cout << part << " " << change.dump() << " at " << time << " s: " << error.name << " "
                << error.value << "\n";
      // Into the results as well: figures that can be looked up later.
      RecordProperty(error.name, std::to_string(error.value));
    }
    return answer;
  }
  static double error(const truth::Judgement& answer, const std::string& name) {
    for (const truth::Error& one : answer.errors)
      if (one.name == name) return one.value;
    ADD_FAILURE() << "no error is named " << name;
    return std::nan("");
  }
};

TEST_F(Truth, MirrorIsWithinOnePercent) {
  for (const double time : {0.0, 0.4, 1.3}) {
    const truth::Judgement answer = ask("mirror", json::object(), time);
    EXPECT_LE(error(answer, "reflection RMSE"), 0.01);
  }
}

TEST_F(Truth, ShadowsAreWithinHalfAPercent) {
  for (const double time : {0.0, 0.4, 1.3}) {
    const truth::Judgement answer = ask("shadow", json::object(), time);
    EXPECT_LT(error(answer, "false shadow"), 0.005);
    EXPECT_LT(error(answer, "false light"), 0.005);
  }
}

TEST_F(Truth, ShadowsOfGrazingLightAreWithinHalfAPercent) {
  for (const double time : {0.0, 0.4, 1.3}) {
    const truth::Judgement answer = ask("shadow", {{"light", {{"position", {6, 1.7, 2}}}}}, time);
    EXPECT_LT(error(answer, "false shadow"), 0.005);
    EXPECT_LT(error(answer, "false light"), 0.005);
  }
}

TEST_F(Truth, BloomIsWithinOnePercent) {
  for (const double time : {0.0, 0.4}) {
    const truth::Judgement answer = ask("bloom", json::object(), time);
    EXPECT_LE(error(answer, "bloom relative error"), 0.01);
    EXPECT_LE(error(answer, "energy"), 0.01);
  }
}

// The lower bound: the truth can tell what is known to be worse, by the same numbers.

TEST_F(Truth, TellsACoarseMirror) {
  EXPECT_GT(error(ask("mirror", {{"quality", {{"mirror_size", 64}}}}), "reflection RMSE"), 0.02);
}

TEST_F(Truth, TellsAMirrorThatDoesNotClip) {
  const json sunk = {{"ring", {{"base", -0.7}, {"hop", 0}}}};
  EXPECT_LE(error(ask("mirror", sunk), "reflection RMSE"), 0.01);
  json unclipped = sunk;
  unclipped["quality"]["mirror_clip"] = 0;
  EXPECT_GT(error(ask("mirror", unclipped), "reflection RMSE"), 0.02);
}

TEST_F(Truth, BlurComesNearerWithMoreSamples) {
  double last = 1;
  for (const int samples : {1, 4, 16, 64, 256}) {
    const json change = {{"mirror", {{"blur", 0.01}}}, {"quality", {{"blur_samples", samples}}}};
    const double now = error(ask("mirror", change), "reflection RMSE");
    EXPECT_LT(now, last) << samples;
    last = now;
  }
  EXPECT_LT(last, 0.003);
}

TEST_F(Truth, TellsShadowsWithoutABias) {
  const json none = {{"quality", {{"shadow_bias", 0}}}};
  EXPECT_GT(error(ask("shadow", none), "false shadow"), 0.02);
}

TEST_F(Truth, ShadowsComeNearerWithAFinerMap) {
  double last = 1;
  for (const int size : {128, 512, 2048}) {
    const double now = error(ask("shadow", {{"quality", {{"shadow_size", size}}}}), "wrong pixels");
    EXPECT_LT(now, last / 2) << size;
    last = now;
  }
}

TEST_F(Truth, FloatsHoldTheBloomOfEveryFilterExactly) {
  for (int filter = 0; filter < 4; ++filter)
    for (int edge = 0; edge < 2; ++edge) {
      const json change = {
          {"size", {165, 91}},
          {"quality", {{"bloom_filter", filter}, {"bloom_edge", edge}, {"bloom_format", 3}}}};
      const truth::Judgement answer = ask("bloom", change);
      EXPECT_LE(error(answer, "bloom relative error"), 1e-4);
      EXPECT_LE(error(answer, "window RMSE"), 0.002);
    }
}

TEST_F(Truth, TellsFormatsAndLevelsOfBloom) {
  const auto difference = [&](const char* key, int value) {
    return error(ask("bloom", {{"quality", {{key, value}}}}),
                 "difference from the exact Gaussians");
  };
  EXPECT_EQ(difference("bloom_format", 0), 1) << "8 bits hold no light beyond 1";
  EXPECT_GT(difference("bloom_format", 1), 2 * difference("bloom_format", 2));
  EXPECT_GT(difference("bloom_levels", 2), difference("bloom_levels", 4));
  EXPECT_GT(difference("bloom_levels", 4), difference("bloom_levels", 6));
}

} // namespace
