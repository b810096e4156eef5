#pragma once
/// \file
/// PNG files from and to plain floats, without OpenImageIO.

#include "image/image.hpp"

#include <filesystem>
#include <span>
#include <vector>

namespace ggrade {

/// How much time to spend on a smaller file.
enum class PngEffort { normal, fast };

/// The bytes of an 8-bit PNG file: 1, 3 or 4 channels, values clamped to 0 to 1 and rounded, NaN
/// written as 0, no conversion of colour (the values are taken to be display values, alpha not
/// multiplied in). Throws std::invalid_argument for an empty image or 2 channels,
/// std::runtime_error if libpng refuses.
std::vector<unsigned char> encodePng(const Image& image, PngEffort effort = PngEffort::normal);

/// Writes `encodePng(image)`, whole or not at all. Throws std::runtime_error with the path and the
/// cause.
void writePng(const std::filesystem::path& path, const Image& image,
              PngEffort effort = PngEffort::normal);

/// The values as stored, 8 or 16 bits to 0 to 1; no gamma is applied. Palettes become RGB, grey
/// with alpha RGBA. Throws std::runtime_error saying what is wrong with the data (too short, not a
/// PNG, too large).
Image decodePng(std::span<const unsigned char> bytes);

/// Reads a file through `decodePng`. Throws std::runtime_error with the path and the cause.
Image readPng(const std::filesystem::path& path);

} // namespace ggrade
