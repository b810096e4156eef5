#include <gg/program.hpp>

#include <cstdio>

#include "program_build.hpp"
#include "reload.hpp"
#include "words/words.hpp"
#include <gg/platform.hpp>
#include <gg/text_file.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace gg {

namespace {

bool isWordCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool containsWord(const std::string& text, std::string_view word) {
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !isWordCharacter(text[at - 1])) &&
        (end == text.size() || !isWordCharacter(text[end])))
      return true;
  }
  return false;
}

bool isSampler(GLenum type) {
  return (type >= GL_SAMPLER_1D && type <= GL_SAMPLER_2D_RECT_SHADOW) ||
         (type >= GL_SAMPLER_1D_ARRAY && type <= GL_SAMPLER_CUBE_SHADOW) ||
         (type >= GL_INT_SAMPLER_1D && type <= GL_UNSIGNED_INT_SAMPLER_BUFFER) ||
         (type >= GL_SAMPLER_CUBE_MAP_ARRAY && type <= GL_UNSIGNED_INT_SAMPLER_CUBE_MAP_ARRAY) ||
         (type >= GL_SAMPLER_2D_MULTISAMPLE &&
          type <= GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE_ARRAY);
}

// May a value of GLSL type `given` be loaded into a uniform of type `declared`?
// (OpenGL 4.1, 2.11.7)
bool fits(GLenum declared, GLenum given) {
  if (declared == given) return true;
  if (declared == GL_BOOL) return given == GL_INT || given == GL_FLOAT;
  return given == GL_INT && isSampler(declared);
}

std::string typeName(GLenum type) {
  switch (type) {
  case GL_BOOL:
    return "bool";
  case GL_INT:
    return "int";
  case GL_FLOAT:
    return "float";
  case GL_FLOAT_VEC2:
    return "vec2";
  case GL_FLOAT_VEC3:
    return "vec3";
  case GL_FLOAT_VEC4:
    return "vec4";
  case GL_FLOAT_MAT3:
    return "mat3";
  case GL_FLOAT_MAT4:
    return "mat4";
  default:
    return isSampler(type) ? say("sampler") : say("of another type");
  }
}

} // namespace

Program::Program(std::initializer_list<const char*> files, const std::string& folder)
    : state_(std::make_shared<detail::ProgramState>()) {
  state_->files.assign(files.begin(), files.end());
  state_->folder = folder.empty() ? shaderFolder() : fromUtf8(folder);
  detail::build(*state_);
  detail::lookAfter(state_);
}

Program::~Program() = default;
Program::Program(Program&&) noexcept = default;
Program& Program::operator=(Program&&) noexcept = default;

void Program::use() const {
  glUseProgram(state_->name);
}

Program::operator GLuint() const {
  return state_->name;
}

GLint Program::find(std::string_view name, GLenum given) const {
  const auto found = state_->uniforms.find(name);
  if (found == state_->uniforms.end()) {
    // An array's elements beyond the first are not listed.
    const std::string_view base = name.substr(0, name.find_first_of("[."));
    if (base != name) return glGetUniformLocation(state_->name, std::string(name).c_str());
    if (!containsWord(state_->source, name))
      complain(name, say("these shaders have no such uniform"));
    return -1;
  }
  if (!fits(found->second.type, given))
    complain(name, say("is {} in the shader, but was set to a value of type {}",
                       typeName(found->second.type), typeName(given)));
  return found->second.location;
}

void Program::complain(std::string_view name, const std::string& text) const {
  if (state_->complained.contains(name)) return;
  state_->complained.emplace(name);
  std::fprintf(stderr, "%s\n",
               say("{}: warning: uniform \"{}\": {}", state_->label(), name, text).c_str());
}

void Program::set(std::string_view name, bool value) const {
  glProgramUniform1i(state_->name, find(name, GL_BOOL), value ? 1 : 0);
}
void Program::set(std::string_view name, int value) const {
  glProgramUniform1i(state_->name, find(name, GL_INT), value);
}
void Program::set(std::string_view name, float value) const {
  glProgramUniform1f(state_->name, find(name, GL_FLOAT), value);
}
void Program::set(std::string_view name, const glm::vec2& value) const {
  glProgramUniform2fv(state_->name, find(name, GL_FLOAT_VEC2), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::vec3& value) const {
  glProgramUniform3fv(state_->name, find(name, GL_FLOAT_VEC3), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::vec4& value) const {
  glProgramUniform4fv(state_->name, find(name, GL_FLOAT_VEC4), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::mat3& value) const {
  glProgramUniformMatrix3fv(state_->name, find(name, GL_FLOAT_MAT3), 1, GL_FALSE,
                            glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::mat4& value) const {
  glProgramUniformMatrix4fv(state_->name, find(name, GL_FLOAT_MAT4), 1, GL_FALSE,
                            glm::value_ptr(value));
}

} // namespace gg
