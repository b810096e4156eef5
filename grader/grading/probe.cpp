// A program that is linked as submissions are and opens a window: says what it draws with, and
// every library that a run has in memory then.
#include <GLFW/glfw3.h>

#include <cstdio>

#include <link.h>

int main() {
  if (!glfwInit()) return 1;
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  GLFWwindow* const window = glfwCreateWindow(16, 16, "", nullptr, nullptr);
  if (!window) {
    const char* why = "";
    glfwGetError(&why);
    std::fprintf(stderr, "%s\n", why ? why : "no window");
    return 1;
  }
  glfwMakeContextCurrent(window);
  using GetString = const unsigned char* (*)(unsigned int);
  const auto getString = reinterpret_cast<GetString>(glfwGetProcAddress("glGetString"));
  std::printf("version %s\nrenderer %s\n", getString(0x1F02), getString(0x1F01)); // GL_VERSION, ...
  const auto print = [](dl_phdr_info* info, std::size_t, void*) {
    if (info->dlpi_name && info->dlpi_name[0] == '/') std::printf("file %s\n", info->dlpi_name);
    return 0;
  };
  dl_iterate_phdr(print, nullptr);
  std::fflush(stdout);
}
