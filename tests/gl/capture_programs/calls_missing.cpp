// Calls functions that libGL exports and nothing offscreen can serve, and ones that exist, in all
// argument kinds.
#define GL_GLEXT_PROTOTYPES
#include "open_window.hpp"
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glx.h>
#include <initializer_list>

int main() {
  GLFWwindow* const window = openWindow(8, 8, GLFW_OPENGL_ANY_PROFILE);
  glTbufferMask3DFX(1);
  glTbufferMask3DFX(2);
  const auto loaded = reinterpret_cast<void (*)(GLuint)>(glfwGetProcAddress("glTbufferMask3DFX"));
  loaded(3);
  std::printf("%d %d\n", glIsObjectBufferATI(1), glXIsDirect(nullptr, nullptr));
  // What GLEW asks before it goes on.
  int major = 0;
  int minor = 0;
  glXQueryVersion(glXGetCurrentDisplay(), &major, &minor);
  std::printf("%d %d.%d\n", glXGetCurrentDisplay() != nullptr, major, minor);
  // The first call of an entry finds its target with all arguments kept.
  glUniform4f(-1, 1, 2, 3, 4);
  glLoadIdentity();
  glFrustum(-1, 2, -3, 4, 5, 60);
  double matrix[16];
  glGetDoublev(GL_PROJECTION_MATRIX, matrix);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glOrtho(-2, 3, -5, 7, -11, 13);
  glGetDoublev(GL_PROJECTION_MATRIX, matrix);
  for (const int i : {0, 5, 10, 12, 13, 14}) std::printf("%.6f\n", matrix[i]);
  while (!glfwWindowShouldClose(window)) {
    glClear(GL_COLOR_BUFFER_BIT);
    glfwSwapBuffers(window);
    glfwPollEvents();
  }
}
