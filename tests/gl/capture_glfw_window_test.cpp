// GLFW's documented contract on the capture library: windows, their sizes, states and events.

#include <gmock/gmock.h>

#define GL_GLEXT_PROTOTYPES
#define GLFW_INCLUDE_GLEXT
#include <GLFW/glfw3.h>

#include <cstdio>
#include <string>

namespace {

/// Names of the callbacks that came, in order, with their arguments.
std::string events;

int takeError() {
  return glfwGetError(nullptr);
}

class CaptureWindow : public testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(glfwInit());
    window_ = glfwCreateWindow(16, 8, "capture", nullptr, nullptr);
    ASSERT_NE(window_, nullptr);
    glfwMakeContextCurrent(window_);
    glfwPollEvents();
    events.clear();
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow*, int width, int height) {
      events += "framebuffer " + std::to_string(width) + "x" + std::to_string(height) + ";";
    });
    glfwSetWindowSizeCallback(window_, [](GLFWwindow*, int width, int height) {
      events += "size " + std::to_string(width) + "x" + std::to_string(height) + ";";
    });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow*) { events += "refresh;"; });
    glfwSetWindowPosCallback(window_, [](GLFWwindow*, int x, int y) {
      events += "pos " + std::to_string(x) + "," + std::to_string(y) + ";";
    });
    glfwSetWindowIconifyCallback(
        window_, [](GLFWwindow*, int on) { events += on ? "iconified;" : "restored;"; });
    glfwSetWindowMaximizeCallback(
        window_, [](GLFWwindow*, int on) { events += on ? "maximized;" : "unmaximized;"; });
  }
  void TearDown() override { glfwTerminate(); }

  std::pair<int, int> size() const {
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    int windowWidth = 0;
    int windowHeight = 0;
    glfwGetWindowSize(window_, &windowWidth, &windowHeight);
    EXPECT_EQ(width, windowWidth);
    EXPECT_EQ(height, windowHeight);
    return {width, height};
  }

  GLFWwindow* window_ = nullptr;
};

using Size = std::pair<int, int>;

TEST_F(CaptureWindow, ResizesItsBufferAndTells) {
  glfwSetWindowSize(window_, 20, 30);
  EXPECT_EQ(events, "framebuffer 20x30;size 20x30;");
  EXPECT_EQ(size(), Size(20, 30));
  glViewport(0, 0, 20, 30);
  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  unsigned char pixel[4] = {};
  glReadPixels(19, 29, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  EXPECT_EQ(pixel[1], 255);
  EXPECT_EQ(glGetError(), unsigned{GL_NO_ERROR});
  glfwSetWindowSize(window_, 20, 30);
  EXPECT_EQ(events, "framebuffer 20x30;size 20x30;") << "no news, no callback";
}

TEST_F(CaptureWindow, KeepsItsDrawBufferAndBindingsWhenResized) {
  glDrawBuffer(GL_NONE);
  glfwSetWindowSize(window_, 20, 30);
  GLint buffer = -1;
  glGetIntegerv(GL_DRAW_BUFFER, &buffer);
  EXPECT_EQ(buffer, GL_NONE);
  glGetIntegerv(GL_READ_BUFFER, &buffer);
  EXPECT_EQ(buffer, GL_BACK);
}

TEST_F(CaptureWindow, KeepsItsDrawBufferWhenResizedBehindAFramebufferObject) {
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glfwSetWindowSize(window_, 20, 30);
  GLint value = -1;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &value);
  EXPECT_EQ(value, static_cast<GLint>(framebuffer));
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glGetIntegerv(GL_DRAW_BUFFER, &value);
  EXPECT_EQ(value, GL_NONE);
  glGetIntegerv(GL_READ_BUFFER, &value);
  EXPECT_EQ(value, GL_NONE);
  EXPECT_EQ(glGetError(), unsigned{GL_NO_ERROR});
}

