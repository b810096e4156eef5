#pragma once
/// \file
/// What a shader has no output for becomes undefined in the colour buffers that are drawn into
/// (OpenGL 4.6, 15.2.3: on these machines, whatever the memory held). Here it stays as it was, so
/// that a program draws the same each time that it runs, recorded or not.

#include <GL/gl.h>

#include <array>
#include <utility>
#include <vector>

namespace ggrade::capture::recorder {

/// For one draw: keeps the colour buffers that the program in use has no output for from being
/// written. The context must be current.
class DefinedOutputs {
public:
  DefinedOutputs();
  ~DefinedOutputs();
  DefinedOutputs(const DefinedOutputs&) = delete;
  DefinedOutputs& operator=(const DefinedOutputs&) = delete;

private:
  std::vector<std::pair<GLuint, std::array<GLboolean, 4>>> masks_; ///< the program's own
};

} // namespace ggrade::capture::recorder
