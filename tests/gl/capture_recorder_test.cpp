// Where passes and steps begin and end, what they say, what they sample, and their matrices.

#include "capture_traces.hpp"

#include <gmock/gmock.h>

#include <GL/gl.h>
#include <GL/glext.h>

namespace ggrade::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using trace::kNone;

TEST(CapturePasses, EndWhenAttachmentsChange) {
  const trace::Trace trace = record("passes", "attachments").capture.trace;
  EXPECT_THAT(
      lines(trace.passes),
      ElementsAre(
          "draw color0=texture 1 RGBA8 8x8; 1 draws; to color0; cleared color0; written color0",
          "draw color0=texture 2 RGBA16F 4x4; 1 draws; to color0; written color0",
          "draw color0=texture 1 RGBA8 8x8; 1 draws; to color0; written color0",
          "draw color0=window RGBA8 8x8; 2 draws; to color0; written color0"));
  ASSERT_EQ(trace.passes.size(), 4U);
  EXPECT_THAT(trace.passes[1].viewport, ElementsAre(0, 0, 4, 4));
  EXPECT_EQ(trace.passes[1].framebuffer, 1U);
  EXPECT_EQ(trace.passes[3].framebuffer, 0U);
  EXPECT_EQ(trace.passes[3].vertices, 6U);
  EXPECT_EQ(trace.passes[3].images[trace::kStencil].format,
            static_cast<std::uint32_t>(GL_DEPTH24_STENCIL8));
  EXPECT_EQ(trace.passes[0].status, static_cast<std::uint32_t>(GL_FRAMEBUFFER_COMPLETE));
}

TEST(CapturePasses, EndWhenDrawBuffersChange) {
  const trace::Trace trace = record("passes", "draw_buffers").capture.trace;
  const std::string images = "draw color0=texture 1 RGBA8 8x8 color2=texture 2 RGBA8 8x8";
  EXPECT_THAT(lines(trace.passes),
              ElementsAre(images + "; 1 draws; to color0; written color0",
                          images + "; 1 draws; to color2; written color2",
                          images + "; to color0 color2; cleared color2; written color2"));
}

TEST(CapturePasses, GoOnInAnotherFramebufferWithTheSameImages) {
  const trace::Trace trace = record("passes", "same_images").capture.trace;
  EXPECT_THAT(lines(trace.passes),
              ElementsAre("draw color0=texture 1 RGBA8 8x8; 2 draws; to color0; written color0"));
}

TEST(CapturePasses, EndAtAClearAfterDraws) {
  const trace::Trace trace = record("passes", "clears").capture.trace;
  EXPECT_THAT(lines(trace.passes),
              ElementsAre("draw color0=window RGBA8 8x8; 1 draws; to color0; cleared color0 depth; "
                          "written color0 depth",
                          // The colour was cleared in part, then without alpha; depth was masked.
                          "draw color0=window RGBA8 8x8; to color0; cleared stencil; "
                          "written color0 stencil"));
  ASSERT_EQ(trace.passes.size(), 2U);
  EXPECT_THAT(trace.passes[0].clearColor, ElementsAre(0.1F, 0.2F, 0.3F, 0.4F));
  EXPECT_EQ(trace.passes[0].clearDepth, 0.5F);
  EXPECT_EQ(trace.passes[1].clearStencil, 7U);
}

TEST(CapturePasses, TellLevelsLayersAndFacesApart) {
  const trace::Trace trace = record("passes", "levels").capture.trace;
  const std::string rest = "; to color0; cleared color0; written color0";
  EXPECT_THAT(lines(trace.passes), ElementsAre("draw color0=texture 1 RGBA8 8x8" + rest,
                                               "draw color0=texture 1 level 1 RGBA8 4x4" + rest,
                                               "draw color0=texture 1 level 2 RGBA8 2x2" + rest,
                                               "draw color0=texture 2 layer 1 RGBA8 8x8" + rest,
                                               "draw color0=texture 2 layer 2 RGBA8 8x8" + rest,
                                               "draw color0=texture 3 layer 2 RGBA8 8x8" + rest,
                                               "draw color0=texture 3 layer 5 RGBA8 8x8" + rest,
                                               "draw color0=texture 2 RGBA8 8x8" + rest));
  const std::vector<double> expected[] = {{0, 0, 0, 255},   {51, 0, 0, 255},     {102, 0, 0, 255},
                                          {0, 51, 0, 255},  {0, 102, 0, 255},    {0, 0, 102, 255},
                                          {0, 0, 255, 255}, {255, 255, 255, 255}};
  for (std::uint32_t pass = 0; pass < std::size(expected); ++pass)
    EXPECT_EQ(valueAfter(trace, pass, 0, 1, 1), expected[pass]) << "pass " << pass;
}

