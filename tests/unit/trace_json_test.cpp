// trace.json against its documentation.

#include "trace_samples.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

namespace ggrade::trace {
namespace {

using nlohmann::json;
using samples::mirror;

TEST(TraceJson, SaysWhatWasRecorded) {
  const json all = toJson(mirror(), {{"frame-0/pass-00-color0.png", "", "as stored", 0, 1},
                                     {"frame-0/pass-00-depth.png", "frame-0/pass-00-depth.f32",
                                      "stretched depth by uProjection", 2, 4}});
  const json& reflection = all.at("passes").at(0);
  EXPECT_EQ(reflection.at("index"), 0);
  EXPECT_EQ(reflection.at("kind"), "draw");
  EXPECT_EQ(reflection.at("framebuffer"), 1);
  EXPECT_EQ(reflection.at("status"), "FRAMEBUFFER_COMPLETE");
  EXPECT_EQ(reflection.at("attachments").at("color0").dump(),
            R"({"format":"RGBA16F","height":2,"kind":"texture","layer":null,"level":0,"name":7,)"
            R"("samples":0,"target":"TEXTURE_2D","width":2})");
  EXPECT_EQ(reflection.at("attachments").at("depth").at("kind"), "renderbuffer");
  EXPECT_EQ(reflection.at("attachments").size(), 2U);
  EXPECT_EQ(reflection.at("draw_buffers"), json({"color0"}));
  EXPECT_EQ(reflection.at("cleared"), json({"color0", "depth"}));
  EXPECT_EQ(reflection.at("clear_color").dump(), "[0.0,0.2,0.0,0.0]");
  EXPECT_EQ(reflection.at("clear_depth"), 1);
  EXPECT_FALSE(reflection.contains("clear_stencil"));
  EXPECT_FALSE(reflection.contains("seconds"));
  EXPECT_EQ(reflection.at("viewport"), json({0, 0, 2, 2}));
  EXPECT_EQ(reflection.at("read_by"), json({1}));
  const json& step = reflection.at("steps").at(0);
  EXPECT_EQ(step.at("mode"), "TRIANGLES");
  EXPECT_EQ(step.at("cull_face"), "FRONT");
  EXPECT_EQ(step.at("depth_test"), "LESS");
  EXPECT_EQ(step.at("blend"), nullptr);
  EXPECT_EQ(step.at("stencil"), nullptr);
  EXPECT_EQ(step.at("clip_distances"), json({0}));
  EXPECT_EQ(step.at("matrices").at(0).at("values").size(), 16U);
  EXPECT_EQ(step.at("matrices").at(0).at("values").at(14), -2.25);
  const json& copies = reflection.at("copies");
  EXPECT_EQ(copies.at(0).dump(),
            R"({"attachment":"color0","height":2,"high":1.0,"image":"frame-0/pass-00-color0.png",)"
            R"("low":0.0,"scale":"as stored","step":null,"type":"f16x4","width":2})");
  EXPECT_EQ(copies.at(1).at("raw"), "frame-0/pass-00-depth.f32");

  const json& window = all.at("passes").at(1);
  EXPECT_EQ(window.at("attachments").at("color0").at("kind"), "window");
  EXPECT_EQ(window.at("copies"), json::array());
  EXPECT_FALSE(window.contains("clear_color"));
  const json& floor = window.at("steps").at(0);
  EXPECT_EQ(floor.at("blend").at("destination"), "ONE_MINUS_SRC_ALPHA");
  EXPECT_EQ(floor.at("stencil").at("back").at("depth_fail"), "INCR_WRAP");
  EXPECT_EQ(floor.at("polygon_offset").dump(), "[1.1,0.0]");
  const json& sample = floor.at("samples").at(0);
  EXPECT_EQ(sample.at("uniform"), "uReflection");
  EXPECT_EQ(sample.at("written_by"), 0);
  EXPECT_EQ(sample.at("wrap_s"), "CLAMP_TO_EDGE");
  EXPECT_EQ(sample.at("compare"), "LEQUAL");
  EXPECT_EQ(all.at("lost").dump(), R"({"copies":0,"matrices":0,"passes":0,"samples":0,"steps":0})");
}

TEST(TraceJson, WhatIsNoNumberIsNull) {
  Trace trace = mirror();
  trace.matrices[0].values[3] = NAN;
  trace.passes[0].clearColor[0] = INFINITY;
  const json pass = toJson(trace).at("passes").at(0);
  EXPECT_EQ(pass.at("steps").at(0).at("matrices").at(0).at("values").at(3), nullptr);
  EXPECT_EQ(pass.at("clear_color").dump(), "[null,0.2,0.0,0.0]");
}

TEST(TraceJson, AStepOfACopyIsCountedWithinItsPass) {
  Trace trace = mirror();
  samples::addCopy<std::uint8_t>(trace, 1, 0, PixelType::u8x4, 1, 1, {1, 2, 3, 4}).step = 1;
  EXPECT_EQ(toJson(trace).at("passes").at(1).at("copies").at(0).at("step"), 0);
}

void collectKeys(const json& from, std::set<std::string>& keys) {
  if (from.is_object())
    for (const auto& [key, value] : from.items()) keys.insert(key);
  for (const json& value : from)
    if (value.is_structured()) collectKeys(value, keys);
}

TEST(TraceJson, EveryKeyIsDocumented) {
  std::ifstream in(GGRADE_SOURCE_DIR "/docs/trace.md");
  std::stringstream text;
  text << in.rdbuf();
  ASSERT_NE(text.str(), "");
  Trace trace = mirror();
  trace.passes[0].seconds = 0.1;
  trace.passes[0].cleared |= 1U << kStencil;
  std::set<std::string> keys;
  collectKeys(toJson(trace, {{"a.png", "a.f32", "as stored", 0, 1}}), keys);
  EXPECT_GT(keys.size(), 70U);
  for (const std::string& key : keys) {
    // The page writes of `source_alpha` and its kind as "the same with `_alpha`".
    const std::size_t alpha = key.rfind("_alpha");
    const std::string documented = alpha == key.npos ? key : key.substr(0, alpha);
    EXPECT_NE(text.str().find("`" + documented + "`"), std::string::npos) << key;
  }
}

} // namespace
} // namespace ggrade::trace
