// Frames that are drawn and not looked at: what is recorded of the others is what it would be
// without them, but for what the program makes of having drawn them.

#include "capture_traces.hpp"

#include <gmock/gmock.h>

#include <GL/gl.h>

namespace ggrade::test {
namespace {

using channel::PlannedFrame;
using testing::Each;
using testing::ElementsAre;
using testing::Field;

CaptureRun run(const std::string& program, const std::string& scenario,
               const std::vector<PlannedFrame>& frames, const CaptureOptions& more = {}) {
  CaptureOptions options = more;
  if (!scenario.empty()) options.arguments = {scenario};
  options.trace = everything();
  CaptureRun run = runCaptured(program, frames, options);
  EXPECT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_EQ(run.capture.error, "");
  return run;
}

/// Its two passes a frame read what the frame before left.
TEST(CaptureUnseen, FramesLeaveWhatLaterOnesReadAndNothingElse) {
  const PlannedFrame seen{0, 8, 8}, unseen{0, 8, 8, 1};
  const channel::Capture all = run("samples", "ping_pong", {seen, seen, seen, seen, seen}).capture;
  const channel::Capture some =
      run("samples", "ping_pong", {unseen, unseen, seen, unseen, seen}).capture;
  ASSERT_EQ(some.frames.size(), 2U);
  EXPECT_EQ(some.unseenFrames, 3U);
  EXPECT_EQ(some.frames[0].pixels, all.frames[2].pixels);
  EXPECT_EQ(some.frames[1].pixels, all.frames[4].pixels);
  ASSERT_EQ(some.trace.frames.size(), 2U);
  for (const std::size_t frame : {0U, 1U}) {
    const trace::Trace only = trace::framesOf(some.trace, frame, 1);
    const trace::Trace wanted = trace::framesOf(all.trace, 2 + 2 * frame, 1);
    EXPECT_EQ(lines({some.trace.passesOf(frame).begin(), some.trace.passesOf(frame).end()}),
              lines(wanted.passes));
    EXPECT_THAT(some.trace.passesOf(frame), Each(Field(&trace::PassRecord::frame, frame)));
    EXPECT_EQ(samplesOf(only, 0), samplesOf(wanted, 0));
    EXPECT_EQ(only.pixels, wanted.pixels) << "copies";
    ASSERT_EQ(only.copies.size(), wanted.copies.size());
    for (std::size_t i = 0; i < only.copies.size(); ++i) {
      EXPECT_EQ(only.copies[i].pass, wanted.copies[i].pass);
      EXPECT_EQ(only.copies[i].attachment, wanted.copies[i].attachment);
    }
  }
  EXPECT_LT(some.trace.pixels.size(), all.trace.pixels.size());
  EXPECT_EQ(some.trace.passesLost + some.trace.copiesLost + some.trace.stepsLost, 0U);
}

TEST(CaptureUnseen, FramesDoNotCountAsThoseThatAreCopied) {
  CaptureOptions options;
  options.arguments = {"ping_pong"};
  options.trace = everything();
  options.trace.copyFrames = 1;
  const trace::Trace trace =
      runCaptured("samples", {{0, 8, 8, 1}, {0, 8, 8, 1}, {0, 8, 8}, {0, 8, 8}}, options)
          .capture.trace;
  EXPECT_EQ(trace.passes.size(), 4U);
  EXPECT_EQ(trace.copies.size(), 2U);
}

/// What is replaced is what the first frame that is looked at draws, counted from there.
TEST(CaptureUnseen, FramesAreNotThoseInWhichOutputsAreReplaced) {
  CaptureOptions options;
  channel::PassPixels green{0, 0, trace::PixelType::u8x4, GL_RGBA8, 8, 8, {}};
  const channel::Capture plain = run("replaced", "sampled", {{0, 8, 8}}).capture;
  ASSERT_FALSE(plain.trace.passes.empty());
  const trace::ImageRef& image = plain.trace.passes[0].images[0];
  green.format = image.format;
  green.width = image.width;
  green.height = image.height;
  green.pixels.resize(4ULL * image.width * image.height, std::byte{255});
  options.replacements = {green};
  const channel::Capture first = run("replaced", "sampled", {{0, 8, 8}}, options).capture;
  const channel::Capture later =
      run("replaced", "sampled", {{0, 8, 8, 1}, {0, 8, 8, 1}, {0, 8, 8}}, options).capture;
  EXPECT_THAT(first.replacements, ElementsAre(channel::ReplacementAnswer::done));
  EXPECT_THAT(later.replacements, ElementsAre(channel::ReplacementAnswer::done));
  EXPECT_EQ(later.frames.at(0).pixels, first.frames.at(0).pixels);
  EXPECT_NE(first.frames.at(0).pixels, plain.frames.at(0).pixels);
}

TEST(CaptureUnseen, FramesHaveSizesOfTheirOwn) {
  const channel::Capture capture =
      run("resized", "", {{0, 320, 200, 1}, {0, 64, 48}, {0, 32, 16, 1}, {0, 48, 64}}).capture;
  ASSERT_EQ(capture.frames.size(), 2U);
  EXPECT_EQ(capture.frames[0].width, 64U);
  EXPECT_EQ(capture.frames[1].height, 64U);
}

/// A message that comes again later is told with the frame and pass in which it can be looked at.
TEST(CaptureUnseen, FramesMessagesAreThoseOfTheNextOne) {
  const channel::Capture all = run("errors", "", {{0, 8, 8}, {0, 8, 8}}).capture;
  const channel::Capture some = run("errors", "", {{0, 8, 8, 1}, {0, 8, 8}}).capture;
  ASSERT_EQ(some.messages.size(), all.messages.size());
  for (const channel::CapturedMessage& message : some.messages) EXPECT_EQ(message.frame, 0U);
}

} // namespace
} // namespace ggrade::test
