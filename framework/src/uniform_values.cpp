#include "uniform_values.hpp"

namespace gg::detail {

namespace {

bool isFloat(GLenum type) {
  return type == GL_FLOAT || (type >= GL_FLOAT_VEC2 && type <= GL_FLOAT_VEC4) ||
         (type >= GL_FLOAT_MAT2 && type <= GL_FLOAT_MAT4) ||
         (type >= GL_FLOAT_MAT2x3 && type <= GL_FLOAT_MAT4x3);
}

// Calls function(name, location) for a uniform, or for each element of an array.
template <class Function>
void eachElement(GLuint program, const std::string& name, const Uniform& uniform,
                 Function function) {
  const std::size_t bracket = name.ends_with("[0]") ? name.size() - 3 : name.npos;
  if (bracket == name.npos) return function(name, uniform.location);
  for (int i = 0;; ++i) {
    const std::string element = name.substr(0, bracket) + "[" + std::to_string(i) + "]";
    const GLint location = glGetUniformLocation(program, element.c_str());
    if (location < 0) return;
    function(element, location);
  }
}

void set(GLuint program, GLint location, const UniformValue& value) {
  const float* f = value.floats.data();
  const GLint* i = value.integers.data();
  switch (value.type) {
  case GL_FLOAT:
    return glProgramUniform1fv(program, location, 1, f);
  case GL_FLOAT_VEC2:
    return glProgramUniform2fv(program, location, 1, f);
  case GL_FLOAT_VEC3:
    return glProgramUniform3fv(program, location, 1, f);
  case GL_FLOAT_VEC4:
    return glProgramUniform4fv(program, location, 1, f);
  case GL_FLOAT_MAT2:
    return glProgramUniformMatrix2fv(program, location, 1, GL_FALSE, f);
  case GL_FLOAT_MAT3:
    return glProgramUniformMatrix3fv(program, location, 1, GL_FALSE, f);
  case GL_FLOAT_MAT4:
    return glProgramUniformMatrix4fv(program, location, 1, GL_FALSE, f);
  case GL_INT_VEC2:
  case GL_BOOL_VEC2:
    return glProgramUniform2iv(program, location, 1, i);
  case GL_INT_VEC3:
  case GL_BOOL_VEC3:
    return glProgramUniform3iv(program, location, 1, i);
  case GL_INT_VEC4:
  case GL_BOOL_VEC4:
    return glProgramUniform4iv(program, location, 1, i);
  case GL_UNSIGNED_INT:
    return glProgramUniform1ui(program, location, static_cast<GLuint>(i[0]));
  default: // int, bool, samplers; matrices that aren't square stay 0
    if (!isFloat(value.type)) glProgramUniform1iv(program, location, 1, i);
  }
}

} // namespace

UniformValues uniformValues(GLuint program, const Uniforms& uniforms) {
  UniformValues values;
  for (const auto& [name, uniform] : uniforms)
    eachElement(program, name, uniform, [&](const std::string& element, GLint location) {
      UniformValue& value = values[element];
      value.type = uniform.type;
      if (isFloat(value.type))
        glGetUniformfv(program, location, value.floats.data());
      else
        glGetUniformiv(program, location, value.integers.data());
    });
  return values;
}

void restore(GLuint program, const Uniforms& uniforms, const UniformValues& values) {
  for (const auto& [name, uniform] : uniforms)
    eachElement(program, name, uniform, [&](const std::string& element, GLint location) {
      const auto before = values.find(element);
      if (before != values.end() && before->second.type == uniform.type)
        set(program, location, before->second);
    });
}

} // namespace gg::detail
