// Goes on for ever, by swapping (no argument), polling or waiting. Its output is never flushed by
// itself.
#include "open_window.hpp"
#include <GL/gl.h>
#include <cstring>
#include <iostream>

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  GLFWwindow* const window = openWindow(8, 8);
  const char* const how = argc > 1 ? argv[1] : "swap";
  std::printf("printed");
  std::cout << "streamed";
  for (;;) {
    if (!glfwWindowShouldClose(window) || std::strcmp(how, "swap") == 0) {
      glClear(GL_COLOR_BUFFER_BIT);
      glfwSwapBuffers(window);
    } else if (std::strcmp(how, "poll") == 0) {
      glfwPollEvents();
    } else {
      glfwWaitEvents();
    }
  }
}
