// Follows its size by callbacks alone: the viewport is red, what lies outside of it black.
#include "loaded.hpp"

namespace {
int viewportWidth = 20;
int viewportHeight = 10;
} // namespace

int main(int argc, char**) {
  GLFWwindow* const window = openLoadedWindow(viewportWidth, viewportHeight);
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow*, int width, int height) {
    std::printf("framebuffer %dx%d\n", width, height);
    viewportWidth = width;
    viewportHeight = height;
  });
  glfwSetWindowSizeCallback(window, [](GLFWwindow*, int width, int height) {
    std::printf("window %dx%d\n", width, height);
  });
  glfwSetWindowCloseCallback(window, [](GLFWwindow*) { std::printf("close\n"); });
  for (int frame = 0; !glfwWindowShouldClose(window); ++frame) {
    if (argc > 1 && frame == 1) glfwSetWindowSize(window, 30, 15);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, viewportWidth, viewportHeight);
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glfwSwapBuffers(window);
    glfwPollEvents();
  }
}
