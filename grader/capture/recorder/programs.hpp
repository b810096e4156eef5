#pragma once
/// \file
/// What GL answers about programs: their samplers with the textures that these sample now, their
/// mat4 uniforms with the values that they have now. The context must be current.

#include "trace/records.hpp"

#include <GL/gl.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ggrade::capture::recorder {

/// Names of a uniform are cut to what a record holds.
using UniformName = std::array<char, sizeof(trace::MatrixRecord::name)>;
using Matrix = std::array<float, 16>; ///< column by column

struct ProgramInfo {
  struct Sampler { ///< each element of an array is one
    GLint location;
    GLenum target; ///< GL_TEXTURE_2D, ...
    UniformName name;
  };
  struct MatrixUniform { ///< each element of an array is one
    GLint location;      ///< -1 in a block
    GLuint block;        ///< only if in a block, as the rest
    GLint offset;
    GLint stride;
    bool rowMajor;
    UniformName name;
  };
  std::vector<Sampler> samplers;
  std::vector<MatrixUniform> matrices;
  std::vector<GLint> images; ///< locations of the image uniforms
  std::uint32_t outputs = 0; ///< see outputsOf
};

/// Mask of the outputs that a program's fragment shader writes: of one that it never writes there
/// is none for the linker, declared or not.
std::uint32_t outputsOf(GLuint program);

/// Programs are asked once, until they are linked anew.
class Programs {
public:
  const ProgramInfo& info(std::uint32_t group, GLuint program);
  void forget(std::uint32_t group, GLuint program) { infos_.erase({group, program}); }

private:
  std::map<std::pair<std::uint32_t, GLuint>, ProgramInfo> infos_;
};

/// The program in use, or those of the bound pipeline, each once; empty if there is none. The
/// fragment stage's comes first.
std::vector<GLuint> currentPrograms();

/// False when the value can't be had, as when its block has no buffer.
bool readMatrix(GLuint program, const ProgramInfo::MatrixUniform& uniform, Matrix& value);

/// What a sampler samples now; `writer` and `feedback` are left to the caller. `lastLevel` is the
/// last level that can be sampled.
trace::SampleRecord readSample(GLuint program, const ProgramInfo::Sampler& sampler,
                               std::uint32_t& lastLevel);

} // namespace ggrade::capture::recorder
