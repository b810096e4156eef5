#include "check/observed.hpp"
#include "diagnosis/outcome.hpp"
#include "trace_samples.hpp"

#include <gmock/gmock.h>

using namespace ggrade;
using diagnosis::stateFaults;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

/// A pass into a texture, and the window's with one step, which draws.
trace::Trace drawing() {
  trace::Trace trace = trace::samples::mirror();
  for (trace::StepRecord& step : trace.steps) {
    step.draws = 1;
    step.scissorTest = 0;
  }
  return trace;
}

/// What is said when this is done to the window's step.
template <class Change> std::vector<std::string> after(Change change) {
  trace::Trace trace = drawing();
  change(trace.steps[1]);
  return stateFaults(trace);
}

TEST(CheckState, SilentWhenAllIsWell) {
  EXPECT_THAT(stateFaults(drawing()), IsEmpty());
  EXPECT_THAT(stateFaults({}), IsEmpty());
}

TEST(CheckState, NamesWhatHidesEverything) {
  using Step = trace::StepRecord;
  EXPECT_THAT(after([](Step& s) { s.program = 0; }),
              ElementsAre(HasSubstr("no program is in use")));
  EXPECT_THAT(after([](Step& s) { s.colorMask = 0; }), ElementsAre(HasSubstr("glColorMask")));
  EXPECT_THAT(after([](Step& s) { s.scissorTest = 1; }), ElementsAre(HasSubstr("scissor")));
  EXPECT_THAT(after([](Step& s) { s.depthTest = GL_NEVER; }), ElementsAre(HasSubstr("GL_NEVER")));
  EXPECT_THAT(after([](Step& s) {
                s.blend = 1;
                s.blendSource = GL_ZERO;
                s.blendDestination = GL_ONE;
              }),
              ElementsAre(HasSubstr("GL_ZERO")));
  EXPECT_THAT(after([](Step& s) { s.cullFace = GL_FRONT_AND_BACK; }),
              ElementsAre(HasSubstr("culled")));
  EXPECT_THAT(after([](Step& s) { s.viewport[2] = 0; }), ElementsAre(HasSubstr("viewport")));
  EXPECT_THAT(after([](Step& s) { s.depthWrite = 0; }), ElementsAre(HasSubstr("glDepthMask")));
}

TEST(CheckState, WhatOnlyATextureIsDrawnWithIsNotTheWindows) {
  trace::Trace trace = drawing();
  trace.steps[0].colorMask = 0;
  trace.steps[0].depthWrite = 0;
  EXPECT_THAT(stateFaults(trace), IsEmpty());
}

TEST(CheckState, NamesWhatHidesObjectsInATexture) {
  trace::Trace trace = drawing();
  trace.steps[0].vertices = 300;
  EXPECT_THAT(stateFaults(trace), IsEmpty());
  trace.passes[0].images[trace::kDepth] = trace.passes[0].images[0];
  trace.steps[0].depthTest = 0;
  EXPECT_THAT(stateFaults(trace), ElementsAre(HasSubstr("while the depth test is off")));
  trace.passes[0].images[trace::kDepth].kind = std::uint32_t(trace::ImageKind::none);
  EXPECT_THAT(stateFaults(trace), IsEmpty()) << "it has none";
  trace.steps[0].cullFace = GL_FRONT_AND_BACK;
  EXPECT_THAT(stateFaults(trace), ElementsAre(HasSubstr("Front and back faces are culled")));
  trace.steps[0].vertices = 6;
  EXPECT_THAT(stateFaults(trace), IsEmpty()) << "no object";
}

TEST(CheckState, NamesClearsThatHideEverything) {
  trace::Trace trace = drawing();
  trace.passes[1].cleared |= 1U << trace::kDepth;
  trace.passes[1].clearDepth = 0;
  EXPECT_THAT(stateFaults(trace), ElementsAre(HasSubstr("glClearDepth")));

  trace = drawing();
  trace::PassRecord last = trace.passes[1];
  last.draws = last.stepCount = 0;
  last.cleared = 1;
  trace.passes.push_back(last);
  trace.frames[0].passCount = 3;
  EXPECT_THAT(stateFaults(trace), ElementsAre(HasSubstr("cleared after the last draw")));
}

TEST(CheckState, SamplersAreListedWithWhatTheyRead) {
  trace::Trace trace = drawing();
  ASSERT_FALSE(trace.samples.empty());
  const std::string name = trace.samples[0].uniform;
  trace.samples[0].image.format = 0x8058; // GL_RGBA8
  trace.samples[0].image.width = 7;
  trace.samples[0].image.height = 5;
  trace.samples[0].sampler = 3;
  trace.samples[0].incomplete = 1;
  diagnosis::Sampled wanted{false, 7, 5, true, false};
  EXPECT_THAT(diagnosis::sampledTextures(trace), ElementsAre(std::pair(name, wanted)));
  trace.samples[0].image.format = 0x81A6; // GL_DEPTH_COMPONENT24
  wanted.isDepth = true;
  EXPECT_THAT(diagnosis::sampledTextures(trace), ElementsAre(std::pair(name, wanted)));
  trace.samples[0].image.name = 0;
  EXPECT_THAT(diagnosis::sampledTextures(trace), IsEmpty());
}

TEST(CheckState, WhoReadsASamplerIsTheStepWithWhichItIsReadFirst) {
  check::Expected expected;
  expected.todos = {"m.1", "m.2", "m.3"};
  const diagnosis::Sampled scene{false, 640, 480}, level{false, 320, 240};
  expected.samplers = {{{"uMap", {}}},
                       {{"uMap", {}}, {"uScene", scene}},
                       {{"uMap", {}}, {"uScene", scene}},
                       {{"uMap", {}}, {"uScene", scene}, {"uLevel", level}}};
  EXPECT_EQ(check::readerOf(expected, "uScene"), "m.1");
  EXPECT_EQ(check::readerOf(expected, "uLevel"), "m.3");
  EXPECT_EQ(check::readerOf(expected, "uMap"), "") << "another part's";
  EXPECT_EQ(check::readerOf(expected, "uOther"), "");

  trace::Trace trace = drawing();
  EXPECT_THAT(check::bindingForTheWindow(expected, 3, trace), IsEmpty());
  trace.passes.back().framebuffer = 0;
  for (trace::SampleRecord& sample : trace.samples)
    std::snprintf(sample.uniform, sizeof sample.uniform, "uLevel");
  const auto binding = check::bindingForTheWindow(expected, 3, trace);
  EXPECT_EQ(binding, std::set<std::string>{"m.3"});
}

TEST(CheckState, GuessesAboutSamplersOfOtherPartsAreNotTold) {
  check::Expected expected;
  expected.samplers = {{{"uReflection", {}}}, {{"uReflection", {}}, {"uScene", {}}}};
  const std::string doctor = check::doctorsPrefix(), perhaps = doctor + "perhaps: sampler ";
  std::vector<std::string> said = {"floor: hello", doctor + "the depth test is on",
                                   perhaps + "uReflection reads black (after mirror.hpp:70)",
                                   perhaps + "uScene reads black", perhaps + "uOther reads black"};
  check::dropPointless(said, expected, 1);
  EXPECT_THAT(said, ElementsAre("floor: hello", doctor + "the depth test is on",
                                perhaps + "uScene reads black"));
  EXPECT_THAT(check::doctorsFindings(said), ElementsAre("the depth test is on"));
}

} // namespace
