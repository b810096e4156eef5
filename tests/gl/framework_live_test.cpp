// What a window does while one works on the program: tiles, stopped time, pictures, errors.

#include "framework_window.hpp"
#include "in_japanese.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include <gg/texture.hpp>

namespace {

using testing::Each;
using testing::ElementsAre;
using testing::internal::CaptureStderr;
using testing::internal::GetCapturedStderr;

class Live : public testing::Test {
protected:
  static constexpr int kWidth = 256, kHeight = 192; // pixels

  /// As if the user pressed it.
  void press(int key) const {
    const GLFWkeyfun onKey = glfwSetKeyCallback(window.handle(), nullptr);
    glfwSetKeyCallback(window.handle(), onKey);
    onKey(window.handle(), key, 0, GLFW_PRESS, 0);
  }

  /// A texture of one colour.
  struct Target {
    Target(int width, int height, GLint format, GLenum attachment)
        : attachment(attachment), isDepth(attachment == GL_DEPTH_ATTACHMENT) {
      glBindTexture(GL_TEXTURE_2D, texture);
      glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0,
                   isDepth ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT, nullptr);
      glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
      glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture, 0);
      if (isDepth) glDrawBuffer(GL_NONE);
      glBindFramebuffer(GL_FRAMEBUFFER, 0);
    }
    GLenum attachment;
    bool isDepth;
    gg::Texture texture;
    gg::Framebuffer framebuffer;
  };

  /// By clearing and, unless it is `onlyCleared`, a draw call that draws nothing.
  void fill(const Target& target, const glm::vec4& value, bool onlyCleared = false) const {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glClearBufferfv(target.isDepth ? GL_DEPTH : GL_COLOR, 0, &value.x);
    if (!onlyCleared) glDrawArrays(GL_POINTS, 0, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
  }

  /// Counted from the top left, as one looks at it.
  static std::array<int, 3> at(int x, int y) {
    std::array<GLubyte, 4> p{};
    glReadPixels(x, kHeight - 1 - y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, p.data());
    return {p[0], p[1], p[2]};
  }

  /// White pixels of letters in a rectangle.
  static int letters(int left, int top, int width, int height) {
    int count = 0;
    for (int y = top; y < top + height; ++y)
      for (int x = left; x < left + width; ++x)
        count += at(x, y) == std::array<int, 3>{255, 255, 255};
    return count;
  }

  void TearDown() override { EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)); }

  TemporaryFolder folder;
  gg::Window window{"live", {kWidth, kHeight}};
  gg::VertexArray noVertices;
};

TEST_F(Live, TilesShowEveryTextureOfTheFrame) {
  const Target color(64, 64, GL_RGBA8, GL_COLOR_ATTACHMENT0);
  const Target bright(kWidth, kHeight, GL_RGBA16F, GL_COLOR_ATTACHMENT0);
  const Target depth(kWidth, kHeight, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
  glBindVertexArray(noVertices);
  const auto frame = [&] {
    fill(color, {1, 0, 0, 1}, true);
    fill(bright, {3, 1, 0, 1});
    fill(depth, glm::vec4(1));
    glEnable(GL_SCISSOR_TEST);
    for (const auto& [left, value] : {std::pair(0, 0.875f), {64, 0.96875f}, {128, 0.9921875f}}) {
      glScissor(left, 0, 64, kHeight);
      fill(depth, glm::vec4(value));
    }
    glDisable(GL_SCISSOR_TEST);
    const GLfloat blue[] = {0, 0, 1, 1};
    glClearBufferfv(GL_COLOR, 0, blue);
    window.swapBuffers();
  };
  CaptureStderr();
  frame();
  EXPECT_THAT(at(32, 30), ElementsAre(0, 0, 255)) << "no tiles yet";
  press(GLFW_KEY_T);
  frame();
  GetCapturedStderr(); // nothing is drawn to the window: the doctor says so
  // Two by two, each of 128 x 96 with its name: the window's own picture comes first.
  EXPECT_THAT(at(40, 60), ElementsAre(0, 0, 255));
  EXPECT_THAT(at(128 + 40, 60), ElementsAre(255, 0, 0));
  EXPECT_THAT(at(40, 96 + 60), ElementsAre(191, 128, 0)) << "x / (1 + x)";
  // 1 - depth is 2^-3, 2^-5, 2^-7, and 0 where it was only cleared.
  const auto grey = [&](int x) { return at(128 + x, 96 + 60)[0]; };
  EXPECT_EQ(grey(14), 0) << "the nearest";
  EXPECT_NEAR(grey(42), 127, 2);
  EXPECT_EQ(grey(70), 255) << "the farthest";
  EXPECT_EQ(grey(98), 255);
  EXPECT_THAT(at(127, 60), ElementsAre(64, 64, 64)) << "the gap between them";
  for (const int left : {0, 128})
    for (const int top : {0, 96}) EXPECT_GT(letters(left, top, 120, 9), 80) << left << ' ' << top;
  press(GLFW_KEY_T);
  frame();
  EXPECT_THAT(at(128 + 40, 60), ElementsAre(0, 0, 255)) << "and none any more";
}

TEST_F(Live, TilesLeaveOpenGLAsItWas) {
  const Target target(64, 64, GL_RGBA8, GL_COLOR_ATTACHMENT0);
  glBindVertexArray(noVertices);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
  glViewport(3, 4, 50, 60);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, target.texture);
  glActiveTexture(GL_TEXTURE3);
  CaptureStderr();
  press(GLFW_KEY_T);
  fill(target, glm::vec4(1));
  window.swapBuffers();
  GetCapturedStderr();
  const auto integers = [](GLenum name) {
    std::array<GLint, 4> values{};
    glGetIntegerv(name, values.data());
    return values;
  };
  EXPECT_TRUE(glIsEnabled(GL_DEPTH_TEST));
  EXPECT_TRUE(glIsEnabled(GL_CULL_FACE));
  EXPECT_FALSE(glIsEnabled(GL_BLEND));
  EXPECT_THAT(integers(GL_COLOR_WRITEMASK), ElementsAre(1, 0, 1, 1));
  EXPECT_THAT(integers(GL_VIEWPORT), ElementsAre(3, 4, 50, 60));
  EXPECT_EQ(integers(GL_ACTIVE_TEXTURE)[0], GL_TEXTURE3);
  EXPECT_EQ(integers(GL_CURRENT_PROGRAM)[0], 0);
  EXPECT_EQ(GLuint(integers(GL_VERTEX_ARRAY_BINDING)[0]), GLuint(noVertices));
  EXPECT_EQ(integers(GL_DRAW_FRAMEBUFFER_BINDING)[0], 0);
  glActiveTexture(GL_TEXTURE1);
  EXPECT_EQ(GLuint(integers(GL_TEXTURE_BINDING_2D)[0]), GLuint(target.texture));
  EXPECT_EQ(integers(GL_SAMPLER_BINDING)[0], 0);
}

