#include <gg/window.hpp>

#include <algorithm>
#include <map>

#include "live.hpp"
#include "print_once.hpp"
#include "words/words.hpp"

#include <gg/debug.hpp>
#include <gg/error.hpp>

namespace gg {

namespace {

constexpr int kMajor = 4;
constexpr int kMinor = 1;

std::string lastError; // of GLFW, in words
int windows = 0;       // open windows; GLFW is shut down with the last

void rememberError(int, const char* description) {
  lastError = description;
}

std::map<GLFWwindow*, detail::Live*> lives;

void onKey(GLFWwindow* window, int key, int, int action, int) {
  if (action == GLFW_RELEASE) return;
  if (key == GLFW_KEY_ESCAPE) glfwSetWindowShouldClose(window, GLFW_TRUE);
  lives.at(window)->keyPressed(key);
}

void followSize(GLFWwindow* window, int width, int height) {
  if (glfwGetCurrentContext() == window) glViewport(0, 0, width, height);
}

// The version and driver of the OpenGL that this machine gives to whoever asks for nothing special.
std::string foundDriver() {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  GLFWwindow* probe = glfwCreateWindow(16, 16, "", nullptr, nullptr);
  if (probe == nullptr) return say("This machine offers no OpenGL at all ({}).", lastError);
  glfwMakeContextCurrent(probe);
  const auto text = [](GLenum name) -> std::string {
    const auto get = reinterpret_cast<PFNGLGETSTRINGPROC>(glfwGetProcAddress("glGetString"));
    const GLubyte* found = get != nullptr ? get(name) : nullptr;
    return found != nullptr ? reinterpret_cast<const char*>(found) : "unknown";
  };
  std::string found =
      say("Found: OpenGL {} on {} ({}).", text(GL_VERSION), text(GL_RENDERER), text(GL_VENDOR));
  glfwDestroyWindow(probe);
  return found;
}

GLFWwindow* open(const std::string& title, const glm::ivec2& size) {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, kMajor);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, kMinor);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
  GLFWwindow* window = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
  if (window != nullptr) return window;
  const std::string reason = lastError;
  throw WindowError(say("no window with OpenGL 4.1 core could be opened: {}\n{}\nUpdate the "
                        "graphics driver; on a remote or virtual machine turn on 3D acceleration "
                        "or install Mesa.",
                        reason, foundDriver()));
}

} // namespace

Window::Window(const std::string& title, const glm::ivec2& size) {
  glfwSetErrorCallback(rememberError);
  if (glfwInit() == GLFW_FALSE)
    throw WindowError(say("no window can be opened: {}\nIs there a desktop? On a machine without "
                          "one, run under xvfb-run.",
                          lastError));
  try {
    window_ = open(title, size);
    glfwMakeContextCurrent(window_);
    if (gladLoadGL(glfwGetProcAddress) == 0)
      throw WindowError(say("the functions of OpenGL could not be loaded: {}", lastError));
  } catch (...) {
    if (window_ != nullptr) glfwDestroyWindow(window_);
    if (windows == 0) glfwTerminate();
    throw;
  }
  ++windows;
  detail::forgetPrinted();
  installDebugSink();
  live_ = std::make_unique<detail::Live>(window_, title);
  lives[window_] = live_.get();
  glfwSwapInterval(1);
  glfwSetKeyCallback(window_, onKey);
  glfwSetFramebufferSizeCallback(window_, followSize);
  glViewport(0, 0, width(), height());
}

Window::~Window() {
  lives.erase(window_);
  live_.reset();
  glfwDestroyWindow(window_);
  if (--windows == 0) glfwTerminate();
}

Window::operator bool() const {
  return glfwWindowShouldClose(window_) == GLFW_FALSE;
}

void Window::swapBuffers() {
  live_->frameEnds({width(), height()});
  glfwSwapBuffers(window_);
  glfwPollEvents();
  live_->frameBegins();
}

// A window that is rolled up to an icon has size 0, by which nobody can divide.
int Window::width() const {
  int width = 0;
  glfwGetFramebufferSize(window_, &width, nullptr);
  return std::max(width, 1);
}

int Window::height() const {
  int height = 0;
  glfwGetFramebufferSize(window_, nullptr, &height);
  return std::max(height, 1);
}

} // namespace gg