TEST(CapturePasses, BlitsAreTheirOwn) {
  const trace::Trace trace = record("passes", "blit").capture.trace;
  EXPECT_THAT(lines(trace.passes),
              ElementsAre("draw color0=renderbuffer 1 RGBA8 8x8 x4; to color0; cleared color0; "
                          "written color0",
                          "blit color0=texture 1 RGBA8 8x8; to color0; written color0",
                          "draw color0=window RGBA8 8x8; 1 draws; to color0; written color0"));
  ASSERT_EQ(trace.steps.size(), 2U);
  EXPECT_THAT(samplesOf(trace, 0), ElementsAre("renderbuffer 1 RGBA8 8x8 x4, writer 0"));
  EXPECT_THAT(samplesOf(trace, 1), ElementsAre("uTexture unit 0: texture 1 RGBA8 8x8, writer 1"));
  for (std::uint32_t pass = 0; pass < 3; ++pass)
    EXPECT_THAT(valueAfter(trace, pass, 0, 4, 4), ElementsAre(51, 102, 153, 255)) << pass;
}

TEST(CapturePasses, CopiesAreTheirOwn) {
  const trace::Trace trace = record("passes", "copies").capture.trace;
  EXPECT_THAT(lines(trace.passes),
              ElementsAre("draw color0=texture 1 RGBA8 8x8; to color0; cleared color0; "
                          "written color0",
                          "copy color0=texture 2 RGBA8 8x8; to color0; written color0",
                          "copy color0=texture 3 RGBA8 8x8; to color0; written color0",
                          "copy depth=texture 2 DEPTH_COMPONENT24 8x8; written depth",
                          "copy color0=texture 2 RGBA8 8x8; to color0; written color0"));
  ASSERT_EQ(trace.steps.size(), 4U);
  EXPECT_THAT(samplesOf(trace, 0), ElementsAre("texture 1 RGBA8 8x8, writer 0"));
  EXPECT_THAT(samplesOf(trace, 1), ElementsAre("texture 2 RGBA8 8x8, writer 1"));
  EXPECT_THAT(samplesOf(trace, 2), ElementsAre("window DEPTH24_STENCIL8 8x8"));
  EXPECT_THAT(samplesOf(trace, 3), ElementsAre("window RGBA8 8x8"));
  EXPECT_THAT(valueAfter(trace, 2, 0), ElementsAre(51, 102, 153, 255));
}

TEST(CapturePasses, MipmapGenerationWritesTheLevelsBelow) {
  const trace::Trace trace = record("passes", "mipmap").capture.trace;
  ASSERT_EQ(trace.passes.size(), 3U);
  EXPECT_EQ(line(trace.passes[1]),
            "mipmap color0=texture 1 level 1 RGBA8 4x4; to color0; written color0");
  EXPECT_EQ(trace.passes[1].framebuffer, kNone);
  EXPECT_THAT(samplesOf(trace, 0), ElementsAre("texture 1 RGBA8 8x8, writer 0"));
  EXPECT_THAT(samplesOf(trace, 1),
              ElementsAre("uTexture unit 0: texture 1 level 2 RGBA8 2x2, writer 1"));
  EXPECT_THAT(valueAfter(trace, 1, 0), ElementsAre(51, 102, 153, 255));
}

