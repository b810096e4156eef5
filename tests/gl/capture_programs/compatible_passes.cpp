// The compatibility profile: immediate mode, display lists, pixel transfer.
#include "open_window.hpp"

#include <GL/gl.h>

int main() {
  GLFWwindow* const window = openWindow(8, 8, GLFW_OPENGL_ANY_PROFILE);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glColor3f(0, 1, 0);
  glRectf(-1, -1, 0, 1);
  glClear(GL_DEPTH_BUFFER_BIT);
  glEndList();
  glPixelTransferf(GL_RED_SCALE, 0.25F);
  glPixelTransferf(GL_GREEN_BIAS, 0.5F);
  while (!glfwWindowShouldClose(window)) {
    glClearColor(0.2F, 0.4F, 0.6F, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 0);
    glVertex2f(-1, -1);
    glVertex2f(1, -1);
    glVertex2f(1, 1);
    glEnd();
    glClear(GL_DEPTH_BUFFER_BIT);
    glCallList(list);
    glfwSwapBuffers(window);
    if (const GLenum error = glGetError()) std::printf("error %x\n", error);
    glfwPollEvents();
  }
  float scale = 0;
  glGetFloatv(GL_RED_SCALE, &scale);
  std::printf("scale %g\n", static_cast<double>(scale));
}
