#include "program_build.hpp"

#include <cstdio>

#include "shader_log.hpp"
#include "shader_source.hpp"
#include "uniform_values.hpp"
#include "words/words.hpp"
#include <fmt/format.h>
#include <gg/error.hpp>
#include <gg/light.hpp>
#include <gg/text_file.hpp>

namespace gg::detail {

namespace {

GLenum stageOf(const std::string& file) {
  const std::string ending = file.substr(std::min(file.rfind('.'), file.size()));
  if (ending == ".vert") return GL_VERTEX_SHADER;
  if (ending == ".tesc") return GL_TESS_CONTROL_SHADER;
  if (ending == ".tese") return GL_TESS_EVALUATION_SHADER;
  if (ending == ".geom") return GL_GEOMETRY_SHADER;
  if (ending == ".frag") return GL_FRAGMENT_SHADER;
  throw ShaderError(
      say("{}: error: the name must end in .vert, .tesc, .tese, .geom or .frag", file));
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
std::string addStage(GLuint program, const std::string& file, const ShaderSource& source) {
  const Shader shader(stageOf(file));
  const char* text = source.text.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  const std::string log = infoLog(shader, glGetShaderiv, glGetShaderInfoLog);
  if (compiled == GL_TRUE) {
    constexpr bool kOnlyWarnings = true;
    std::fputs(translateLog(log, source, kOnlyWarnings).c_str(), stderr);
    glAttachShader(program, shader);
    return {};
  }
  const std::string errors = translateLog(log, source);
  return errors.empty() ? say("{}: error: does not compile, and the driver doesn't say why\n", file)
                        : errors;
}

void link(GLuint program, const std::string& label) {
  glLinkProgram(program);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return;
  std::string log = infoLog(program, glGetProgramiv, glGetProgramInfoLog);
  while (!log.empty() && (log.back() == '\n' || log.back() == '\0')) log.pop_back();
  if (log.starts_with("error: ")) log.erase(0, 7);
  throw ShaderError(say("{}: error: does not link: {}", label, log));
}

std::vector<GLuint> attachedShaders(GLuint program) {
  GLint count = 0;
  glGetProgramiv(program, GL_ATTACHED_SHADERS, &count);
  std::vector<GLuint> shaders(static_cast<std::size_t>(count));
  glGetAttachedShaders(program, count, &count, shaders.data());
  return shaders;
}

void findUniforms(ProgramState& state) {
  state.uniforms.clear();
  GLint count = 0;
  glGetProgramiv(state.name, GL_ACTIVE_UNIFORMS, &count);
  for (GLint i = 0; i < count; ++i) {
    char name[256];
    GLint size = 0;
    GLenum type = 0;
    glGetActiveUniform(state.name, static_cast<GLuint>(i), sizeof(name), nullptr, &size, &type,
                       name);
    const GLint location = glGetUniformLocation(state.name, name);
    if (location >= 0) state.uniforms[name] = {location, type};
  }
}

void bindBlock(GLuint program, const char* name, GLuint binding) {
  const GLuint index = glGetUniformBlockIndex(program, name);
  if (index != GL_INVALID_INDEX) glUniformBlockBinding(program, index, binding);
}

void addWatched(std::vector<WatchedFile>& watched, const ShaderSource& source,
                const std::filesystem::path& folder) {
  for (const ShaderFile& file : source.files) {
    const std::filesystem::path path = folder / fromUtf8(file.name);
    std::error_code error;
    const auto saved = std::filesystem::last_write_time(path, error);
    if (!error) watched.push_back({path, saved}); // the framework's own shaders are no files
  }
}

struct Stages {
  std::string text;
  std::vector<WatchedFile> watched;
};

// Compiles all stages and attaches them to `program`.
Stages compile(GLuint program, const ProgramState& state) {
  Stages stages;
  std::string errors;
  for (const std::string& file : state.files) {
    stageOf(file);
    const ShaderSource source = readShader(file, state.folder);
    stages.text += source.text;
    addWatched(stages.watched, source, state.folder);
    errors += addStage(program, file, source);
  }
  if (!errors.empty()) throw ShaderError(errors.substr(0, errors.size() - 1));
  return stages;
}

// What is known of a program once it is linked.
void finish(ProgramState& state, Stages stages) {
  state.source = std::move(stages.text);
  state.watched = std::move(stages.watched);
  findUniforms(state);
  bindBlock(state.name, "Light", kLightBinding);
  bindBlock(state.name, "Material", kMaterialBinding);
}

} // namespace

std::string ProgramState::label() const {
  return fmt::format("{}", fmt::join(files, " + "));
}

void build(ProgramState& state) {
  Stages stages = compile(state.name, state);
  link(state.name, state.label());
  finish(state, std::move(stages));
}

void rebuild(ProgramState& state) {
  // Tried apart: a program that fails to link can't be drawn with any more.
  const Handle<ProgramTraits> trial;
  Stages stages = compile(trial, state);
  link(trial, state.label());
  const UniformValues values = uniformValues(state.name, state.uniforms);
  for (const GLuint shader : attachedShaders(state.name)) glDetachShader(state.name, shader);
  for (const GLuint shader : attachedShaders(trial)) glAttachShader(state.name, shader);
  link(state.name, state.label());
  finish(state, std::move(stages));
  restore(state.name, state.uniforms, values);
}

} // namespace gg::detail
