// GLFW's documented contract on the capture library: errors, contexts, time, monitors, input.

#include <gmock/gmock.h>

#include <GLFW/glfw3.h>

#include <cmath>
#include <thread>

// glfw3native.h and the Vulkan part of glfw3.h need headers that aren't here.
extern "C" {
void* glfwGetX11Display();
void* glfwGetOSMesaContext(GLFWwindow*);
int glfwGetOSMesaColorBuffer(GLFWwindow*, int*, int*, int*, void**);
int glfwCreateWindowSurface(void*, GLFWwindow*, const void*, std::uint64_t*);
const char** glfwGetRequiredInstanceExtensions(std::uint32_t*);
}

// OSMesa keeps some memory of contexts that are gone, which is not what these tests look for.
extern "C" const char* __asan_default_options() { // NOLINT(bugprone-reserved-identifier)
  return "detect_leaks=0";
}

namespace {

int takeError() {
  return glfwGetError(nullptr);
}

class CaptureGlfw : public testing::Test {
protected:
  void SetUp() override { ASSERT_TRUE(glfwInit()); }
  void TearDown() override { glfwTerminate(); }
};

GLFWwindow* open(GLFWwindow* share = nullptr) {
  return glfwCreateWindow(16, 8, "capture", nullptr, share);
}

TEST(CaptureGlfwInit, IsWantedByAllElse) {
  EXPECT_EQ(glfwGetTime(), 0.0);
  EXPECT_EQ(takeError(), GLFW_NOT_INITIALIZED);
  EXPECT_EQ(open(), nullptr);
  EXPECT_EQ(takeError(), GLFW_NOT_INITIALIZED);
  EXPECT_EQ(glfwGetPrimaryMonitor(), nullptr);
  EXPECT_EQ(takeError(), GLFW_NOT_INITIALIZED);
  glfwPollEvents();
  EXPECT_EQ(takeError(), GLFW_NOT_INITIALIZED);
  EXPECT_EQ(takeError(), GLFW_NO_ERROR) << "reading an error clears it";
}

TEST(CaptureGlfwInit, TellsItsVersionWithoutBeingCalled) {
  int major = 0;
  int minor = 0;
  int revision = 0;
  glfwGetVersion(&major, &minor, &revision);
  EXPECT_EQ(major, 3);
  EXPECT_EQ(minor, 3);
  EXPECT_EQ(revision, 8);
  EXPECT_THAT(glfwGetVersionString(), testing::StartsWith("3.3.8"));
}

TEST(CaptureGlfwInit, MayBeUndoneAndRepeated) {
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(glfwInit());
    ASSERT_TRUE(glfwInit());
    GLFWwindow* const window = open();
    ASSERT_NE(window, nullptr);
    glfwMakeContextCurrent(window);
    glfwSwapBuffers(window);
    glfwTerminate();
    glfwTerminate();
  }
}

TEST_F(CaptureGlfw, ErrorsReachTheCallbackOfAnyThread) {
  static int code = 0;
  static std::string text;
  glfwSetErrorCallback([](int error, const char* description) {
    code = error;
    text = description;
  });
  glfwWindowHint(0x12345, 1);
  EXPECT_EQ(code, GLFW_INVALID_ENUM);
  EXPECT_EQ(text, "Invalid window hint 0x00012345");
  std::thread([] {
    EXPECT_EQ(takeError(), GLFW_NO_ERROR) << "errors belong to their thread";
  }).join();
  const char* description = nullptr;
  EXPECT_EQ(glfwGetError(&description), GLFW_INVALID_ENUM);
  EXPECT_STREQ(description, "Invalid window hint 0x00012345");
  EXPECT_EQ(glfwGetError(&description), GLFW_NO_ERROR);
  EXPECT_EQ(description, nullptr);
  EXPECT_NE(glfwSetErrorCallback(nullptr), nullptr) << "the setter returns the one before";
}

struct RefusedContext {
  std::vector<std::pair<int, int>> hints;
  int error;
};

