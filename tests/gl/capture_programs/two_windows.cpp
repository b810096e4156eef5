// A hidden window loads a texture that the second one, which shares with it, draws; a third is
// blue.
#include "loaded.hpp"

int main() {
  glfwInit();
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  GLFWwindow* const loader = openLoadedWindow(4, 4);
  const unsigned char orange[] = {255, 128, 0, 255};
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, orange);

  glfwWindowHint(GLFW_VISIBLE, GLFW_TRUE);
  GLFWwindow* const shown = glfwCreateWindow(8, 8, "shown", nullptr, loader);
  GLFWwindow* const other = glfwCreateWindow(16, 16, "other", nullptr, loader);
  glfwMakeContextCurrent(shown);
  GLuint source = 0;
  glGenFramebuffers(1, &source);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, source);
  glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  while (!glfwWindowShouldClose(shown)) {
    glfwMakeContextCurrent(other);
    glClearColor(0, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glfwSwapBuffers(other);
    glfwMakeContextCurrent(shown);
    glBlitFramebuffer(0, 0, 1, 1, 0, 0, 8, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glfwMakeContextCurrent(nullptr);
    glfwSwapBuffers(shown); // allowed while no context is current
    glfwPollEvents();
  }
  glfwTerminate();
}
