#pragma once
/// \file
/// Image files of every format that OpenImageIO knows, and OpenImageIO's own comparison as a
/// cross-check.

#include "image/image.hpp"
#include "image/statistics.hpp"

#include <filesystem>

namespace ggrade {

/// An image and what its file says about it.
struct FileImage {
  Image image;         ///< values as stored: integers become 0 to 1, alpha is not multiplied in
  int parts = 1;       ///< 2 if the file holds more than the first image, which is the one read
  bool floats = false; ///< stored as floats: linear light of any range, not display values
};

/// Reads the first image of a file, over its whole display window (outside the stored pixels 0).
/// Throws std::runtime_error with the path, the cause and a remedy: no such file, a folder, empty,
/// cut short, unknown format, more than 4 channels or Image::kMaxSide pixels a side.
FileImage readImageFile(const std::filesystem::path& path);

/// Writes an image in the format that the extension names (.png 8 bit, .exr 32-bit float, ...),
/// whole or not at all. Throws std::runtime_error with the path and the cause.
void writeImageFile(const std::filesystem::path& path, const Image& image);

/// `errorStatistics` as OpenImageIO computes it (ImageBufAlgo::compare): a second opinion for
/// tests. Throws std::runtime_error if OpenImageIO refuses. Blind to NaN, unlike everything else
/// here.
ErrorStatistics openImageIoStatistics(const Image& a, const Image& b, float fail, float warn);

} // namespace ggrade
