// Leaves sRGB encoding to the window in frame 1 only.
#include "loaded.hpp"

int main() {
  GLFWwindow* const window = openLoadedWindow(8, 8);
  for (int frame = 0; !glfwWindowShouldClose(window); ++frame) {
    if (frame == 1) glEnable(GL_FRAMEBUFFER_SRGB);
    glClearColor(0.5F, 0.5F, 0.5F, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glfwSwapBuffers(window);
    glfwPollEvents();
  }
}
