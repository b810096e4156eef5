#pragma once
/// \file
/// The framework's own shaders, as text. Made from framework/shaders at build time.

#include <functional>
#include <map>
#include <string>

namespace gg::detail {

/// From the name to include (gg/lighting.glsl) to the text.
const std::map<std::string, std::string, std::less<>>& builtinShaders();

} // namespace gg::detail