TEST_F(CaptureGlfw, ContextsThatCannotBeAreRefused) {
  const RefusedContext refused[] = {
      {{{GLFW_CLIENT_API, GLFW_OPENGL_ES_API}}, GLFW_API_UNAVAILABLE},
      {{{GLFW_CLIENT_API, 5}}, GLFW_INVALID_ENUM},
      {{{GLFW_CONTEXT_CREATION_API, 5}}, GLFW_INVALID_ENUM},
      {{{GLFW_CONTEXT_VERSION_MAJOR, 3}, {GLFW_CONTEXT_VERSION_MINOR, 4}}, GLFW_INVALID_VALUE},
      {{{GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE}}, GLFW_INVALID_VALUE},
      {{{GLFW_CONTEXT_VERSION_MAJOR, 4}, {GLFW_OPENGL_PROFILE, 5}}, GLFW_INVALID_ENUM},
      {{{GLFW_OPENGL_FORWARD_COMPAT, 1}}, GLFW_INVALID_VALUE},
      {{{GLFW_CONTEXT_ROBUSTNESS, 5}}, GLFW_INVALID_ENUM},
      {{{GLFW_CONTEXT_RELEASE_BEHAVIOR, 5}}, GLFW_INVALID_ENUM},
      {{{GLFW_CONTEXT_VERSION_MAJOR, 4}, {GLFW_CONTEXT_VERSION_MINOR, 9}},
       GLFW_VERSION_UNAVAILABLE},
  };
  for (const RefusedContext& bad : refused) {
    glfwDefaultWindowHints();
    for (const auto& [hint, value] : bad.hints) glfwWindowHint(hint, value);
    EXPECT_EQ(open(), nullptr);
    EXPECT_EQ(takeError(), bad.error) << bad.hints.back().first;
  }
  glfwDefaultWindowHints();
  EXPECT_EQ(glfwCreateWindow(0, 8, "", nullptr, nullptr), nullptr);
  EXPECT_EQ(takeError(), GLFW_INVALID_VALUE);
}

TEST_F(CaptureGlfw, ContextsAreDescribedByWhatTheyAre) {
  GLFWwindow* const compatible = open();
  EXPECT_EQ(glfwGetWindowAttrib(compatible, GLFW_CLIENT_API), GLFW_OPENGL_API);
  EXPECT_EQ(glfwGetWindowAttrib(compatible, GLFW_OPENGL_PROFILE), GLFW_OPENGL_COMPAT_PROFILE);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
  GLFWwindow* const core = open();
  EXPECT_EQ(glfwGetWindowAttrib(core, GLFW_OPENGL_PROFILE), GLFW_OPENGL_CORE_PROFILE)
      << "what GLX gives from 3.2 on";
  EXPECT_GE(glfwGetWindowAttrib(core, GLFW_CONTEXT_VERSION_MAJOR), 3);
  EXPECT_EQ(glfwGetWindowAttrib(core, GLFW_OPENGL_DEBUG_CONTEXT), GLFW_TRUE);
}

TEST_F(CaptureGlfw, WindowsWithoutContextHaveNoneToUse) {
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  GLFWwindow* const window = open();
  ASSERT_NE(window, nullptr);
  glfwMakeContextCurrent(window);
  EXPECT_EQ(takeError(), GLFW_NO_WINDOW_CONTEXT);
  glfwSwapBuffers(window);
  EXPECT_EQ(takeError(), GLFW_NO_WINDOW_CONTEXT);
  EXPECT_EQ(glfwGetOSMesaContext(window), nullptr);
  EXPECT_EQ(takeError(), GLFW_NO_WINDOW_CONTEXT);
  glfwDefaultWindowHints();
  EXPECT_EQ(open(window), nullptr) << "nothing to share";
  EXPECT_EQ(takeError(), GLFW_NO_WINDOW_CONTEXT);
}

