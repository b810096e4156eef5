// Draws in a thread of its own while the main thread waits for events.
#include "loaded.hpp"
#include <thread>

int main() {
  GLFWwindow* const window = openWindow(8, 8);
  glfwMakeContextCurrent(nullptr);
  static std::thread::id mainThread = std::this_thread::get_id();
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow*, int width, int height) {
    std::printf("%dx%d %d\n", width, height, std::this_thread::get_id() == mainThread);
  });
  std::thread render([window] {
    glfwMakeContextCurrent(window);
    gladLoadGL(glfwGetProcAddress);
    gladUninstallGLDebug();
    while (!glfwWindowShouldClose(window)) {
      glClearColor(0, 1, 0, 1);
      glClear(GL_COLOR_BUFFER_BIT);
      glfwSwapBuffers(window);
    }
    glfwMakeContextCurrent(nullptr);
  });
  while (!glfwWindowShouldClose(window)) glfwWaitEvents();
  render.join();
  glfwPollEvents();
  glfwTerminate();
}
