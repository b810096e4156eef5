// What the captured frames hold, for each way that a program has to GL.

#include "capture_run.hpp"

#include <gmock/gmock.h>

namespace ggrade::test {
namespace {

using channel::CapturedFrame;
using testing::ElementsAre;

const std::vector<int> kBlack{0, 0, 0, 255};
const std::vector<int> kBlue{0, 0, 255, 255};
const std::vector<int> kGreen{0, 255, 0, 255};
const std::vector<int> kRed{255, 0, 0, 255};
const std::vector<int> kWhite{255, 255, 255, 255};

TEST(CaptureFrames, OfAProgramThatGladLoadsAreExact) {
  const CaptureRun run = runCaptured("triangle", {{0, 0, 0}, {10, 0, 0}, {5, 32, 32}});
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_EQ(run.output, "done\n");
  ASSERT_EQ(run.capture.error, "");
  ASSERT_EQ(run.capture.frames.size(), 3U);
  const std::vector<int> background{51, 102, 153, 255};
  for (const CapturedFrame& frame : run.capture.frames) {
    SCOPED_TRACE(frame.time);
    EXPECT_TRUE(frame.written);
    EXPECT_EQ(pixel(frame, 0, frame.height - 1), kRed)
        << "the lower left corner comes last in rows from the top";
    EXPECT_EQ(pixel(frame, frame.width - 1, frame.height - 1), background);
    EXPECT_EQ(frame.windowDraws, 1U);
    EXPECT_EQ(frame.windowClears, 2U);
    EXPECT_EQ(frame.boundFramebuffer, 0U);
    EXPECT_FALSE(frame.windowSrgb);
    EXPECT_GT(frame.seconds, 0);
  }
  const auto blueRows = [](const CapturedFrame& frame) {
    std::uint32_t rows = 0;
    while (rows < frame.height && pixel(frame, frame.width - 1, rows) == kBlue) ++rows;
    return rows;
  };
  EXPECT_EQ(run.capture.frames[0].width, 64U);
  EXPECT_EQ(run.capture.frames[0].height, 48U);
  EXPECT_EQ(blueRows(run.capture.frames[0]), 0U);
  EXPECT_EQ(blueRows(run.capture.frames[1]), 10U);
  EXPECT_EQ(run.capture.frames[2].width, 32U);
  EXPECT_EQ(run.capture.frames[2].height, 32U);
  EXPECT_EQ(blueRows(run.capture.frames[2]), 5U);
}

TEST(CaptureFrames, TriangleCoversTheDiagonalHalf) {
  const CaptureRun run = runCaptured("triangle", {{0, 32, 32}});
  ASSERT_EQ(run.capture.frames.size(), 1U);
  int red = 0;
  for (std::uint32_t y = 0; y < 32; ++y) {
    for (std::uint32_t x = 0; x < 32; ++x) red += pixel(run.capture.frames[0], x, y) == kRed;
  }
  // 496 pixels below the diagonal, and those on it that the fill rule gives to the triangle.
  EXPECT_GE(red, 496);
  EXPECT_LE(red, 528);
}

class CaptureLinked : public testing::TestWithParam<const char*> {};

TEST_P(CaptureLinked, DrawsAndIsHooked) {
  const CaptureRun run = runCaptured(GetParam(), {{0, 0, 0}, {1, 0, 0}});
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  ASSERT_EQ(run.capture.frames.size(), 2U);
  for (const CapturedFrame& frame : run.capture.frames) {
    EXPECT_EQ(pixel(frame, 0, 0), kGreen);
    EXPECT_EQ(pixel(frame, 7, 8), kWhite);
    EXPECT_EQ(pixel(frame, 8, 8), kGreen);
    EXPECT_EQ(frame.windowClears, 2U);
  }
}
INSTANTIATE_TEST_SUITE_P(Libraries, CaptureLinked, testing::Values("linked_gl", "linked_opengl"));

TEST(CaptureFrames, OfAProgramThatOpensLibGLItself) {
  const CaptureRun run = runCaptured("opened", {{0, 0, 0}});
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_EQ(run.output, "1 1\n") << "names that are no GL functions give null";
  ASSERT_EQ(run.capture.frames.size(), 1U);
  EXPECT_EQ(pixel(run.capture.frames[0], 3, 3), (std::vector<int>{255, 0, 255, 255}));
  EXPECT_EQ(run.capture.frames[0].windowClears, 1U) << "hooked on this way, too";
}

TEST(CaptureFrames, OfTheCompatibilityProfile) {
  const CaptureRun run = runCaptured("compatible", {{0, 0, 0}, {0, 0, 0}});
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  ASSERT_EQ(run.capture.frames.size(), 2U);
  EXPECT_THAT(run.capture.glVersion, testing::HasSubstr("Compatibility Profile"));
  const CapturedFrame& frame = run.capture.frames[1];
  EXPECT_EQ(pixel(frame, 8, 0), (std::vector<int>{255, 255, 0, 255}));
  EXPECT_EQ(pixel(frame, 7, 7), (std::vector<int>{0, 255, 255, 255}));
  EXPECT_EQ(pixel(frame, 7, 8), (std::vector<int>{0, 0, 0, 0}));
  EXPECT_EQ(frame.windowDraws, 2U);
  EXPECT_EQ(texts(run.capture, channel::MessageKind::glError), std::vector<std::string>{});
}

TEST(CaptureFrames, TakePlannedSizesAndTellThePrograms) {
  const CaptureRun run = runCaptured("resized", {{0, 24, 12}, {0, 24, 12}, {0, 8, 6}});
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_EQ(run.output, "framebuffer 24x12\nwindow 24x12\nframebuffer 8x6\nwindow 8x6\nclose\n");
  ASSERT_EQ(run.capture.frames.size(), 3U);
  for (const CapturedFrame& frame : run.capture.frames) {
    EXPECT_EQ(pixel(frame, frame.width - 1, 0), kRed) << frame.width;
  }
  EXPECT_EQ(run.capture.frames[2].width, 8U);
  EXPECT_EQ(run.capture.frames[2].height, 6U);
}

TEST(CaptureFrames, TakeTheSizeThatTheProgramAsksFor) {
  const CaptureRun run =
      runCaptured("resized", {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{"resize"}, {}});
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_EQ(run.output, "framebuffer 30x15\nwindow 30x15\nclose\n");
  ASSERT_EQ(run.capture.frames.size(), 3U);
  EXPECT_EQ(run.capture.frames[0].width, 20U);
  EXPECT_EQ(run.capture.frames[1].width, 30U);
  EXPECT_EQ(run.capture.frames[1].height, 15U);
  EXPECT_EQ(pixel(run.capture.frames[2], 29, 0), kRed);
}

TEST(CaptureFrames, KeepThePlannedSizeAgainstTheProgram) {
  const CaptureRun run = runCaptured("resized", {{0, 9, 9}, {0, 9, 9}}, {{"resize"}, {}});
  ASSERT_EQ(run.capture.frames.size(), 2U);
  EXPECT_EQ(run.capture.frames[1].width, 9U);
  EXPECT_THAT(texts(run.capture, channel::MessageKind::capture),
              testing::Contains("glfwSetWindowSize: the schedule decides on this frame's size"));
}

TEST(CaptureFrames, TooLargeForTheChannelAreReportedWithoutPixels) {
  const channel::Channel channel({{0, 0, 0}}, 100);
  const CaptureRun run = runWithDescriptor("triangle", channel.descriptor());
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  const channel::Capture capture = channel.read();
  ASSERT_EQ(capture.error, "");
  ASSERT_EQ(capture.frames.size(), 1U);
  EXPECT_FALSE(capture.frames[0].written);
  EXPECT_EQ(capture.frames[0].width, 64U);
  EXPECT_TRUE(capture.frames[0].pixels.empty());
}

TEST(CaptureFrames, ComeFromTheFirstVisibleWindow) {
  const CaptureRun run = runCaptured("two_windows", {{0, 0, 0}, {1, 0, 0}});
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  ASSERT_EQ(run.capture.frames.size(), 2U);
  for (const CapturedFrame& frame : run.capture.frames) {
    EXPECT_EQ(frame.width, 8U);
    EXPECT_EQ(pixel(frame, 4, 4), (std::vector<int>{255, 128, 0, 255})) << "the shared texture";
    EXPECT_EQ(frame.windowDraws, 1U) << "the blit";
    EXPECT_EQ(frame.windowClears, 0U) << "the other window's clear";
  }
  EXPECT_THAT(texts(run.capture, channel::MessageKind::capture),
              testing::Contains(testing::HasSubstr("several windows")));
  EXPECT_EQ(texts(run.capture, channel::MessageKind::glError), std::vector<std::string>{});
}

TEST(CaptureFrames, TellOfAFramebufferObjectLeftBound) {
  const CaptureRun run = runCaptured("framebuffer_left_bound", {{0, 0, 0}, {0, 0, 0}});
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_EQ(run.output, "bound 1\nbound 1\n") << "capturing leaves the binding alone";
  ASSERT_EQ(run.capture.frames.size(), 2U);
  const CapturedFrame& drawn = run.capture.frames[0];
  EXPECT_EQ(drawn.windowDraws, 2U);
  EXPECT_EQ(drawn.windowClears, 1U);
  EXPECT_NE(drawn.boundFramebuffer, 0U);
  EXPECT_EQ(pixel(drawn, 0, 0), (std::vector<int>{255, 255, 0, 255}));
  const CapturedFrame& missed = run.capture.frames[1];
  EXPECT_EQ(missed.windowDraws, 0U);
  EXPECT_EQ(missed.windowClears, 0U);
  EXPECT_NE(missed.boundFramebuffer, 0U);
}

TEST(CaptureFrames, TellOfSrgbEncodingOnTheLinearWindow) {
  const CaptureRun run = runCaptured("encodes_srgb", {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
  ASSERT_EQ(run.capture.frames.size(), 3U);
  EXPECT_FALSE(run.capture.frames[0].windowSrgb);
  EXPECT_TRUE(run.capture.frames[1].windowSrgb);
  EXPECT_FALSE(run.capture.frames[2].windowSrgb);
  EXPECT_THAT(pixel(run.capture.frames[1], 0, 0), ElementsAre(128, 128, 128, 255));
  EXPECT_THAT(texts(run.capture, channel::MessageKind::capture),
              testing::Contains(testing::HasSubstr("GL_FRAMEBUFFER_SRGB")));
}

TEST(CaptureFrames, AreBitIdenticalInTwoRuns) {
  const std::vector<channel::PlannedFrame> plan{{0, 0, 0}, {0.4, 320, 200}, {1.7, 0, 0}};
  const CaptureRun first = runCaptured("lit_scene", plan);
  const CaptureRun second = runCaptured("lit_scene", plan);
  ASSERT_EQ(first.capture.frames.size(), 3U);
  ASSERT_EQ(second.capture.frames.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(first.capture.frames[i].pixels == second.capture.frames[i].pixels) << "frame " << i;
  }
  EXPECT_FALSE(first.capture.frames[0].pixels == first.capture.frames[2].pixels);
  EXPECT_GT(first.capture.shaderSeconds, 0);
  EXPECT_GT(first.capture.contextSeconds, 0);
}

} // namespace
} // namespace ggrade::test