TEST_F(CaptureGlfw, FunctionsOfTheContextWantOne) {
  EXPECT_EQ(glfwGetProcAddress("glClear"), nullptr);
  EXPECT_EQ(takeError(), GLFW_NO_CURRENT_CONTEXT);
  EXPECT_FALSE(glfwExtensionSupported("GL_KHR_debug"));
  EXPECT_EQ(takeError(), GLFW_NO_CURRENT_CONTEXT);
  glfwSwapInterval(1);
  EXPECT_EQ(takeError(), GLFW_NO_CURRENT_CONTEXT);
  GLFWwindow* const window = open();
  glfwMakeContextCurrent(window);
  EXPECT_EQ(glfwGetCurrentContext(), window);
  EXPECT_NE(glfwGetProcAddress("glClear"), nullptr);
  EXPECT_NE(glfwGetProcAddress("glGetTextureImage"), nullptr);
  EXPECT_EQ(glfwGetProcAddress("glNoSuchFunction"), nullptr);
  EXPECT_EQ(glfwGetProcAddress("printf"), nullptr);
  EXPECT_TRUE(glfwExtensionSupported("GL_KHR_debug"));
  EXPECT_FALSE(glfwExtensionSupported("GL_KHR_debu"));
  EXPECT_EQ(takeError(), GLFW_NO_ERROR);
  glfwExtensionSupported("");
  EXPECT_EQ(takeError(), GLFW_INVALID_VALUE);
  glfwDestroyWindow(window);
  EXPECT_EQ(glfwGetCurrentContext(), nullptr) << "a destroyed window's context is current no more";
}

TEST_F(CaptureGlfw, ContextsBelongToOneThreadAtATime) {
  GLFWwindow* const first = open();
  GLFWwindow* const second = open(first);
  glfwMakeContextCurrent(first);
  std::thread([&] {
    EXPECT_EQ(glfwGetCurrentContext(), nullptr);
    glfwMakeContextCurrent(first);
    EXPECT_EQ(takeError(), GLFW_PLATFORM_ERROR) << "it is current elsewhere";
    glfwMakeContextCurrent(second);
    EXPECT_EQ(glfwGetCurrentContext(), second);
    glfwMakeContextCurrent(nullptr);
  }).join();
  EXPECT_EQ(glfwGetCurrentContext(), first);
  glfwMakeContextCurrent(second);
  EXPECT_EQ(glfwGetCurrentContext(), second);
  EXPECT_EQ(takeError(), GLFW_NO_ERROR);
}

TEST_F(CaptureGlfw, TheBufferIsOSMesas) {
  GLFWwindow* const window = open();
  if (!glfwGetOSMesaContext(window)) {
    EXPECT_EQ(takeError(), GLFW_NO_WINDOW_CONTEXT);
    GTEST_SKIP() << "drawn by EGL";
  }
  glfwMakeContextCurrent(window);
  int width = 0;
  int height = 0;
  int format = 0;
  void* buffer = nullptr;
  EXPECT_TRUE(glfwGetOSMesaColorBuffer(window, &width, &height, &format, &buffer));
  EXPECT_EQ(width, 16);
  EXPECT_EQ(height, 8);
  EXPECT_EQ(format, GL_RGBA);
  EXPECT_NE(buffer, nullptr);
  EXPECT_EQ(glfwGetX11Display(), nullptr);
}

TEST_F(CaptureGlfw, TheWindowIsDoubleBuffered) {
  glfwMakeContextCurrent(open());
  GLboolean doubleBuffer = GL_FALSE;
  glGetBooleanv(GL_DOUBLEBUFFER, &doubleBuffer);
  EXPECT_TRUE(doubleBuffer);
  GLint buffer = 0;
  glGetIntegerv(GL_DRAW_BUFFER, &buffer);
  EXPECT_EQ(buffer, GL_BACK);
  glGetIntegerv(GL_DEPTH_BITS, &buffer);
  EXPECT_EQ(buffer, 24);
  glGetIntegerv(GL_STENCIL_BITS, &buffer);
  EXPECT_EQ(buffer, 8);
}

TEST_F(CaptureGlfw, DepthAndStencilFollowTheHints) {
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwMakeContextCurrent(open());
  GLint bits = -1;
  glGetIntegerv(GL_DEPTH_BITS, &bits);
  EXPECT_EQ(bits, 0);
  glGetIntegerv(GL_STENCIL_BITS, &bits);
  EXPECT_EQ(bits, 0);
}

