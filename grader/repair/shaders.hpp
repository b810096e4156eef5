#pragma once
/// \file
/// What of a shader can be replaced by the reference's, by itself.

#include <set>
#include <string>
#include <vector>

namespace ggrade::repair {

struct ShaderUnit {
  std::string name; ///< of the unit, see Unit: "function main in fragment", "shader fragment"
  bool differs = false;
  std::string source{};          ///< the submission's with this unit as the reference has it
  std::set<std::string> lacks{}; ///< the reference's lines that the submission's lacks
  bool adds = false;             ///< and has the submission's lines that the reference's lacks?
};

/// The units that both sources have: of each function the lines of each step, where both name the
/// same several steps in it, and all of it; last the whole shader.
///   stage: "vertex", "fragment"
std::vector<ShaderUnit> shaderUnits(const std::string& stage, const std::string& source,
                                    const std::string& reference);

} // namespace ggrade::repair
