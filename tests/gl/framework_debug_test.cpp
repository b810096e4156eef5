// What a program hears of its mistakes.

#include "framework_window.hpp"
#include <gg/debug.hpp>
#include <gmock/gmock.h>

namespace {

using testing::internal::CaptureStderr;
using testing::internal::GetCapturedStderr;

class Debug : public FrameworkWindow {};

TEST_F(Debug, AnErrorIsPrintedOnceWithTheDriversWords) {
  CaptureStderr();
  for (int i = 0; i < 3; ++i) {
    glBindTexture(0x1234, 0);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
  }
  const std::string text = GetCapturedStderr();
  EXPECT_THAT(text,
              testing::MatchesRegex("OpenGL: error: GL_INVALID_ENUM[^\n]*glBindTexture[^\n]*\n"));
}

TEST_F(Debug, ErrorsStayForTheProgramsOwnQuestion) {
  CaptureStderr();
  glEnable(0x4321);
  gg::reportErrors("a test");
  GetCapturedStderr();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
}

TEST_F(Debug, ACorrectProgramPrintsNothing) {
  CaptureStderr();
  const gg::Program p = coloring("vec4(1)");
  p.use();
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  EXPECT_EQ(GetCapturedStderr(), "");
}

} // namespace
