#include <gg/debug.hpp>

#include <cstdio>
#include <set>
#include <string>

#include <gg/gl.hpp>

namespace gg {

namespace {

// A message that comes every frame is news once.
void printOnce(const std::string& text) {
  constexpr std::size_t kMost = 100;
  static std::set<std::string> printed;
  if (printed.size() < kMost && printed.insert(text).second)
    std::fprintf(stderr, "OpenGL: %s\n", text.c_str());
}

bool sinkInstalled = false;

bool matters(GLenum source, GLenum type, GLenum severity) {
  // Program says the same with the file's own name and line.
  if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return false;
  switch (type) {
  case GL_DEBUG_TYPE_ERROR:
  case GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR:
    return true;
  case GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR:
  case GL_DEBUG_TYPE_PORTABILITY:
    return severity != GL_DEBUG_SEVERITY_NOTIFICATION;
  default: // performance hints and shader compiler statistics say little to a beginner
    return severity == GL_DEBUG_SEVERITY_HIGH;
  }
}

void GLAD_API_PTR receive(GLenum source, GLenum type, GLuint, GLenum severity, GLsizei length,
                          const GLchar* message, const void*) {
  if (!matters(source, type, severity)) return;
  std::string text =
      length < 0 ? std::string(message) : std::string(message, static_cast<std::size_t>(length));
  while (!text.empty() && (text.back() == '\n' || text.back() == '\0')) text.pop_back();
  printOnce((type == GL_DEBUG_TYPE_ERROR ? "error: " : "warning: ") + text);
}

const char* errorName(GLenum error) {
  switch (error) {
  case GL_INVALID_ENUM:
    return "GL_INVALID_ENUM (a constant that the function doesn't know)";
  case GL_INVALID_VALUE:
    return "GL_INVALID_VALUE (a number out of range)";
  case GL_INVALID_OPERATION:
    return "GL_INVALID_OPERATION (not allowed in the present state)";
  case GL_INVALID_FRAMEBUFFER_OPERATION:
    return "GL_INVALID_FRAMEBUFFER_OPERATION (the framebuffer object is not complete)";
  case GL_OUT_OF_MEMORY:
    return "GL_OUT_OF_MEMORY";
  default:
    return "an unknown error";
  }
}

} // namespace

void installDebugSink() {
  sinkInstalled = GLAD_GL_KHR_debug != 0 && glDebugMessageCallback != nullptr;
  if (!sinkInstalled) return;
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(receive, nullptr);
}

void reportErrors(const char* where) {
  if (sinkInstalled) return;
  constexpr int kMost = 8; // a lost context reports errors without end
  for (int i = 0; i < kMost; ++i) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    printOnce(std::string("error: ") + errorName(error) + " in " + where);
  }
}

} // namespace gg
