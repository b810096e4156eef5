// Programs with the framework's main, run as the grader runs them.

#include "capture_run.hpp"
#include "framework_temporary_folder.hpp"

#include <gmock/gmock.h>

namespace {

using ggrade::test::CaptureRun;
using ggrade::test::pixel;
using ggrade::test::runCaptured;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

CaptureRun run(const std::vector<std::string>& arguments,
               const std::vector<ggrade::channel::PlannedFrame>& frames = {{0, 0, 0}}) {
  return runCaptured("loop", frames, {arguments, {}});
}

TEST(FrameworkRun, DrawsFramesUntilTheWindowCloses) {
  const CaptureRun result = run({}, {{0, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.errors, "");
  EXPECT_EQ(result.output, "frame 0: 40x20 aspect 2.00 viewport 40x20\n"
                           "frame 1: 40x20 aspect 2.00 viewport 40x20\n");
  ASSERT_EQ(result.capture.frames.size(), 2u);
  EXPECT_THAT(pixel(result.capture.frames[0], 1, 1), ElementsAre(0, 0, 0, 255));
  EXPECT_THAT(pixel(result.capture.frames[1], 1, 1), ElementsAre(255, 0, 0, 255));
  EXPECT_THAT(pixel(result.capture.frames[1], 20, 10), ElementsAre(0, 255, 0, 255));
  EXPECT_FALSE(result.capture.endedByCapture);
}

TEST(FrameworkRun, FollowsANewSize) {
  const CaptureRun result = run({}, {{0, 0, 0}, {0, 30, 60}});
  EXPECT_THAT(result.output, HasSubstr("frame 1: 30x60 aspect 0.50 viewport 30x60\n"));
}

TEST(FrameworkRun, SizeOnTheCommandLineWins) {
  EXPECT_THAT(run({"--size", "64x16"}).output, StartsWith("frame 0: 64x16 aspect 4.00"));
}

TEST(FrameworkRun, TakesItsFilesFromItsOwnFolder) {
  // The scene is named by hand and lies elsewhere; declarations and shaders don't.
  const TemporaryFolder folder;
  const std::string scene = folder.write("other.json", R"({ "size": [8, 8],
    "camera": { "position": [0, 0, 1], "target": [0, 0, 0], "fov": 1, "near": 0.1, "far": 10 },
    "light": { "position": [0, 1, 0] } })");
  EXPECT_THAT(run({"--scene", scene}).output, StartsWith("frame 0: 8x8"));
}

TEST(FrameworkRun, ASceneErrorEndsWithTwo) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("bad.json", "{\n \"sise\": 1 }");
  const CaptureRun result = run({"--scene", scene});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_EQ(result.errors,
            "capture_loop: bad.json:2: sise: is not a key of this scene; did you mean size?\n");
  EXPECT_FALSE(result.capture.contextMade);
}

TEST(FrameworkRun, AShaderErrorEndsWithThree) {
  const CaptureRun result = run({"--mesh", "bad_shader"});
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_THAT(result.errors, StartsWith("capture_loop: bad.frag:4:"));
  EXPECT_THAT(result.errors, HasSubstr("\n  oColor = vec4(0, 1, 0);\n"));
}

TEST(FrameworkRun, OtherExceptionsEndWithOne) {
  CaptureRun result = run({"--mesh", "throw"});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_EQ(result.errors, "capture_loop: the framebuffer is not complete\n");
  result = run({"--mesh", "throw_int"});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_EQ(result.errors, "capture_loop: an exception of an unknown type\n");
}

TEST(FrameworkRun, WrongArgumentsEndWithFiveAndTheUsage) {
  const CaptureRun result = run({"--seen"});
  EXPECT_EQ(result.exitCode, 5);
  EXPECT_THAT(result.errors, StartsWith("capture_loop: unknown argument \"--seen\"\nusage: "));
}

TEST(FrameworkRun, HelpIsPrinted) {
  const CaptureRun result = run({"--help"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.output, StartsWith("usage: capture_loop [--part ID | --scene FILE]"));
}

TEST(FrameworkRun, AClosedWindowEndsTheLoop) {
  const CaptureRun result = run({"--mesh", "close"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.output, "");
}

} // namespace
