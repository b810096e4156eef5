// The fixed pipeline: a yellow right half by glBegin, a cyan upper left quarter from a display
// list.
#include "open_window.hpp"
#include <GL/gl.h>

int main() {
  GLFWwindow* const window = openWindow(16, 16, GLFW_OPENGL_ANY_PROFILE);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glColor3f(0, 1, 1);
  glRectf(-1, 0, 0, 1);
  glEndList();
  while (!glfwWindowShouldClose(window)) {
    glClear(GL_COLOR_BUFFER_BIT);
    glColor3f(1, 1, 0);
    glBegin(GL_QUADS);
    glVertex2f(0, -1);
    glVertex2f(1, -1);
    glVertex2f(1, 1);
    glVertex2f(0, 1);
    glEnd();
    glCallList(list);
    glfwSwapBuffers(window);
    glfwPollEvents();
  }
}
