// How a captured program's run goes: its clock, its end, and what the library refuses.

#include "capture_run.hpp"

#include <gmock/gmock.h>

#include <sys/mman.h>
#include <unistd.h>

namespace ggrade::test {
namespace {

using channel::MessageKind;

TEST(CaptureClock, ShowsEachFramesTimeAndCreeps) {
  const CaptureRun run = runCaptured("clock", {{0.5, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(run.output, "0.500000 0.500001 500002000\n2.000000 2.000001 2000002000\n"
                        "1.000000 1.000001 1000002000\n1.000000 1.000001 1000002000\n");
}

TEST(CaptureClock, ResetBeforeTheLoopShowsThePlannedTimes) {
  const CaptureRun run = runCaptured("clock", {{0.5, 0, 0}, {2, 0, 0}}, {{"reset"}, {}});
  EXPECT_EQ(run.output, "0.500001 0.500002 500003000\n2.000000 2.000001 2000002000\n");
}

TEST(CaptureClock, ResetLaterGoesOnByTheScheduledDifferences) {
  const CaptureRun run =
      runCaptured("clock", {{0.5, 0, 0}, {2, 0, 0}, {3, 0, 0}, {7, 0, 0}}, {{"again"}, {}});
  EXPECT_EQ(run.output, "0.500000 0.500001 500002000\n2.000000 2.000001 2000002000\n"
                        "100.000000 100.000001 3000002000\n104.000000 104.000001 7000002000\n");
}

TEST(CaptureClock, LetsAProgramThatWaitsForItMoveOn) {
  const CaptureRun run = runCaptured("waits_for_time", {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_EQ(run.output, "done\n");
  EXPECT_EQ(run.capture.frames.size(), 3U);
  EXPECT_FALSE(run.capture.endedByCapture);
}

class CaptureEnd : public testing::TestWithParam<const char*> {};

TEST_P(CaptureEnd, ComesToAProgramThatIgnoresCloseWithItsOutput) {
  const CaptureRun run = runCaptured("ignores_close", {{0, 0, 0}, {1, 0, 0}}, {{GetParam()}, {}});
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_EQ(run.signal, 0);
  EXPECT_THAT(run.output, testing::HasSubstr("printed"));
  EXPECT_THAT(run.output, testing::HasSubstr("streamed"));
  EXPECT_TRUE(run.capture.endedByCapture);
  EXPECT_EQ(run.capture.frames.size(), 2U);
  EXPECT_EQ(run.capture.error, "");
}
INSTANTIATE_TEST_SUITE_P(Ways, CaptureEnd, testing::Values("swap", "poll", "wait"));

TEST(CaptureEnd, AfterNoSwapLeavesNoFrames) {
  const CaptureRun run = runCaptured("never_swaps", {{0, 0, 0}});
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_TRUE(run.capture.started);
  EXPECT_TRUE(run.capture.contextMade);
  EXPECT_THAT(run.capture.glVersion, testing::HasSubstr("Core Profile"));
  EXPECT_THAT(run.capture.glRenderer, testing::HasSubstr("llvmpipe"));
  EXPECT_TRUE(run.capture.frames.empty());
}

TEST(CaptureEnd, WithoutAChannelComesAfterAGivenNumberOfFrames) {
  const CaptureRun run = runWithDescriptor("clock", -1, {{}, {{"GG_CAPTURE_FRAMES", "3"}}});
  EXPECT_EQ(run.output, "0.000000 0.000001 2000\n0.016667 0.016668 16668667\n"
                        "0.033333 0.033334 33335333\n");
}

TEST(CaptureThreads, MayDrawWhileTheMainThreadWaits) {
  const CaptureRun run = runCaptured("threaded", {{0, 0, 0}, {0, 4, 6}, {0, 4, 6}});
  EXPECT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_EQ(run.output, "4x6 1\n") << "callbacks come on the main thread";
  ASSERT_EQ(run.capture.frames.size(), 3U);
  EXPECT_EQ(run.capture.frames[2].height, 6U);
  EXPECT_EQ(pixel(run.capture.frames[2], 3, 5), (std::vector<int>{0, 255, 0, 255}));
  EXPECT_FALSE(run.capture.endedByCapture);
}

TEST(CaptureSanitizer, LoadedFirstWorks) {
  const CaptureRun run =
      runCaptured("lit_scene", {{0, 0, 0}},
                  {{}, {{"LD_PRELOAD", GGRADE_LIBASAN}, {"ASAN_OPTIONS", "detect_leaks=0"}}});
  EXPECT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_EQ(run.errors, "");
  EXPECT_EQ(run.capture.frames.size(), 1U);
}

/// Runs a program on a channel whose plan says what it should not.
CaptureRun runBadPlan(const channel::Plan& plan, std::size_t bytes) {
  const int file = memfd_create("bad plan", MFD_CLOEXEC);
  EXPECT_EQ(pwrite(file, &plan, sizeof(plan), 0), static_cast<ssize_t>(sizeof(plan)));
  EXPECT_EQ(ftruncate(file, static_cast<off_t>(bytes)), 0);
  CaptureRun run = runWithDescriptor("triangle", file);
  close(file);
  return run;
}

channel::Plan goodPlan() {
  return channel::Channel({{0, 0, 0}}).plan();
}

TEST(CapturePlan, IsRefusedWithAReason) {
  struct Case {
    const char* reason;
    void (*spoil)(channel::Plan&);
  };
  const Case cases[] = {
      {"not a capture channel", [](channel::Plan& plan) { plan.magic = 1; }},
      {"another version of the capture channel", [](channel::Plan& plan) { plan.version = 99; }},
      {"frame count out of range", [](channel::Plan& plan) { plan.frameCount = 0; }},
      {"frame count out of range", [](channel::Plan& plan) { plan.frameCount = 65; }},
      {"slot size out of range", [](channel::Plan& plan) { plan.slotBytes = ~std::uint64_t{0}; }},
      {"frame time out of range", [](channel::Plan& plan) { plan.frames[0].time = -1; }},
      {"frame size out of range", [](channel::Plan& plan) { plan.frames[0].width = 16385; }},
      {"number of replacements out of range",
       [](channel::Plan& plan) { plan.replacementCount = 33, plan.trace.passes = 1; }},
      {"number of replacements out of range",
       [](channel::Plan& plan) { plan.replacementCount = 1; }},
      {"attachment to replace out of range",
       [](channel::Plan& plan) {
         plan.trace.passes = plan.replacementCount = 1;
         plan.replacements[0].attachment = 9;
       }},
      {"type of a replacement out of range",
       [](channel::Plan& plan) {
         plan.trace.passes = plan.replacementCount = 1;
         plan.replacements[0].attachment = trace::kDepth;
       }},
      {"size of a replacement out of range",
       [](channel::Plan& plan) {
         plan.trace.passes = plan.replacementCount = 1;
         plan.replacements[0] = {0, 0, 1, 0, 2, 2, 0, 15};
       }},
      {"place of a replacement out of range",
       [](channel::Plan& plan) {
         plan.trace.passes = plan.replacementCount = 1;
         plan.replacementBytes = 16;
         plan.replacements[0] = {0, 0, 1, 0, 2, 2, 16, 16};
       }},
      {"the file is smaller than its plan", [](channel::Plan& plan) { plan.frameCount = 64; }},
  };
  for (const Case& bad : cases) {
    channel::Plan plan = goodPlan();
    bad.spoil(plan);
    const CaptureRun run = runBadPlan(plan, channel::totalBytes(goodPlan()));
    EXPECT_EQ(run.exitCode, channel::kRefusedExit) << bad.reason;
    EXPECT_EQ(run.errors, std::string("ggrade capture: GG_CAPTURE_FD: ") + bad.reason + "\n");
  }
}

TEST(CapturePlan, IsRefusedWhenThereIsNone) {
  const CaptureRun closed = runWithDescriptor("triangle", -1, {{}, {{"GG_CAPTURE_FD", "77"}}});
  EXPECT_EQ(closed.exitCode, channel::kRefusedExit);
  EXPECT_EQ(closed.errors, "ggrade capture: GG_CAPTURE_FD: cannot read the plan\n");
  const CaptureRun word = runWithDescriptor("triangle", -1, {{}, {{"GG_CAPTURE_FD", "five"}}});
  EXPECT_EQ(word.exitCode, channel::kRefusedExit);
  EXPECT_EQ(word.errors, "ggrade capture: GG_CAPTURE_FD: not a descriptor number\n");
}

} // namespace
} // namespace ggrade::test
