#pragma once

#include <string>

#include <gg/texture.hpp>

namespace gg::detail {

/// A character and the space around it, pixels.
inline constexpr int kCharacterWidth = 6, kLineHeight = 9;

/// White letters on black. What isn't ASCII is shown as `?`.
///   columns: characters in a line at most; longer ones go on in the next
Image textImage(const std::string& text, int columns);

} // namespace gg::detail
