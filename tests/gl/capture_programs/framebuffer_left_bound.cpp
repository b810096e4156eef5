// Frame 0 draws to the window; from frame 1 on everything goes to a framebuffer object that stays
// bound.
#include "loaded.hpp"

int main() {
  GLFWwindow* const window = openLoadedWindow(8, 8);
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glUseProgram(makeProgram("#version 410 core\nvoid main() { gl_Position = vec4(0, 0, 0, 1); }",
                           "#version 410 core\nout vec4 o;\nvoid main() { o = vec4(1); }"));
  for (int frame = 0; !glfwWindowShouldClose(window); ++frame) {
    glClearColor(1, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDrawArrays(GL_POINTS, 0, 1);
    if (frame == 0) {
      glDrawArraysInstanced(GL_POINTS, 0, 1, 2);
      // Bound at this frame's swap already, after the window was drawn.
      glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
      glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    }
    glfwSwapBuffers(window);
    GLint bound = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    std::printf("bound %d\n", bound == static_cast<GLint>(framebuffer));
    glfwPollEvents();
  }
}