TEST(CapturePasses, ComputeShadersWriteImages) {
  const trace::Trace trace = record("passes", "compute").capture.trace;
  ASSERT_EQ(trace.passes.size(), 2U);
  EXPECT_EQ(line(trace.passes[0]),
            "imageStore color0=texture 1 RGBA8 8x8; to color0; written color0");
  EXPECT_THAT(samplesOf(trace, 1), ElementsAre("uTexture unit 0: texture 1 RGBA8 8x8, writer 0"));
  EXPECT_THAT(valueAfter(trace, 0, 0, 7, 0), ElementsAre(51, 102, 153, 255));
}

TEST(CapturePasses, EndWhenWhatTheyDrewIsUploadedTo) {
  const trace::Trace trace = record("passes", "uploads").capture.trace;
  EXPECT_THAT(
      lines(trace.passes),
      ElementsAre(
          "draw color0=texture 1 RGBA8 8x8; 2 draws; to color0; cleared color0; written color0",
          "draw color0=texture 1 RGBA8 8x8; 1 draws; to color0; written color0",
          "draw color0=window RGBA8 8x8; 2 draws; to color0; written color0"));
  ASSERT_EQ(trace.steps.size(), 4U);
  EXPECT_THAT(samplesOf(trace, 2), ElementsAre("uTexture unit 0: texture 1 RGBA8 8x8, writer 1"));
  EXPECT_THAT(samplesOf(trace, 3), ElementsAre("uTexture unit 0: texture 1 RGBA8 8x8"));
}

TEST(CapturePasses, KeepWhatIsDeletedLaterInTheFrame) {
  const trace::Trace trace = record("passes", "deleted", 2).capture.trace;
  ASSERT_EQ(trace.passes.size(), 8U);
  EXPECT_EQ(trace.copiesLost, 0U);
  for (const std::uint32_t first : {0U, 4U}) {
    EXPECT_THAT(valueAfter(trace, first, 0), ElementsAre(51, 102, 153, 255));
    EXPECT_THAT(valueAfter(trace, first + 1, 0), ElementsAre(2, 3, 4, 1));
    EXPECT_THAT(valueAfter(trace, first + 2, 0, 7, 7), ElementsAre(255, 0, 0, 255));
    EXPECT_THAT(valueAfter(trace, first + 3, 0, 3, 3), ElementsAre(0, 255, 0, 255));
    EXPECT_EQ(trace.passes[first + 2].images[0].width, 8U);
    EXPECT_EQ(trace.passes[first + 3].images[0].width, 4U);
  }
}

TEST(CapturePasses, BelongToFrames) {
  const trace::Trace trace = record("samples", "ping_pong", 3).capture.trace;
  ASSERT_EQ(trace.frames.size(), 3U);
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_EQ(trace.frames[i].firstPass, 2 * i);
    EXPECT_EQ(trace.frames[i].passCount, 2U);
    EXPECT_EQ(trace.passes[2 * i].frame, i);
    EXPECT_EQ(trace.passes[2 * i + 1].frame, i);
    EXPECT_EQ(trace.frames[i].imageBytes, 3U * 8 * 8 * 4);
    EXPECT_EQ(trace.frames[i].bufferBytes, 0U);
  }
}

TEST(CapturePasses, AreNotRecordedUnlessAskedFor) {
  const trace::Trace trace = record("passes", "attachments", 1, {}).capture.trace;
  EXPECT_THAT(trace.passes, IsEmpty());
  EXPECT_THAT(trace.frames, IsEmpty());
}

TEST(CapturePasses, AreTimedWhenAskedFor) {
  trace::Request request{};
  request.passes = 1;
  EXPECT_EQ(record("passes", "attachments", 1, request).capture.trace.passes.at(0).seconds, 0);
  for (const trace::Times clock : {trace::Times::wall, trace::Times::processor}) {
    request.times = static_cast<std::uint32_t>(clock);
    const trace::Trace trace = record("passes", "blit", 1, request).capture.trace;
    ASSERT_EQ(trace.passes.size(), 3U);
    for (const trace::PassRecord& pass : trace.passes) {
      EXPECT_GT(pass.seconds, 0);
      EXPECT_LT(pass.seconds, 5);
    }
  }
}

