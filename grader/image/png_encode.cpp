#include "image/png.hpp"

#include "image/temporary_file.hpp"

#include <png.h>

#include <cmath>
#include <stdexcept>

namespace ggrade {
namespace {

unsigned char byteFrom(float value) {
  // Also true for NaN, which has no byte of its own.
  if (!(value > 0)) return 0;
  return value >= 1 ? 255 : static_cast<unsigned char>(value * 255.0f + 0.5f);
}

png_uint_32 formatOf(const Image& image) {
  switch (image.channels()) {
  case 1:
    return PNG_FORMAT_GRAY;
  case 3:
    return PNG_FORMAT_RGB;
  case 4:
    return PNG_FORMAT_RGBA;
  default:
    throw std::invalid_argument("encodePng: a PNG has 1, 3 or 4 channels, not " +
                                std::to_string(image.channels()));
  }
}

} // namespace

std::vector<unsigned char> encodePng(const Image& image, PngEffort effort) {
  if (image.empty()) throw std::invalid_argument("encodePng: the image is empty");
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = png_uint_32(image.width());
  png.height = png_uint_32(image.height());
  png.format = formatOf(image);
  if (effort == PngEffort::fast) png.flags = PNG_IMAGE_FLAG_FAST;

  std::vector<unsigned char> pixels;
  pixels.reserve(image.values().size());
  for (const float value : image.values()) pixels.push_back(byteFrom(value));

  // Room for the worst case saves compressing twice only to learn the size.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::vector<unsigned char> file(size);
  if (!png_image_write_to_memory(&png, file.data(), &size, 0, pixels.data(), 0, nullptr))
    throw std::runtime_error(std::string("encodePng: ") + png.message);
  file.resize(size);
  return file;
}

void writePng(const std::filesystem::path& path, const Image& image, PngEffort effort) {
  writeWholeFile(path, encodePng(image, effort));
}

} // namespace ggrade
