// glEnable(0xDEAD) in every frame, under the program's own debug settings; prints what it hears of
// it.
#include "loaded.hpp"
#include <cstring>

namespace {

void APIENTRY hear(GLenum, GLenum type, GLuint, GLenum, GLsizei, const char* text,
                   const void* user) {
  std::printf("heard %x %s %s\n", type, text, static_cast<const char*>(user));
}

} // namespace

int main(int argc, char** argv) {
  const char* const how = argc > 1 ? argv[1] : "";
  const auto is = [how](const char* name) { return std::strcmp(how, name) == 0; };
  if (is("context")) {
    glfwInit();
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
  }
  GLFWwindow* const window = openLoadedWindow(8, 8);
  GLint flags = 0;
  glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
  std::printf("debug %d %d %d\n", (flags & GL_CONTEXT_FLAG_DEBUG_BIT) != 0,
              glIsEnabled(GL_DEBUG_OUTPUT), glfwGetWindowAttrib(window, GLFW_OPENGL_DEBUG_CONTEXT));
  static char user[] = "user";
  if (is("callback") || is("disabled") || is("context")) glDebugMessageCallback(hear, user);
  if (is("callback") || is("log")) glEnable(GL_DEBUG_OUTPUT);
  if (is("disabled")) glDisable(GL_DEBUG_OUTPUT);
  if (is("silenced") || is("eaten")) {
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
  }
  void* callback = nullptr;
  glGetPointerv(GL_DEBUG_CALLBACK_FUNCTION, &callback);
  std::printf("callback %d\n", callback == reinterpret_cast<void*>(hear));
  while (!glfwWindowShouldClose(window)) {
    glEnable(0xDEAD);
    if (is("eaten")) {
      while (glGetError() != GL_NO_ERROR) {
      }
    }
    glfwSwapBuffers(window);
    std::printf("error %x", glGetError());
    std::printf(" then %x\n", glGetError());
    glfwPollEvents();
  }
  if (is("log")) {
    char text[100] = "";
    GLenum type = 0;
    const GLuint count =
        glGetDebugMessageLog(1, sizeof(text), nullptr, &type, nullptr, nullptr, nullptr, text);
    std::printf("log %u %x %s\n", count, type, text);
  }
}
