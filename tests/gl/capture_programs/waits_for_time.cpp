// Draws 60 frames a second by looking at the clock until it is time.
#include "open_window.hpp"
#include <GL/gl.h>

int main() {
  GLFWwindow* const window = openWindow(8, 8);
  while (!glfwWindowShouldClose(window)) {
    const double start = glfwGetTime();
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    while (glfwGetTime() < start + 1.0 / 60) glfwPollEvents();
    glfwSwapBuffers(window);
  }
  std::printf("done\n");
}
