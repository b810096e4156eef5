// What a program hears of its mistakes.

#include "framework_window.hpp"
#include <gg/debug.hpp>
#include <gg/handle.hpp>
#include <gmock/gmock.h>

#include <set>

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

// The first texture and the first framebuffer were both called 2, so that a mix-up drew.
TEST_F(Debug, ANameOfOneKindIsNoneOfAnother) {
  CaptureStderr();
  const gg::Texture texture;
  const gg::Framebuffer framebuffer;
  const gg::Renderbuffer renderbuffer;
  EXPECT_EQ(std::set<GLuint>({texture, framebuffer, renderbuffer}).size(), 3U);
  EXPECT_EQ(gg::Texture(), texture + 1) << "only the first one skips names";
  glBindFramebuffer(GL_FRAMEBUFFER, texture);
  // Mesa makes one of it that has no attachment, other drivers refuse.
  EXPECT_NE(glCheckFramebufferStatus(GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, renderbuffer, 0);
  EXPECT_NE(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  GetCapturedStderr();
}

} // namespace
