#pragma once

#include <string>
#include <string_view>

namespace ggrade::channel {

/// `text` as valid UTF-8 that is safe to print: every byte that is no part of a character (overlong
/// forms, surrogates and numbers above U+10FFFF included) and every control character but line feed
/// and tab becomes U+FFFD.
std::string sanitizedUtf8(std::string_view text);

} // namespace ggrade::channel
