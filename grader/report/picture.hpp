#pragma once
/// \file
/// Pictures inside a page.

#include "image/image.hpp"

#include <span>
#include <string>

namespace ggrade::report {

/// RFC 4648 with padding.
std::string base64(std::span<const unsigned char> bytes);

/// `data:image/png;base64,...`; empty for an empty image. Alpha is left out: a window's alpha
/// cannot be seen.
std::string pngDataUri(const Image& image);

/// The image shrunk by an area average to fit into `maxWidth x maxHeight` pixels, RGB. Never
/// enlarges. An empty image stays empty.
Image thumbnail(const Image& image, int maxWidth, int maxHeight);

} // namespace ggrade::report
