#pragma once
/// \file
/// Copied pixels as floats.

#include "image/image.hpp"
#include "trace/records.hpp"

#include <cstddef>
#include <span>

namespace ggrade::trace {

/// The value of an IEEE 754 half float, exact; NaN stays NaN, Inf stays Inf.
float halfToFloat(std::uint16_t half);

/// 4 or 1, see PixelType.
int channelsOf(PixelType type);

/// "u8x4", "f16x4", ...: the name in trace.json and on pages.
const char* pixelTypeName(PixelType type);

/// `bytes` holds width x height pixels of `type`, row 0 on top. u8x4 becomes 0 to 1; stencil and
/// integers become whole numbers (exact up to 2^24); floats are as stored. Throws
/// std::invalid_argument unless `bytes` has exactly the size of the image.
Image decodePixels(std::span<const std::byte> bytes, PixelType type, std::uint32_t width,
                   std::uint32_t height);

} // namespace ggrade::trace
