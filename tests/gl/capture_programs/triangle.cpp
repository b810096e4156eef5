// Background (51, 102, 153); a red triangle in the lower left half; a blue band whose height in the
// window is the time, so that each frame tells its own.
#include "loaded.hpp"

int main() {
  GLFWwindow* const window = openLoadedWindow(64, 48);
  const GLuint program = makeProgram(R"(#version 410 core
    void main() {
      vec2 corner[3] = vec2[3](vec2(-1, -1), vec2(1, -1), vec2(-1, 1));
      gl_Position = vec4(corner[gl_VertexID], 0, 1);
    })",
                                     R"(#version 410 core
    out vec4 oColor;
    void main() { oColor = vec4(1, 0, 0, 1); })");
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  while (!glfwWindowShouldClose(window)) {
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    glViewport(0, 0, width, height);
    glClearColor(0.2F, 0.4F, 0.6F, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(program);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEnable(GL_SCISSOR_TEST);
    glScissor(width / 2, height - static_cast<int>(glfwGetTime()), width, height);
    glClearColor(0, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    glfwSwapBuffers(window);
    glfwPollEvents();
  }
  std::printf("done\n");
}
