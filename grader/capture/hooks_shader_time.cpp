// Adds up the time spent in compiling and linking. Mesa may leave work until a status is asked for.

#include "capture/channel_writer.hpp"
#include "capture/gl_hooks.hpp"

#include <GL/gl.h>
#include <GL/glext.h>

#include <chrono>

namespace ggrade::capture {
namespace {

class Timer {
public:
  Timer() : start_(std::chrono::steady_clock::now()) {}
  ~Timer() {
    addShaderSeconds(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count());
  }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

private:
  std::chrono::steady_clock::time_point start_;
};

decltype(&glCompileShader) nextCompileShader;
void APIENTRY hookCompileShader(GLuint shader) {
  const Timer timer;
  nextCompileShader(shader);
}

decltype(&glLinkProgram) nextLinkProgram;
void APIENTRY hookLinkProgram(GLuint program) {
  const Timer timer;
  nextLinkProgram(program);
}

decltype(&glCreateShaderProgramv) nextCreateShaderProgramv;
GLuint APIENTRY hookCreateShaderProgramv(GLenum type, GLsizei count, const GLchar* const* strings) {
  const Timer timer;
  return nextCreateShaderProgramv(type, count, strings);
}

decltype(&glGetProgramiv) nextGetProgramiv;
void APIENTRY hookGetProgramiv(GLuint program, GLenum name, GLint* value) {
  const Timer timer;
  nextGetProgramiv(program, name, value);
}

decltype(&glGetShaderiv) nextGetShaderiv;
void APIENTRY hookGetShaderiv(GLuint shader, GLenum name, GLint* value) {
  const Timer timer;
  nextGetShaderiv(shader, name, value);
}

const Hook kShaderTimeHooks[] = {
    GG_HOOK(glCompileShader, hookCompileShader, nextCompileShader),
    GG_HOOK(glLinkProgram, hookLinkProgram, nextLinkProgram),
    GG_HOOK(glCreateShaderProgramv, hookCreateShaderProgramv, nextCreateShaderProgramv),
    GG_HOOK(glGetProgramiv, hookGetProgramiv, nextGetProgramiv),
    GG_HOOK(glGetShaderiv, hookGetShaderiv, nextGetShaderiv),
};

} // namespace

std::span<const Hook> shaderTimeHooks() {
  return kShaderTimeHooks;
}

} // namespace ggrade::capture
