#pragma once
/// \file
/// What a driver's compiler says, in the words of the student's own files.

#include <string>
#include <string_view>

#include "shader_source.hpp"

namespace gg::detail {

/// Rewrites a compiler's log as `file:line:column: error: message`, the line itself, and a caret
/// under the column. Understands the logs of Mesa, NVIDIA, AMD, Intel and Apple; a line in no known
/// form stays as it is. NVIDIA, AMD, Intel and Apple give no column, so there is no caret.
///   onlyWarnings: leave out all but warnings (for the log of a shader that compiled)
std::string translateLog(std::string_view log, const ShaderSource& source,
                         bool onlyWarnings = false);

} // namespace gg::detail