TEST_F(CaptureWindow, KeepsWithinItsLimits) {
  glfwSetWindowSizeLimits(window_, 10, 10, 40, 40);
  EXPECT_EQ(size(), Size(16, 10));
  glfwSetWindowSize(window_, 100, 5);
  EXPECT_EQ(size(), Size(40, 10));
  glfwSetWindowSizeLimits(window_, 10, 10, 5, 40);
  EXPECT_EQ(takeError(), GLFW_INVALID_VALUE);
  glfwSetWindowSizeLimits(window_, GLFW_DONT_CARE, GLFW_DONT_CARE, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwSetWindowAspectRatio(window_, 4, 3);
  glfwSetWindowSize(window_, 64, 64);
  EXPECT_EQ(size(), Size(64, 48));
  glfwSetWindowAspectRatio(window_, 0, 3);
  EXPECT_EQ(takeError(), GLFW_INVALID_VALUE);
}

TEST_F(CaptureWindow, RemembersItsPlace) {
  glfwSetWindowPos(window_, 5, 6);
  int x = 0;
  int y = 0;
  glfwGetWindowPos(window_, &x, &y);
  EXPECT_EQ(x, 5);
  EXPECT_EQ(y, 6);
  EXPECT_EQ(events, "pos 5,6;");
}

TEST_F(CaptureWindow, RemembersItsState) {
  EXPECT_EQ(glfwGetWindowAttrib(window_, GLFW_VISIBLE), GLFW_TRUE);
  glfwHideWindow(window_);
  EXPECT_EQ(glfwGetWindowAttrib(window_, GLFW_VISIBLE), GLFW_FALSE);
  glfwShowWindow(window_);
  EXPECT_EQ(glfwGetWindowAttrib(window_, GLFW_FOCUSED), GLFW_TRUE);
  glfwIconifyWindow(window_);
  EXPECT_EQ(glfwGetWindowAttrib(window_, GLFW_ICONIFIED), GLFW_TRUE);
  glfwRestoreWindow(window_);
  EXPECT_EQ(glfwGetWindowAttrib(window_, GLFW_ICONIFIED), GLFW_FALSE);
  glfwMaximizeWindow(window_);
  EXPECT_EQ(glfwGetWindowAttrib(window_, GLFW_MAXIMIZED), GLFW_TRUE);
  glfwRestoreWindow(window_);
  EXPECT_EQ(events, "iconified;restored;maximized;unmaximized;");
  glfwSetWindowAttrib(window_, GLFW_RESIZABLE, GLFW_FALSE);
  EXPECT_EQ(glfwGetWindowAttrib(window_, GLFW_RESIZABLE), GLFW_FALSE);
  EXPECT_EQ(takeError(), GLFW_NO_ERROR);
  glfwSetWindowAttrib(window_, GLFW_VISIBLE, GLFW_FALSE);
  EXPECT_EQ(takeError(), GLFW_INVALID_ENUM);
  glfwGetWindowAttrib(window_, 1);
  EXPECT_EQ(takeError(), GLFW_INVALID_ENUM);
  glfwSetWindowOpacity(window_, 0.5F);
  EXPECT_EQ(glfwGetWindowOpacity(window_), 0.5F);
  glfwSetWindowOpacity(window_, 2);
  EXPECT_EQ(takeError(), GLFW_INVALID_VALUE);
}

TEST_F(CaptureWindow, GoesFullScreenInTheSizeThatWasAskedFor) {
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  glfwSetWindowMonitor(window_, monitor, 0, 0, 320, 200, GLFW_DONT_CARE);
  EXPECT_EQ(glfwGetWindowMonitor(window_), monitor);
  EXPECT_EQ(size(), Size(320, 200));
  glfwSetWindowMonitor(window_, nullptr, 7, 9, 16, 8, 0);
  EXPECT_EQ(glfwGetWindowMonitor(window_), nullptr);
  EXPECT_EQ(size(), Size(16, 8));
  glfwSetWindowMonitor(window_, nullptr, 0, 0, -1, 8, 0);
  EXPECT_EQ(takeError(), GLFW_INVALID_VALUE);
}

TEST_F(CaptureWindow, ClosesWhenToldTo) {
  EXPECT_FALSE(glfwWindowShouldClose(window_));
  glfwSetWindowShouldClose(window_, GLFW_TRUE);
  EXPECT_TRUE(glfwWindowShouldClose(window_));
  glfwSetWindowShouldClose(window_, GLFW_FALSE);
  EXPECT_FALSE(glfwWindowShouldClose(window_));
}

TEST_F(CaptureWindow, WaitsNeverBlockAndAskForAFrame) {
  glfwWaitEvents();
  events.clear();
  glfwWaitEvents();
  EXPECT_EQ(events, "refresh;") << "a program that draws on demand is asked to";
  glfwSwapBuffers(window_);
  events.clear();
  glfwWaitEventsTimeout(1e9);
  EXPECT_EQ(events, "") << "it has just drawn";
  glfwWaitEventsTimeout(-1);
  EXPECT_EQ(takeError(), GLFW_INVALID_VALUE);
  glfwPostEmptyEvent();
}

TEST_F(CaptureWindow, MayBeDestroyedInItsOwnCallback) {
  glfwSetFramebufferSizeCallback(window_,
                                 [](GLFWwindow* window, int, int) { glfwDestroyWindow(window); });
  glfwSetWindowSize(window_, 20, 30);
  EXPECT_EQ(events, "");
  EXPECT_EQ(glfwGetCurrentContext(), nullptr);
  glfwPollEvents();
}

TEST_F(CaptureWindow, KeepsTheProgramsPointer) {
  int value = 0;
  glfwSetWindowUserPointer(window_, &value);
  EXPECT_EQ(glfwGetWindowUserPointer(window_), &value);
}

} // namespace
