// Programs that are hard on a recorder: recorded within the limits, and said.

#include "capture_traces.hpp"

#include <gmock/gmock.h>

#include <GL/gl.h>
#include <GL/glext.h>

#include <unistd.h>

namespace ggrade::test {
namespace {

using channel::MessageKind;
using testing::Contains;
using testing::ElementsAre;
using trace::kNone;

std::uint32_t status(GLenum value) {
  return static_cast<std::uint32_t>(value);
}

TEST(CaptureHostile, IncompleteFramebuffersAreNamed) {
  const channel::Capture capture = record("hostile_passes", "incomplete").capture;
  const std::vector<trace::PassRecord>& passes = capture.trace.passes;
  ASSERT_EQ(passes.size(), 4U);
  EXPECT_EQ(passes[0].status, status(GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT));
  EXPECT_EQ(passes[1].status, status(GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT));
  EXPECT_EQ(passes[2].kind, static_cast<std::uint32_t>(trace::PassKind::blit));
  EXPECT_EQ(passes[3].status, status(GL_FRAMEBUFFER_COMPLETE));
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(passes[static_cast<std::size_t>(i)].written, 0U);
    EXPECT_EQ(passes[static_cast<std::size_t>(i)].cleared, 0U);
    EXPECT_EQ(capture.trace.copyOf(static_cast<std::uint32_t>(i), 0), nullptr);
  }
  EXPECT_THAT(texts(capture, MessageKind::glError),
              Contains("GL_INVALID_FRAMEBUFFER_OPERATION in glDrawArrays"));
}

TEST(CaptureHostile, TenThousandPasses) {
  const channel::Capture capture = record("hostile_passes", "many").capture;
  EXPECT_EQ(capture.trace.passes.size(), trace::kMaxPasses);
  EXPECT_EQ(capture.trace.passesLost, 10000 - trace::kMaxPasses);
  EXPECT_EQ(capture.trace.frames.at(0).passCount, trace::kMaxPasses);
  EXPECT_THAT(texts(capture, MessageKind::capture),
              Contains("the run has more than 4096 passes; no more are recorded"));
}

TEST(CaptureHostile, MoreThanTheTablesHold) {
  const channel::Capture capture = record("hostile_passes", "many_steps").capture;
  const trace::Trace& trace = capture.trace;
  EXPECT_EQ(trace.steps.size(), trace::kMaxSteps);
  EXPECT_EQ(trace.stepsLost, 9000 - trace::kMaxSteps);
  EXPECT_EQ(trace.samples.size(), trace::kMaxSamples);
  EXPECT_EQ(trace.matrices.size(), trace::kMaxMatrices);
  EXPECT_GT(trace.samplesLost, 0U);
  EXPECT_GT(trace.matricesLost, 0U);
  ASSERT_EQ(trace.passes.size(), 1U);
  EXPECT_EQ(trace.passes[0].draws, 45000U);
  EXPECT_THAT(texts(capture, MessageKind::capture),
              testing::UnorderedElementsAre(
                  "the run has more than 8192 steps; no more are recorded",
                  "the run has more than 16384 sampled textures; no more are recorded",
                  "the run has more than 32768 matrices; no more are recorded"));
}

TEST(CaptureHostile, MatricesOfAStepHaveALimit) {
  const trace::Trace trace = record("hostile_passes", "bones").capture.trace;
  ASSERT_EQ(trace.steps.size(), 1U);
  EXPECT_EQ(trace.steps[0].matrixCount, trace::kMaxMatricesOfStep);
  EXPECT_EQ(trace.steps[0].draws, 10U);
  const trace::MatrixRecord& last = trace.matrices.back();
  EXPECT_EQ(last.draw, 4U);
  EXPECT_STREQ(last.name, "uBones[15]");
  EXPECT_EQ(last.values[0], 4);
}

TEST(CaptureHostile, AnAttachmentLargerThanTheRoomIsCounted) {
  const channel::Capture capture = record("hostile_passes", "huge").capture;
  const trace::Trace& trace = capture.trace;
  ASSERT_EQ(trace.passes.size(), 2U);
  EXPECT_EQ(trace.passes[0].images[0].width, 16384U);
  EXPECT_EQ(trace.copiesLost, 1U);
  ASSERT_EQ(trace.copies.size(), 1U);
  EXPECT_EQ(trace.copies[0].pass, 1U) << "what is small enough still fits";
  EXPECT_EQ(trace.frames[0].imageBytes, std::uint64_t{16384} * 16384);
  EXPECT_THAT(
      texts(capture, MessageKind::capture),
      Contains("the copies of the passes need more than 67108864 bytes; some are left out"));
}

TEST(CaptureHostile, WithoutRoomNothingIsCopied) {
  trace::Request request = everything();
  request.copyBytes = 0;
  const trace::Trace trace = record("passes", "attachments", 1, request).capture.trace;
  EXPECT_EQ(trace.passes.size(), 4U);
  EXPECT_EQ(trace.copies.size(), 0U);
  EXPECT_EQ(trace.copiesLost, 4U);
}

TEST(CaptureHostile, WhatIsDeletedInUse) {
  const channel::Capture capture = record("hostile_passes", "deleted_in_use", 3).capture;
  const std::vector<trace::PassRecord>& passes = capture.trace.passes;
  ASSERT_EQ(passes.size(), 18U);
  EXPECT_EQ(line(passes[0]),
            "draw color0=texture 1 RGBA8 8x8; to color0; cleared color0; written color0");
  EXPECT_EQ(line(passes[1]), "draw color0=window RGBA8 8x8; 1 draws; to color0; written color0");
  EXPECT_EQ(line(passes[2]), "draw color0=texture 1 RGBA8 8x8; 1 draws; to color0; written color0");
  EXPECT_EQ(passes[3].status, status(GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT));
  // Still attached, but without a name that GL answers for.
  EXPECT_THAT(passes[4].images[0].name, testing::AnyOf(2U, 1U)); // newer Mesa gives names again
  EXPECT_EQ(passes[4].images[0].width, 0U);
  EXPECT_EQ(passes[5].draws, 2U);
  EXPECT_EQ(capture.trace.stepsOf(passes[5]).size(), 2U);
  EXPECT_THAT(valueAfter(capture.trace, 0, 0), ElementsAre(51, 102, 153, 255));
  EXPECT_THAT(valueAfter(capture.trace, 2, 0), ElementsAre(64, 128, 191, 255));
}

TEST(CaptureHostile, NonsenseIsNotRecordedAsIfItHadWorked) {
  const channel::Capture plain = record("hostile_passes", "nonsense", 2, {}).capture;
  const channel::Capture capture = record("hostile_passes", "nonsense", 2).capture;
  EXPECT_EQ(texts(capture, MessageKind::glError), texts(plain, MessageKind::glError));
  EXPECT_THAT(texts(capture, MessageKind::capture), testing::IsEmpty());
  ASSERT_FALSE(capture.trace.passes.empty());
  EXPECT_EQ(capture.trace.passes[0].cleared, 0U);
  for (const trace::PassRecord& pass : capture.trace.passes) {
    if (pass.kind == static_cast<std::uint32_t>(trace::PassKind::blit)) {
      EXPECT_EQ(pass.written, 0U) << "GL refused it";
    }
  }
  EXPECT_EQ(samplesOf(capture.trace, 0),
            std::vector<std::string>{"uTexture unit 79: nothing, incomplete"});
}

TEST(CaptureHostile, TwoContextsOnOneThread) {
  const trace::Trace trace = record("hostile_passes", "contexts", 2).capture.trace;
  const std::string cleared = "; to color0; cleared color0; written color0";
  ASSERT_EQ(trace.passes.size(), 8U);
  EXPECT_EQ(line(trace.passes[0]), "draw color0=window RGBA8 8x8" + cleared);
  EXPECT_EQ(line(trace.passes[1]), "draw color0=window RGBA8 4x4" + cleared);
  EXPECT_EQ(line(trace.passes[2]), "draw color0=texture 1 RGBA8 8x8" + cleared);
  EXPECT_EQ(line(trace.passes[3]),
            "draw color0=window RGBA8 8x8; 1 draws; to color0; written color0");
  EXPECT_THAT(samplesOf(trace, 0), ElementsAre("uTexture unit 0: texture 1 RGBA8 8x8, writer 2"));
  EXPECT_THAT(samplesOf(trace, 1), ElementsAre("uTexture unit 0: texture 1 RGBA8 8x8, writer 6"));
  EXPECT_THAT(valueAfter(trace, 1, 0, 3, 3), ElementsAre(255, 0, 0, 255));
  EXPECT_THAT(valueAfter(trace, 3, 0), ElementsAre(0, 255, 0, 255));
}

TEST(CaptureHostile, TwoThreadsDrawAtOnce) {
  for (int i = 0; i < 5; ++i) {
    const trace::Trace trace = record("hostile_passes", "threads", 3).capture.trace;
    EXPECT_EQ(trace.passes.size(), 6U);
    EXPECT_EQ(trace.steps.size(), 600U);
    for (const trace::StepRecord& step : trace.steps) EXPECT_EQ(step.sampleCount, 1U);
  }
}

TEST(CaptureHostile, TheCompatibilityProfilesWaysToDraw) {
  const CaptureRun run = record("compatible_passes", "", 2);
  EXPECT_EQ(run.output, "scale 0.25\n");
  const trace::Trace& trace = run.capture.trace;
  ASSERT_EQ(trace.passes.size(), 4U);
  EXPECT_EQ(line(trace.passes[0]), "draw color0=window RGBA8 8x8; 1 draws; to color0; "
                                   "cleared color0; written color0");
  // The list's clear isn't seen by itself.
  EXPECT_EQ(line(trace.passes[1]), "draw color0=window RGBA8 8x8; 1 draws; to color0; "
                                   "cleared depth; written color0 depth");
  EXPECT_THAT(valueAfter(trace, 0, 0, 0, 0), ElementsAre(51, 102, 153, 255));
  EXPECT_THAT(valueAfter(trace, 0, 0, 7, 7), ElementsAre(255, 0, 0, 255));
  EXPECT_THAT(valueAfter(trace, 1, 0, 0, 0), ElementsAre(0, 255, 0, 255));
}

TEST(CaptureRequests, OutOfRangeAreRefused) {
  const auto refused = [](const trace::Request& request) {
    // As a judging side would write it that doesn't check.
    const channel::Channel channel({{0, 8, 8}}, channel::kDefaultMaxPixels, everything());
    channel::Plan plan = channel.plan();
    plan.trace = request;
    EXPECT_EQ(pwrite(channel.descriptor(), &plan, sizeof(plan), 0),
              static_cast<ssize_t>(sizeof(plan)));
    CaptureOptions options;
    options.arguments = {"attachments"};
    const CaptureRun run = runWithDescriptor("passes", channel.descriptor(), options);
    EXPECT_EQ(run.exitCode, channel::kRefusedExit);
    return run.errors;
  };
  const std::string start = "ggrade capture: GG_CAPTURE_FD: ";
  trace::Request request = everything();
  request.stepCopies = 2;
  EXPECT_EQ(refused(request), start + "a switch of what to record is neither 0 nor 1\n");
  request = everything();
  request.times = 3;
  EXPECT_EQ(refused(request), start + "there is no such clock\n");
  request = everything();
  request.copies = 1U << trace::kAttachments;
  EXPECT_EQ(refused(request), start + "attachments to copy out of range\n");
  request = everything();
  request.copyFrames = channel::kMaxFrames + 1;
  EXPECT_EQ(refused(request), start + "frames to copy out of range\n");
  request = everything();
  request.copyBytes = channel::kMaxCopyBytes + 1;
  EXPECT_EQ(refused(request), start + "room for copies out of range\n");
}

} // namespace
} // namespace ggrade::test
