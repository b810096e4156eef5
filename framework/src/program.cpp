#include <gg/program.hpp>

#include <cstdio>
#include <vector>

#include "shader_log.hpp"
#include "shader_source.hpp"
#include <fmt/format.h>
#include <gg/error.hpp>
#include <gg/light.hpp>
#include <gg/platform.hpp>
#include <gg/text_file.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace gg {

namespace {

GLenum stageOf(const std::string& file) {
  const std::string ending = file.substr(std::min(file.rfind('.'), file.size()));
  if (ending == ".vert") return GL_VERTEX_SHADER;
  if (ending == ".tesc") return GL_TESS_CONTROL_SHADER;
  if (ending == ".tese") return GL_TESS_EVALUATION_SHADER;
  if (ending == ".geom") return GL_GEOMETRY_SHADER;
  if (ending == ".frag") return GL_FRAGMENT_SHADER;
  throw ShaderError(file + ": error: the name must end in .vert, .tesc, .tese, .geom or .frag");
}

// A shader object, which lives only until the program is linked.
class Shader {
public:
  explicit Shader(GLenum stage) : name_(glCreateShader(stage)) {}
  ~Shader() { glDeleteShader(name_); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
  operator GLuint() const { return name_; }

private:
  GLuint name_;
};

template <class GetParameter, class GetLog>
std::string infoLog(GLuint object, GetParameter getParameter, GetLog getLog) {
  GLint length = 0;
  getParameter(object, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  GLsizei written = 0;
  getLog(object, static_cast<GLsizei>(log.size()), &written, log.data());
  log.resize(static_cast<std::size_t>(std::max(written, 0)));
  return log;
}

// Compiles one stage into `program`. Returns what the compiler complains about, if it fails.
std::string addStage(GLuint program, const std::string& file, const detail::ShaderSource& source) {
  const Shader shader(stageOf(file));
  const char* text = source.text.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  const std::string log = infoLog(shader, glGetShaderiv, glGetShaderInfoLog);
  if (compiled == GL_TRUE) {
    constexpr bool kOnlyWarnings = true;
    std::fputs(detail::translateLog(log, source, kOnlyWarnings).c_str(), stderr);
    glAttachShader(program, shader);
    return {};
  }
  const std::string errors = detail::translateLog(log, source);
  return errors.empty() ? file + ": error: does not compile, and the driver doesn't say why\n"
                        : errors;
}

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

const char* typeName(GLenum type) {
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
    return isSampler(type) ? "sampler" : "of another type";
  }
}

} // namespace

Program::Program(std::initializer_list<const char*> files, const std::string& folder) {
  const std::filesystem::path from = folder.empty() ? programFolder() : fromUtf8(folder);
  std::string errors;
  for (const std::string file : files) {
    files_ += (files_.empty() ? "" : " + ") + file;
    stageOf(file);
    const detail::ShaderSource source = detail::readShader(file, from);
    source_ += source.text;
    errors += addStage(program_, file, source);
  }
  if (!errors.empty()) throw ShaderError(errors.substr(0, errors.size() - 1));

  glLinkProgram(program_);
  GLint linked = GL_FALSE;
  glGetProgramiv(program_, GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) {
    std::string log = infoLog(program_, glGetProgramiv, glGetProgramInfoLog);
    while (!log.empty() && (log.back() == '\n' || log.back() == '\0')) log.pop_back();
    if (log.starts_with("error: ")) log.erase(0, 7);
    throw ShaderError(fmt::format("{}: error: does not link: {}", files_, log));
  }
  findUniforms();
  bindBlock("Light", kLightBinding);
  bindBlock("Material", kMaterialBinding);
}

void Program::findUniforms() {
  GLint count = 0;
  glGetProgramiv(program_, GL_ACTIVE_UNIFORMS, &count);
  for (GLint i = 0; i < count; ++i) {
    char name[256];
    GLint size = 0;
    GLenum type = 0;
    glGetActiveUniform(program_, static_cast<GLuint>(i), sizeof(name), nullptr, &size, &type, name);
    const GLint location = glGetUniformLocation(program_, name);
    if (location >= 0) uniforms_[name] = {location, type};
  }
}

void Program::bindBlock(const char* name, GLuint binding) {
  const GLuint index = glGetUniformBlockIndex(program_, name);
  if (index != GL_INVALID_INDEX) glUniformBlockBinding(program_, index, binding);
}

GLint Program::find(std::string_view name, GLenum given) const {
  const auto found = uniforms_.find(name);
  if (found == uniforms_.end()) {
    // An array's elements beyond the first are not listed.
    const std::string_view base = name.substr(0, name.find_first_of("[."));
    if (base != name) return glGetUniformLocation(program_, std::string(name).c_str());
    if (!containsWord(source_, name)) complain(name, "these shaders have no such uniform");
    return -1;
  }
  if (!fits(found->second.type, given))
    complain(name, fmt::format("is {} in the shader, but was set to a value of type {}",
                               typeName(found->second.type), typeName(given)));
  return found->second.location;
}

void Program::complain(std::string_view name, const std::string& text) const {
  if (complained_.contains(name)) return;
  complained_.emplace(name);
  std::fprintf(stderr, "%s: warning: uniform \"%s\": %s\n", files_.c_str(),
               std::string(name).c_str(), text.c_str());
}

void Program::set(std::string_view name, bool value) const {
  glProgramUniform1i(program_, find(name, GL_BOOL), value ? 1 : 0);
}
void Program::set(std::string_view name, int value) const {
  glProgramUniform1i(program_, find(name, GL_INT), value);
}
void Program::set(std::string_view name, float value) const {
  glProgramUniform1f(program_, find(name, GL_FLOAT), value);
}
void Program::set(std::string_view name, const glm::vec2& value) const {
  glProgramUniform2fv(program_, find(name, GL_FLOAT_VEC2), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::vec3& value) const {
  glProgramUniform3fv(program_, find(name, GL_FLOAT_VEC3), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::vec4& value) const {
  glProgramUniform4fv(program_, find(name, GL_FLOAT_VEC4), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::mat3& value) const {
  glProgramUniformMatrix3fv(program_, find(name, GL_FLOAT_MAT3), 1, GL_FALSE,
                            glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::mat4& value) const {
  glProgramUniformMatrix4fv(program_, find(name, GL_FLOAT_MAT4), 1, GL_FALSE,
                            glm::value_ptr(value));
}

} // namespace gg
