// Linked with -lGL or -lOpenGL: no loader. Green with a white lower left quarter.
#define GL_GLEXT_PROTOTYPES
#include "open_window.hpp"
#include <GL/gl.h>
#include <GL/glext.h>

int main() {
  GLFWwindow* const window = openWindow(16, 16);
  const float green[] = {0, 1, 0, 1};
  while (!glfwWindowShouldClose(window)) {
    glClearBufferfv(GL_COLOR, 0, green);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 8, 8);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    glfwSwapBuffers(window);
    glfwPollEvents();
  }
}
