#include <gg/debug.hpp>

#include <cstdlib>
#include <string>
#include <string_view>

#include "doctor_state.hpp"
#include "print_once.hpp"
#include "words/words.hpp"
#include <gg/gl.hpp>

namespace gg {

namespace {

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
  detail::printOnce((type == GL_DEBUG_TYPE_ERROR ? say("OpenGL: error: {}", text)
                                                 : say("OpenGL: warning: {}", text)) +
                    detail::lastPlace());
}

} // namespace

void installDebugSink() {
  const char* setting = std::getenv("GG_DEBUG_OUTPUT");
  const bool wanted = setting == nullptr || std::string_view(setting) != "0";
  sinkInstalled = wanted && GLAD_GL_KHR_debug != 0 && glad_glDebugMessageCallback != nullptr;
  if (!sinkInstalled) return;
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(receive, nullptr);
}

bool hasDebugSink() {
  return sinkInstalled;
}

void reportErrors(const char* where) {
  if (sinkInstalled) return;
  constexpr int kMost = 8; // a lost context reports errors without end
  for (int i = 0; i < kMost; ++i) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    detail::printOnce(say("OpenGL: error: {} in {}", detail::errorName(error), where));
  }
}

} // namespace gg