TEST_F(CaptureGlfw, TimeCanBeSet) {
  glfwSetTime(3.5);
  EXPECT_EQ(glfwGetTime(), 3.5);
  EXPECT_NEAR(glfwGetTime(), 3.500001, 1e-9);
  for (const double bad : {-1.0, std::nan(""), 1e300}) {
    glfwSetTime(bad);
    EXPECT_EQ(takeError(), GLFW_INVALID_VALUE);
  }
  EXPECT_NEAR(glfwGetTime(), 3.500002, 1e-9);
  EXPECT_EQ(glfwGetTimerFrequency(), 1'000'000'000U);
  const std::uint64_t before = glfwGetTimerValue();
  EXPECT_EQ(glfwGetTimerValue() - before, 1000U);
}

TEST_F(CaptureGlfw, ThereIsOneMonitor) {
  int count = 0;
  GLFWmonitor** const monitors = glfwGetMonitors(&count);
  ASSERT_EQ(count, 1);
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  EXPECT_EQ(monitors[0], monitor);
  const GLFWvidmode* const mode = glfwGetVideoMode(monitor);
  EXPECT_EQ(mode->width, 1920);
  EXPECT_EQ(mode->height, 1080);
  EXPECT_EQ(mode->refreshRate, 60);
  EXPECT_EQ(glfwGetVideoModes(monitor, &count), mode);
  EXPECT_EQ(count, 1);
  int x = -1;
  int y = -1;
  int width = 0;
  int height = 0;
  glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
  EXPECT_EQ(width, 1920);
  EXPECT_EQ(height, 1080);
  glfwGetMonitorPhysicalSize(monitor, &width, &height);
  EXPECT_EQ(width, 508);
  float scale = 0;
  glfwGetMonitorContentScale(monitor, &scale, nullptr);
  EXPECT_EQ(scale, 1.0F);
  EXPECT_STREQ(glfwGetMonitorName(monitor), "Offscreen");
}

TEST_F(CaptureGlfw, GammaIsKept) {
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  EXPECT_EQ(glfwGetGammaRamp(monitor)->size, 256U);
  EXPECT_EQ(glfwGetGammaRamp(monitor)->green[255], 65535);
  EXPECT_EQ(glfwGetGammaRamp(monitor)->green[51], 13107);
  glfwSetGamma(monitor, 2);
  EXPECT_EQ(glfwGetGammaRamp(monitor)->red[64], 32832);
  glfwSetGamma(monitor, -1);
  EXPECT_EQ(takeError(), GLFW_INVALID_VALUE);
  unsigned short values[] = {1, 2};
  const GLFWgammaramp ramp{values, values, values, 2};
  glfwSetGammaRamp(monitor, &ramp);
  EXPECT_EQ(glfwGetGammaRamp(monitor)->size, 2U);
  EXPECT_EQ(glfwGetGammaRamp(monitor)->blue[1], 2);
}

TEST_F(CaptureGlfw, NobodyTouchesKeyboardOrMouse) {
  GLFWwindow* const window = open();
  EXPECT_EQ(glfwGetKey(window, GLFW_KEY_ESCAPE), GLFW_RELEASE);
  EXPECT_EQ(glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT), GLFW_RELEASE);
  EXPECT_EQ(takeError(), GLFW_NO_ERROR);
  glfwGetKey(window, 9999);
  EXPECT_EQ(takeError(), GLFW_INVALID_ENUM);
  glfwGetMouseButton(window, 8);
  EXPECT_EQ(takeError(), GLFW_INVALID_ENUM);
  glfwSetCursorPos(window, 3, 4);
  double x = 0;
  double y = 0;
  glfwGetCursorPos(window, &x, &y);
  EXPECT_EQ(x, 3.0);
  EXPECT_EQ(y, 4.0);
  glfwSetCursorPos(window, std::nan(""), 0);
  EXPECT_EQ(takeError(), GLFW_INVALID_VALUE);
  EXPECT_FALSE(glfwRawMouseMotionSupported());
  EXPECT_STREQ(glfwGetKeyName(GLFW_KEY_A, 0), "a");
  EXPECT_STREQ(glfwGetKeyName(GLFW_KEY_KP_7, 0), "7");
  EXPECT_EQ(glfwGetKeyName(GLFW_KEY_SPACE, 0), nullptr);
  EXPECT_STREQ(glfwGetKeyName(GLFW_KEY_UNKNOWN, glfwGetKeyScancode(GLFW_KEY_MINUS)), "-");
}

