// GL errors are collected with the call's name whatever the program does with its own debug output,
// and the program sees of it what it would see elsewhere.

#include "capture_run.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace ggrade::test {
namespace {

using channel::MessageKind;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr char kHeard[] = "heard 824c GL_INVALID_ENUM in glEnable(0xdead) user\n";
constexpr char kNamed[] = "GL_INVALID_ENUM in glEnable(0xdead)";
constexpr char kUnnamed[] =
    "GL_INVALID_ENUM in a call of this frame (the program has switched debug messages off)";

CaptureRun runErrors(const char* how) {
  return runCaptured("errors", {{0, 0, 0}, {0, 0, 0}}, {{how}, {}});
}

TEST(CaptureErrors, AreNamedAndLeftForGetError) {
  const CaptureRun run = runErrors("");
  EXPECT_EQ(run.output, "debug 0 0 0\ncallback 0\nerror 500 then 0\nerror 500 then 0\n");
  ASSERT_EQ(run.capture.messages.size(), 1U);
  EXPECT_EQ(run.capture.messages[0].kind, MessageKind::glError);
  EXPECT_EQ(run.capture.messages[0].text, kNamed);
  EXPECT_EQ(run.capture.messages[0].count, 2U);
  EXPECT_EQ(run.capture.messages[0].frame, 0U);
}

TEST(CaptureErrors, ReachTheProgramsOwnCallback) {
  const CaptureRun run = runErrors("callback");
  EXPECT_EQ(run.output, std::string("debug 0 0 0\ncallback 1\n") + kHeard + "error 500 then 0\n" +
                            kHeard + "error 500 then 0\n");
  EXPECT_THAT(texts(run.capture, MessageKind::glError), ElementsAre(kNamed));
}

TEST(CaptureErrors, DontReachACallbackThatIsSwitchedOff) {
  const CaptureRun run = runErrors("disabled");
  EXPECT_EQ(run.output, "debug 0 0 0\ncallback 1\nerror 500 then 0\nerror 500 then 0\n");
  EXPECT_THAT(texts(run.capture, MessageKind::glError), ElementsAre(kNamed));
}

TEST(CaptureErrors, ReachTheCallbackOfADebugContext) {
  const CaptureRun run = runErrors("context");
  EXPECT_THAT(run.output, testing::StartsWith(std::string("debug 1 1 1\ncallback 1\n") + kHeard));
}

TEST(CaptureErrors, FillTheProgramsLogWhenItHasNoCallback) {
  const CaptureRun run = runErrors("log");
  EXPECT_THAT(run.output, testing::EndsWith("log 1 824c GL_INVALID_ENUM in glEnable(0xdead)\n"));
}

TEST(CaptureErrors, AreFoundWhenMessagesAreSilenced) {
  const CaptureRun run = runErrors("silenced");
  EXPECT_EQ(run.output, "debug 0 0 0\ncallback 0\nerror 500 then 0\nerror 500 then 0\n");
  EXPECT_THAT(texts(run.capture, MessageKind::glError), ElementsAre(kUnnamed));
}

TEST(CaptureErrors, AreFoundWhenSilencedAndReadByTheProgram) {
  const CaptureRun run = runErrors("eaten");
  EXPECT_EQ(run.output, "debug 0 0 0\ncallback 0\nerror 0 then 0\nerror 0 then 0\n");
  EXPECT_THAT(texts(run.capture, MessageKind::glError), ElementsAre(kUnnamed));
}

TEST(CaptureMissing, IsSaidOnceAndDoesNothing) {
  const CaptureRun run =
      runCaptured("calls_missing", {{0, 0, 0}}, {{}, {{"GG_CAPTURE_VERBOSE", "1"}}});
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  const char* const said =
      "glTbufferMask3DFX does not exist offscreen; the call did nothing and returned 0";
  const std::vector<std::string> messages = texts(run.capture, MessageKind::capture);
  EXPECT_THAT(messages, testing::Contains(HasSubstr("glIsObjectBufferATI")));
  EXPECT_THAT(messages, testing::Contains(HasSubstr("glXIsDirect")));
  const auto message =
      std::find_if(run.capture.messages.begin(), run.capture.messages.end(),
                   [&](const channel::CapturedMessage& each) { return each.text == said; });
  ASSERT_NE(message, run.capture.messages.end());
  EXPECT_EQ(message->count, 3U) << "twice linked, once loaded";
  const std::size_t first = run.errors.find(said);
  ASSERT_NE(first, std::string::npos) << run.errors;
  EXPECT_EQ(run.errors.find(said, first + 1), std::string::npos) << "said once: " << run.errors;
}

TEST(CaptureMeaningless, IsSaidOnceOnStderrAndCountedInTheChannel) {
  const CaptureRun quiet = runCaptured("meaningless", {{0, 0, 0}});
  ASSERT_EQ(quiet.exitCode, 0);
  EXPECT_EQ(quiet.errors, "");
  const CaptureRun run =
      runCaptured("meaningless", {{0, 0, 0}}, {{}, {{"GG_CAPTURE_VERBOSE", "1"}}});
  const std::pair<const char*, std::uint32_t> expected[] = {
      {"GLFW_SAMPLES=4: the window has one sample a pixel offscreen", 1},
      {"GLFW_SRGB_CAPABLE: the window is linear offscreen", 1},
      {"GLFW_STEREO: the window has no right-eye buffer offscreen", 1},
      {"glfwSwapInterval: frames follow the schedule offscreen", 2},
      {"iconifying changes nothing offscreen; frames go on", 2},
      {"maximizing keeps the window's size offscreen", 2},
      {"the window's opacity changes nothing offscreen", 2},
      {"the monitor's gamma changes nothing offscreen", 2},
      {"full screen: the window keeps the size that was asked for", 2},
  };
  std::string errors;
  for (std::size_t i = 0; i < std::size(expected); ++i) {
    const auto& [text, count] = expected[i];
    errors += std::string("ggrade capture: ") + text + "\n";
    ASSERT_LT(i, run.capture.messages.size());
    EXPECT_EQ(run.capture.messages[i].text, text);
    EXPECT_EQ(run.capture.messages[i].count, count) << text;
    EXPECT_EQ(run.capture.messages[i].kind, MessageKind::capture);
  }
  EXPECT_EQ(run.capture.messages.size(), std::size(expected));
  EXPECT_EQ(run.errors, errors);
}

TEST(CaptureEntries, KeepAllArgumentsInTheirFirstCall) {
  const CaptureRun run = runCaptured("calls_missing", {{0, 0, 0}});
  // glOrtho(-2, 3, -5, 7, -11, 13): 2/5, 2/12, -2/24, -1/5, -2/12, -2/24
  EXPECT_EQ(run.output,
            "0 0\n1 1.4\n0.400000\n0.166667\n-0.083333\n-0.200000\n-0.166667\n-0.083333\n");
}

} // namespace
} // namespace ggrade::test
