#pragma once
/// \file
/// A program's uniforms, kept while it is linked again.

#include <array>
#include <map>
#include <string>

#include "program_build.hpp"

namespace gg::detail {

/// One number, vector or matrix, as floats or whole numbers by its type.
struct UniformValue {
  GLenum type;
  std::array<float, 16> floats{};
  std::array<GLint, 4> integers{};
};
using UniformValues = std::map<std::string, UniformValue>; ///< by name; an array's elements apart

UniformValues uniformValues(GLuint program, const Uniforms& uniforms);

/// Those that are still there, with the type that they had.
void restore(GLuint program, const Uniforms& uniforms, const UniformValues& values);

} // namespace gg::detail
