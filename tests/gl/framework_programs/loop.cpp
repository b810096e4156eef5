// Clears the window to a colour that tells the frame's time, and draws with a program from its own
// folder. The scene's text `mesh` chooses what goes wrong.

#include <gg/gg.hpp>

void app(const gg::Scene& scene) {
  const std::string& mode = scene.text("mesh");
  if (mode == "throw") throw std::runtime_error("the framebuffer is not complete");
  if (mode == "throw_int") throw 7;
  gg::Window window("loop", scene.size);
  if (mode == "close") glfwSetWindowShouldClose(window.handle(), GLFW_TRUE);
  const gg::Program program({"loop.vert", mode == "bad_shader" ? "bad.frag" : "loop.frag"});
  const gg::Mesh mesh = gg::plane(1, 1);
  int frames = 0;
  while (window) {
    GLint viewport[4];
    glGetIntegerv(GL_VIEWPORT, viewport);
    std::printf("frame %d: %dx%d aspect %.2f viewport %dx%d\n", frames++, window.width(),
                window.height(), window.aspect(), viewport[2], viewport[3]);
    glClearColor(static_cast<float>(glfwGetTime()), 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    program.use();
    mesh.draw();
    window.swapBuffers();
  }
}
