#include "replay/player/objects.hpp"

#include <stdexcept>

namespace ggrade::player {

namespace {

GLenum stageOf(const std::string& name) {
  if (name == "vertex") return GL_VERTEX_SHADER;
  if (name == "fragment") return GL_FRAGMENT_SHADER;
  if (name == "geometry") return GL_GEOMETRY_SHADER;
  if (name == "tessControl") return GL_TESS_CONTROL_SHADER;
  if (name == "tessEvaluation") return GL_TESS_EVALUATION_SHADER;
  throw std::runtime_error("a shader of an unknown stage");
}

} // namespace

GLuint Programs::at(const json& definition) {
  const auto [at, isNew] = programs_.try_emplace(definition.dump(), 0);
  GLuint& program = at->second;
  if (!isNew) return program;
  program = gl().createProgram();
  for (const json& stage : definition.at("stages")) {
    const std::vector<std::byte>& source = blobOf(tape_, stage.at("blob"));
    const GLuint shader = gl().createShader(stageOf(stage.at("stage")));
    const auto* text = reinterpret_cast<const GLchar*>(source.data());
    const auto length = GLint(source.size());
    gl().shaderSource(shader, 1, &text, &length);
    gl().compileShader(shader);
    gl().attachShader(program, shader);
    gl().deleteShader(shader);
  }
  for (const auto& [name, location] : definition.at("attributes").items())
    gl().bindAttribLocation(program, location, name.c_str());
  for (const auto& [name, location] : definition.at("outputs").items())
    gl().bindFragDataLocation(program, location, name.c_str());
  gl().linkProgram(program);
  return program;
}

} // namespace ggrade::player