TEST(CapturePasses, WaitingTakesNoTimeOfTheProcessor) {
  trace::Request request{};
  request.passes = 1;
  const auto secondsBy = [&](trace::Times clock) {
    request.times = static_cast<std::uint32_t>(clock);
    return record("passes", "sleeps", 1, request).capture.trace.passes.at(0).seconds;
  };
  EXPECT_GE(secondsBy(trace::Times::wall), 0.2);
  EXPECT_LT(secondsBy(trace::Times::processor), 0.1);
}

TEST(CaptureSteps, EndWhenStateChanges) {
  const trace::Trace trace = record("passes", "steps").capture.trace;
  ASSERT_EQ(trace.passes.size(), 1U);
  ASSERT_EQ(trace.steps.size(), 11U);
  EXPECT_EQ(trace.passes[0].stepCount, 11U);
  const auto is = [](GLenum value) { return static_cast<std::uint32_t>(value); };
  const trace::StepRecord* step = trace.steps.data();
  EXPECT_EQ(step->draws, 3U);
  EXPECT_EQ(step->vertices, 3U + 2 + 15);
  EXPECT_EQ(step->mode, is(GL_TRIANGLES));
  EXPECT_EQ(step->depthTest, 0U);
  EXPECT_EQ(step->depthWrite, 1U);
  EXPECT_EQ(step->blend, 0U);
  EXPECT_EQ(step->cullFace, 0U);
  EXPECT_EQ(step->frontFace, is(GL_CCW));
  EXPECT_EQ(step->colorMask, 15U);
  EXPECT_THAT(step->viewport, ElementsAre(0, 0, 8, 8));
  EXPECT_NE(step[1].program, step->program);
  step += 2;
  EXPECT_EQ(step->depthTest, is(GL_LEQUAL));
  EXPECT_EQ((++step)->depthWrite, 0U);
  ++step;
  EXPECT_EQ(step->blend, 1U);
  EXPECT_EQ(step->blendSource, is(GL_SRC_ALPHA));
  EXPECT_EQ(step->blendDestination, is(GL_ONE));
  EXPECT_EQ(step->blendSourceAlpha, is(GL_ZERO));
  EXPECT_EQ(step->blendDestinationAlpha, is(GL_DST_ALPHA));
  EXPECT_EQ(step->blendEquation, is(GL_FUNC_SUBTRACT));
  EXPECT_EQ(step->blendEquationAlpha, is(GL_MAX));
  EXPECT_THAT(step->blendColor, ElementsAre(0.1F, 0.2F, 0.3F, 0.4F));
  ++step;
  EXPECT_EQ(step->cullFace, is(GL_FRONT));
  EXPECT_EQ(step->frontFace, is(GL_CW));
  EXPECT_EQ((++step)->colorMask, 5U);
  ++step;
  EXPECT_EQ(step->stencilTest, 1U);
  const trace::StencilFace& front = step->stencil[0];
  const trace::StencilFace& back = step->stencil[1];
  EXPECT_EQ(front.func, is(GL_EQUAL));
  EXPECT_EQ(front.ref, 3U);
  EXPECT_EQ(front.valueMask, 0x0fU);
  EXPECT_EQ(front.writeMask, 0x3fU);
  EXPECT_EQ(front.fail, is(GL_KEEP));
  EXPECT_EQ(front.depthFail, is(GL_INCR_WRAP));
  EXPECT_EQ(front.depthPass, is(GL_REPLACE));
  EXPECT_EQ(back.func, is(GL_NOTEQUAL));
  EXPECT_EQ(back.ref, 4U);
  EXPECT_EQ(back.valueMask, 0xf0U);
  EXPECT_EQ(back.fail, is(GL_ZERO));
  EXPECT_EQ(back.depthFail, is(GL_DECR_WRAP));
  EXPECT_EQ(back.depthPass, is(GL_INVERT));
  ++step;
  EXPECT_THAT(step->viewport, ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(step->scissorTest, 1U);
  EXPECT_THAT(step->scissor, ElementsAre(2, 3, 4, 5));
  ++step;
  EXPECT_EQ(step->clipDistances, 2U);
  EXPECT_EQ(step->polygonOffset, 1U);
  EXPECT_EQ(step->polygonOffsetFactor, 1.5F);
  EXPECT_EQ(step->polygonOffsetUnits, 4);
  EXPECT_EQ(step->depthClamp, 1U);
  EXPECT_EQ((++step)->rasterizerDiscard, 1U);
  EXPECT_EQ(trace.passes[0].draws, 13U);
  // Depth was written by one step, stencil by another.
  EXPECT_EQ(trace.passes[0].written, 1U | 1U << trace::kDepth | 1U << trace::kStencil);
}

TEST(CaptureSamples, NameTheirWriterOfThisFrameOrTheLast) {
  const trace::Trace trace = record("samples", "ping_pong", 3).capture.trace;
  ASSERT_EQ(trace.steps.size(), 6U);
  const std::string uploaded = "uUploaded unit 5: texture 3 RGBA8 8x8";
  EXPECT_THAT(samplesOf(trace, 0), ElementsAre("uLast unit 0: texture 2 RGBA8 8x8", uploaded));
  EXPECT_THAT(samplesOf(trace, 1), ElementsAre("uTexture unit 0: texture 1 RGBA8 8x8, writer 0"));
  EXPECT_THAT(samplesOf(trace, 2),
              ElementsAre("uLast unit 0: texture 1 RGBA8 8x8, writer 0", uploaded));
  EXPECT_THAT(samplesOf(trace, 4),
              ElementsAre("uLast unit 0: texture 2 RGBA8 8x8, writer 2", uploaded));
}

TEST(CaptureSamples, ThatChangeBeginAStep) {
  const trace::Trace trace = record("samples", "added").capture.trace;
  ASSERT_EQ(trace.steps.size(), 3U);
  EXPECT_EQ(trace.steps[0].draws, 2U);
  EXPECT_THAT(samplesOf(trace, 0), ElementsAre("uTexture unit 0: texture 1 RGBA8 8x8"));
  EXPECT_THAT(samplesOf(trace, 1), ElementsAre("uTexture unit 0: texture 2 RGBA8 8x8"));
  EXPECT_EQ(trace.samples[1].magFilter, static_cast<std::uint32_t>(GL_NEAREST));
  EXPECT_EQ(trace.samples[2].magFilter, static_cast<std::uint32_t>(GL_LINEAR));
}

TEST(CaptureSamples, HaveTheSettingsThatCount) {
  const trace::Trace trace = record("samples", "settings").capture.trace;
  ASSERT_EQ(trace.steps.size(), 2U);
  const std::string image = "unit 3: texture 1 DEPTH_COMPONENT24 8x8";
  EXPECT_THAT(samplesOf(trace, 0), ElementsAre("uMaps[0] " + image, "uMaps[1] " + image));
  EXPECT_THAT(samplesOf(trace, 1), ElementsAre("uMaps[0] " + image + ", sampler 1",
                                               "uMaps[1] " + image + ", sampler 1"));
  const auto is = [](GLenum value) { return static_cast<std::uint32_t>(value); };
  const trace::SampleRecord& own = trace.samples[0];
  EXPECT_EQ(own.compareMode, is(GL_COMPARE_REF_TO_TEXTURE));
  EXPECT_EQ(own.compareFunc, is(GL_GREATER));
  EXPECT_EQ(own.wrapS, is(GL_CLAMP_TO_BORDER));
  EXPECT_EQ(own.wrapT, is(GL_MIRRORED_REPEAT));
  EXPECT_EQ(own.minFilter, is(GL_NEAREST));
  EXPECT_EQ(own.image.target, is(GL_TEXTURE_2D));
  const trace::SampleRecord& sampler = trace.samples[2];
  EXPECT_EQ(sampler.compareMode, is(GL_NONE));
  EXPECT_EQ(sampler.wrapS, is(GL_CLAMP_TO_EDGE));
  EXPECT_EQ(sampler.wrapT, is(GL_REPEAT));
  EXPECT_EQ(sampler.minFilter, is(GL_LINEAR));
}

TEST(CaptureSamples, SayWhenTexturesAreIncomplete) {
  const trace::Trace trace = record("samples", "incomplete").capture.trace;
  ASSERT_EQ(trace.steps.size(), 5U);
  EXPECT_THAT(samplesOf(trace, 0), ElementsAre("uTexture unit 0: nothing, incomplete"));
  EXPECT_THAT(samplesOf(trace, 1), ElementsAre(testing::EndsWith(" 0x0, incomplete")));
  EXPECT_THAT(samplesOf(trace, 2), ElementsAre("uTexture unit 0: texture 1 RGBA8 8x8, incomplete"));
  EXPECT_THAT(samplesOf(trace, 3), ElementsAre("uTexture unit 0: texture 2 RGBA8 8x8"));
  EXPECT_THAT(samplesOf(trace, 4), ElementsAre("uTexture unit 0: texture 3 R32UI 8x8, incomplete"));
}

TEST(CaptureSamples, SayWhenTheyAreAlsoDrawnInto) {
  const trace::Trace trace = record("samples", "feedback").capture.trace;
  ASSERT_EQ(trace.steps.size(), 3U);
  EXPECT_THAT(samplesOf(trace, 0), ElementsAre("uTexture unit 0: texture 1 RGBA8 8x8, feedback"));
  EXPECT_THAT(samplesOf(trace, 1), ElementsAre("uTexture unit 0: texture 1 RGBA8 8x8, writer 0"));
  EXPECT_THAT(samplesOf(trace, 2),
              ElementsAre("uTexture unit 0: texture 1 RGBA8 8x8, writer 0, feedback"));
}

TEST(CaptureMatrices, OfTheProgramAndItsBlocks) {
  const trace::Trace trace = record("samples", "matrices").capture.trace;
  ASSERT_EQ(trace.steps.size(), 2U);
  const auto matrices = trace.matricesOf(trace.steps[0]);
  std::vector<std::string> found;
  const auto find = [&](const std::string& name, std::uint32_t draw) {
    for (const trace::MatrixRecord& matrix : matrices)
      if (matrix.name == name && matrix.draw == draw) return &matrix;
    return static_cast<const trace::MatrixRecord*>(nullptr);
  };
  // The block begins at float 64: a vec4, then columns, rows, and two more.
  const auto expect = [&](const char* name, std::uint32_t draw, float first, bool rows = false) {
    const trace::MatrixRecord* const matrix = find(name, draw);
    ASSERT_NE(matrix, nullptr) << name << " at draw " << draw;
    for (int i = 0; i < 16; ++i) {
      const int place = rows ? i % 4 * 4 + i / 4 : i;
      EXPECT_EQ(matrix->values[i], first + static_cast<float>(place)) << name << " " << i;
    }
  };
  expect("uColumns", 0, 68);
  expect("uRows", 0, 84, true);
  expect("uSeveral[0]", 0, 100);
  expect("uSeveral[1]", 0, 116);
  expect("uOwn", 0, 500);
  expect("uBones[0]", 0, 600);
  expect("uBones[1]", 0, 700);
  expect("uOwn", 2, 501);
  expect("uColumns", 3, 4);
  expect("uRows", 3, 20, true);
  expect("uSeveral[0]", 3, 36);
  expect("uSeveral[1]", 3, 52);
  EXPECT_EQ(matrices.size(), 7U + 1 + 4) << "what doesn't change is recorded once";
  EXPECT_EQ(trace.steps[1].matrixCount, 3U) << "no buffer, no matrices of the block";
}

TEST(CaptureMessages, NameTheirPass) {
  const channel::Capture capture = record("state_kept", "").capture;
  ASSERT_THAT(texts(capture, channel::MessageKind::glError),
              ElementsAre("GL_INVALID_VALUE in glDrawElements"));
  EXPECT_EQ(capture.messages[0].pass, 1U);
  EXPECT_EQ(record("state_kept", "", 1, {}).capture.messages.at(0).pass, kNone);
}

} // namespace
} // namespace ggrade::test
