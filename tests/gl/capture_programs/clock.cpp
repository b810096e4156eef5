// Prints the clock twice a frame. With `reset`, sets it to 0 before the loop; with `again`, to 100
// after the second frame.
#include "open_window.hpp"
#include <cstring>

int main(int argc, char** argv) {
  const char* const how = argc > 1 ? argv[1] : "";
  GLFWwindow* const window = openWindow(8, 8);
  if (std::strcmp(how, "reset") == 0) {
    glfwGetTime();
    glfwSetTime(0);
  }
  for (int frame = 0; !glfwWindowShouldClose(window); ++frame) {
    const double first = glfwGetTime();
    const double second = glfwGetTime();
    const auto third = static_cast<unsigned long long>(glfwGetTimerValue());
    std::printf("%.6f %.6f %llu\n", first, second, third);
    glfwSwapBuffers(window);
    if (frame == 1 && std::strcmp(how, "again") == 0) glfwSetTime(100);
    glfwPollEvents();
  }
}
