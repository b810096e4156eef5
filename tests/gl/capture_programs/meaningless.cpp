// Asks twice for everything that has no meaning without a display.
#include "open_window.hpp"

int main() {
  glfwInit();
  glfwWindowHint(GLFW_SAMPLES, 4);
  glfwWindowHint(GLFW_SRGB_CAPABLE, GLFW_TRUE);
  glfwWindowHint(GLFW_STEREO, GLFW_TRUE);
  GLFWwindow* const window = openWindow(8, 8);
  for (int i = 0; i < 2; ++i) {
    glfwSwapInterval(1);
    glfwIconifyWindow(window);
    glfwRestoreWindow(window);
    glfwMaximizeWindow(window);
    glfwSetWindowOpacity(window, 0.5F);
    glfwSetGamma(glfwGetPrimaryMonitor(), 2);
    glfwSetWindowMonitor(window, glfwGetPrimaryMonitor(), 0, 0, 8, 8, 60);
    glfwSetWindowMonitor(window, nullptr, 0, 0, 8, 8, 0);
  }
  while (!glfwWindowShouldClose(window)) {
    glfwSwapBuffers(window);
    glfwPollEvents();
  }
}
