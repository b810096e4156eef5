#pragma once
/// \file
/// Shaders that are saved while the program runs.

#include <memory>
#include <string>

#include "program_build.hpp"

namespace gg::detail {

/// From now on reloadPrograms() looks after this program, as long as it lives.
void lookAfter(const std::shared_ptr<ProgramState>& state);

/// What a program that is looked after is called, "tile.vert + tile.frag"; of others their number.
std::string labelOf(GLuint program);

/// What became of saved files.
struct Reloaded {
  bool any = false;   ///< was a program built anew?
  std::string errors; ///< of all programs whose files don't compile as they stand; empty: none
};

/// Builds those programs again of which a file was saved, looking at most five times a second. A
/// program whose files don't compile goes on as it was. Both is said on stderr.
Reloaded reloadPrograms();

} // namespace gg::detail