TEST_F(Live, AShadersErrorIsShownUntilItIsMended) {
  const std::string start = "#version 410 core\n";
  folder.write("a.vert", start + "void main() { gl_Position = vec4(0); }\n");
  const auto save = [&](const std::string& body) {
    static int saves = 0;
    folder.write("a.frag", start + "out vec4 oColor;\nvoid main() { " + body + " }\n");
    std::filesystem::last_write_time(folder.path() / "a.frag",
                                     std::filesystem::file_time_type::clock::now() +
                                         std::chrono::seconds(++saves));
    std::this_thread::sleep_for(std::chrono::milliseconds(250));
    CaptureStderr();
    glClear(GL_COLOR_BUFFER_BIT);
    window.swapBuffers();
    return GetCapturedStderr();
  };
  folder.write("a.frag", start + "out vec4 oColor;\nvoid main() { oColor = vec4(1); }\n");
  const gg::Program program({"a.vert", "a.frag"}, folder.path().string());
  save("oColor = vec4(2);");
  EXPECT_EQ(letters(0, 0, kWidth, kHeight), 0);
  save("oColor = vec5(2);");
  EXPECT_GT(letters(0, 0, kWidth, 40), 300);
  save("oColor = vec4(3);");
  EXPECT_EQ(letters(0, 0, kWidth, kHeight), 0);
}

TEST_F(Live, WhatTheWindowCannotSpellStandsInTheTerminal) {
  const InJapanese japanese;
  const auto save = [&](const std::string& first) {
    folder.write("a.frag", first + "\nout vec4 oColor;\nvoid main() { oColor = vec4(1); }\n");
  };
  folder.write("a.vert", "#version 410 core\nvoid main() { gl_Position = vec4(0); }\n");
  save("#version 410 core");
  const gg::Program program({"a.vert", "a.frag"}, folder.path().string());
  window.swapBuffers(); // watched
  save("#version 110");
  std::filesystem::last_write_time(folder.path() / "a.frag",
                                   std::filesystem::file_time_type::clock::now() +
                                       std::chrono::seconds(1));
  std::this_thread::sleep_for(std::chrono::milliseconds(250));
  CaptureStderr();
  window.swapBuffers();
  EXPECT_EQ(GetCapturedStderr(),
            "a.frag:1: error: 最初の行は\"#version 410 core\"でなければなりません\n");
  // "a.frag:1: error: see the terminal" is two lines of the window, each 18 pixels.
  EXPECT_GT(letters(0, 18, kWidth, 18), 50);
  EXPECT_EQ(letters(0, 36, kWidth, kHeight - 36), 0);
}

TEST_F(Live, SpaceStopsTheTimeAndArrowsStepIt) {
  glfwSetTime(5);
  press(GLFW_KEY_RIGHT);
  window.swapBuffers();
  EXPECT_NEAR(glfwGetTime(), 5.1, 0.05);
  std::this_thread::sleep_for(std::chrono::milliseconds(120));
  press(GLFW_KEY_LEFT);
  press(GLFW_KEY_LEFT);
  window.swapBuffers();
  EXPECT_NEAR(glfwGetTime(), 4.9, 0.05) << "the time that passed meanwhile doesn't count";
  press(GLFW_KEY_SPACE);
  window.swapBuffers();
  std::this_thread::sleep_for(std::chrono::milliseconds(120));
  window.swapBuffers();
  EXPECT_GT(glfwGetTime(), 4.92) << "it goes on";
}

TEST_F(Live, F12SavesThePicture) {
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  const GLfloat color[] = {1, 0.5f, 0, 1};
  std::string printed;
  for (int i = 0; i < 2; ++i) {
    glClearBufferfv(GL_COLOR, 0, color);
    press(GLFW_KEY_F12);
    CaptureStderr();
    window.swapBuffers();
    printed += GetCapturedStderr();
  }
  EXPECT_THAT(printed, testing::HasSubstr("saved live-1.png\n"));
  EXPECT_THAT(printed, testing::HasSubstr("saved live-2.png\n"));
  const gg::Image saved = gg::readPng((folder.path() / "live-1.png").string());
  std::filesystem::current_path(before);
  EXPECT_EQ(saved.width, kWidth);
  EXPECT_EQ(saved.height, kHeight);
  EXPECT_THAT(std::vector<int>(saved.rgba.begin(), saved.rgba.begin() + 4),
              ElementsAre(255, 128, 0, 255));
}

} // namespace