TEST_F(CaptureGlfw, InputModesAreKept) {
  GLFWwindow* const window = open();
  EXPECT_EQ(glfwGetInputMode(window, GLFW_CURSOR), GLFW_CURSOR_NORMAL);
  glfwSetInputMode(window, GLFW_CURSOR, GLFW_CURSOR_DISABLED);
  EXPECT_EQ(glfwGetInputMode(window, GLFW_CURSOR), GLFW_CURSOR_DISABLED);
  glfwSetInputMode(window, GLFW_STICKY_KEYS, GLFW_TRUE);
  EXPECT_EQ(glfwGetInputMode(window, GLFW_STICKY_KEYS), GLFW_TRUE);
  EXPECT_EQ(takeError(), GLFW_NO_ERROR);
  glfwSetInputMode(window, GLFW_CURSOR, 1);
  EXPECT_EQ(takeError(), GLFW_INVALID_ENUM);
  glfwSetInputMode(window, 1, 1);
  EXPECT_EQ(takeError(), GLFW_INVALID_ENUM);
}

TEST_F(CaptureGlfw, CursorsAndClipboardAreHandles) {
  GLFWcursor* const arrow = glfwCreateStandardCursor(GLFW_ARROW_CURSOR);
  EXPECT_NE(arrow, nullptr);
  glfwSetCursor(open(), arrow);
  glfwDestroyCursor(arrow);
  EXPECT_EQ(glfwCreateStandardCursor(1), nullptr);
  EXPECT_EQ(takeError(), GLFW_INVALID_ENUM);
  const GLFWimage empty{0, 0, nullptr};
  EXPECT_EQ(glfwCreateCursor(&empty, 0, 0), nullptr);
  EXPECT_EQ(takeError(), GLFW_INVALID_VALUE);
  EXPECT_EQ(glfwGetClipboardString(nullptr), nullptr);
  EXPECT_EQ(takeError(), GLFW_FORMAT_UNAVAILABLE);
  glfwSetClipboardString(nullptr, "text");
  EXPECT_STREQ(glfwGetClipboardString(nullptr), "text");
}

TEST_F(CaptureGlfw, ThereIsNoJoystick) {
  int count = -1;
  EXPECT_FALSE(glfwJoystickPresent(GLFW_JOYSTICK_1));
  EXPECT_EQ(glfwGetJoystickAxes(GLFW_JOYSTICK_1, &count), nullptr);
  EXPECT_EQ(count, 0);
  GLFWgamepadstate state;
  EXPECT_FALSE(glfwGetGamepadState(GLFW_JOYSTICK_1, &state));
  EXPECT_EQ(state.buttons[0], 0);
  EXPECT_EQ(takeError(), GLFW_NO_ERROR);
  EXPECT_FALSE(glfwJoystickPresent(16));
  EXPECT_EQ(takeError(), GLFW_INVALID_ENUM);
}

TEST_F(CaptureGlfw, ThereIsNoVulkan) {
  EXPECT_FALSE(glfwVulkanSupported());
  EXPECT_EQ(takeError(), GLFW_NO_ERROR);
  std::uint32_t count = 9;
  EXPECT_EQ(glfwGetRequiredInstanceExtensions(&count), nullptr);
  EXPECT_EQ(count, 0U);
  EXPECT_EQ(takeError(), GLFW_API_UNAVAILABLE);
  std::uint64_t surface = 1;
  EXPECT_EQ(glfwCreateWindowSurface(nullptr, nullptr, nullptr, &surface), -3);
  EXPECT_EQ(surface, 0U);
}

} // namespace
