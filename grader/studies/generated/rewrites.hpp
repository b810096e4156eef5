#pragma once
/// \file
/// Right programs that nobody has thought of: a right one, with changes that keep what it means, as
/// GLFuzz makes them (Donaldson et al.: "Automated Testing of Graphics Shader Compilers", OOPSLA
/// 2017): dead and live code, identities, control flow, packed vectors; in C++ also wrapped and
/// repeated calls, other names, another order of calls that don't depend on each other.

#include "generated/chance.hpp"

#include <string>
#include <vector>

namespace ggrade::generated {

/// A file's text, and what was done to it.
struct Rewritten {
  std::string text;
  std::vector<std::string> changes; ///< "mirror.hpp:57: runs once in a loop"
};

/// Up to `count` changes of lines in blocks that students write, one after the other, in places
/// that are drawn. `file` is the text's name; its ending tells GLSL from C++. Throws UsageError for
/// blocks that aren't closed.
Rewritten rewrite(std::string text, const std::string& file, std::size_t count, Chance& chance);

} // namespace ggrade::generated
