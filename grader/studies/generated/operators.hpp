#pragma once
/// \file
/// What one line of C++ or GLSL can become by a mistake.

#include <string>
#include <vector>

namespace ggrade::generated {

/// A kind of change.
struct Operator {
  std::string name; ///< "drops a sign"
  /// Every way to change a line so; strings and comments stay as they are.
  std::vector<std::string> (*apply)(const std::string& line);
};

/// All kinds that look at one line alone.
const std::vector<Operator>& operators();

} // namespace ggrade::generated
