// A lit, textured ring of 64x32 patches with depth test and blending: enough arithmetic to show
// whether pixels come out the same.
#include "loaded.hpp"

int main() {
  GLFWwindow* const window = openLoadedWindow(320, 240);
  const GLuint program = makeProgram(R"(#version 410 core
    uniform float uTime;
    out vec3 vNormal;
    out vec3 vPosition;
    out vec2 vUv;
    const ivec2 corner[6] = ivec2[6](ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 0), ivec2(1, 1), ivec2(0, 1));
    void main() {
      ivec2 cell = ivec2((gl_VertexID / 6) % 64, gl_VertexID / 6 / 64) + corner[gl_VertexID % 6];
      vec2 angle = vec2(cell) / vec2(64, 32) * 6.2831853;
      vec3 out1 = vec3(cos(angle.x + uTime), sin(angle.x + uTime), 0);
      vec3 normal = out1 * cos(angle.y) + vec3(0, 0, sin(angle.y));
      vec3 position = out1 * 0.6 + normal * 0.25;
      vNormal = normal;
      vPosition = position;
      vUv = angle;
      gl_Position = vec4(position.x * 0.75, position.y, position.z * 0.3, 1.0 + 0.3 * position.z);
    })",
                                     R"(#version 410 core
    in vec3 vNormal;
    in vec3 vPosition;
    in vec2 vUv;
    out vec4 oColor;
    void main() {
      vec3 n = normalize(vNormal);
      vec3 l = normalize(vec3(2, 3, -4) - vPosition);
      vec3 h = normalize(l + vec3(0, 0, -1));
      float tile = mod(floor(vUv.x * 3.0) + floor(vUv.y * 2.0), 2.0);
      vec3 base = mix(vec3(0.8, 0.3, 0.2), vec3(0.2, 0.5, 0.9), tile);
      vec3 color = base * (0.1 + max(dot(n, l), 0.0)) + pow(max(dot(n, h), 0.0), 40.0);
      oColor = vec4(pow(color, vec3(1.0 / 2.2)), 0.9);
    })");
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glUseProgram(program);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  while (!glfwWindowShouldClose(window)) {
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    glViewport(0, 0, width, height);
    glClearColor(0.1F, 0.1F, 0.2F, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUniform1f(glGetUniformLocation(program, "uTime"), static_cast<float>(glfwGetTime()));
    glDrawArrays(GL_TRIANGLES, 0, 64 * 32 * 6);
    glfwSwapBuffers(window);
    glfwPollEvents();
  }
}
