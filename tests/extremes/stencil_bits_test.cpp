// Shadow volumes in a window that can't count: solutions/shadow_volume/volume_buffer.hpp.

#include "../../solutions/shadow_volume/volume_buffer.hpp"

#include <gmock/gmock.h>

namespace {

/// A window with so many bits of stencil, as a program opens it by itself.
class StencilBits : public testing::TestWithParam<int> {
protected:
  void SetUp() override {
    ASSERT_TRUE(glfwInit());
    glfwWindowHint(GLFW_STENCIL_BITS, GetParam());
    glfwMakeContextCurrent(glfwCreateWindow(8, 8, "stencil bits", nullptr, nullptr));
    ASSERT_NE(gladLoadGL(glfwGetProcAddress), 0);
    gladUninstallGLDebug();
  }
  void TearDown() override {
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    glfwTerminate();
  }
};

INSTANTIATE_TEST_SUITE_P(ShadowVolume, StencilBits, testing::Values(0, 8));

TEST_P(StencilBits, AreAskedFor) {
  if (GetParam() == 8) {
    EXPECT_NO_THROW(requireStencil());
    return;
  }
  EXPECT_THAT(requireStencil,
              testing::ThrowsMessage<gg::WindowError>(
                  "shadow volumes are counted in a stencil buffer of 8 bits; this window has 0.\n"
                  "Ask for them before the window is opened: glfwWindowHint(GLFW_STENCIL_BITS, 8). "
                  "If they were asked for, update the graphics driver."));
}

} // namespace
