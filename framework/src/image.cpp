#include <gg/texture.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "words/words.hpp"
#include <gg/error.hpp>
#include <gg/text_file.hpp>
#include <png.h>

namespace gg {

namespace {

std::uint8_t toByte(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255));
}

Image blank(int size) {
  if (size < 1) throw std::invalid_argument("an image has at least one pixel");
  return {size, size, std::vector<std::uint8_t>(4 * static_cast<std::size_t>(size) * size, 255)};
}

void setPixel(Image& image, int x, int y, const glm::vec3& color) {
  std::uint8_t* pixel = &image.rgba[4 * (static_cast<std::size_t>(y) * image.width + x)];
  for (int i = 0; i < 3; ++i) pixel[i] = toByte(color[i]);
}

// A number from 0 to 1 that belongs to a lattice point (the finalizer of MurmurHash3).
float lattice(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
  std::uint32_t h = seed + x * 0x9E3779B1u + y * 0x85EBCA77u;
  h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
  h = (h ^ (h >> 13)) * 0xC2B2AE35u;
  h ^= h >> 16;
  return static_cast<float>(h >> 8) / 16777215.0f;
}

// Value noise at (u, v) in 0 to 1, which repeats after `cells` cells.
float noise(float u, float v, std::uint32_t cells, std::uint32_t seed) {
  const float x = u * static_cast<float>(cells), y = v * static_cast<float>(cells);
  const float fx = std::floor(x), fy = std::floor(y);
  const auto smooth = [](float t) { return t * t * (3 - 2 * t); };
  const float a = smooth(x - fx), b = smooth(y - fy);
  const auto at = [&](std::uint32_t i, std::uint32_t j) {
    return lattice((static_cast<std::uint32_t>(fx) + i) % cells,
                   (static_cast<std::uint32_t>(fy) + j) % cells, seed);
  };
  return (1 - b) * ((1 - a) * at(0, 0) + a * at(1, 0)) + b * ((1 - a) * at(0, 1) + a * at(1, 1));
}

} // namespace

Image checkerImage(int size, int squares, const glm::vec3& a, const glm::vec3& b) {
  Image image = blank(size);
  if (squares < 1 || squares > size)
    throw std::invalid_argument("a chequerboard has at least one square, and a pixel for each");
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const long long column = static_cast<long long>(x) * squares / size;
      const long long row = static_cast<long long>(y) * squares / size;
      setPixel(image, x, y, (column + row) % 2 == 0 ? a : b);
    }
  }
  return image;
}

Image noiseImage(int size, int cells, int octaves, std::uint32_t seed) {
  Image image = blank(size);
  if (cells < 1 || octaves < 1 || octaves > 16)
    throw std::invalid_argument("noise has at least one cell and 1 to 16 octaves");
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(size);
      const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(size);
      float sum = 0, weight = 0, amplitude = 1;
      for (int octave = 0; octave < octaves; ++octave, amplitude /= 2) {
        sum += amplitude * noise(u, v, static_cast<std::uint32_t>(cells) << octave,
                                 seed + static_cast<std::uint32_t>(octave));
        weight += amplitude;
      }
      setPixel(image, x, y, glm::vec3(sum / weight));
    }
  }
  return image;
}

Image readPng(const std::string& file) {
  // From memory: libpng opens names in the system's own encoding only.
  const std::string bytes = readFile(fromUtf8(file));
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0)
    throw FileError(say("{}: is not a PNG image: {}", file, png.message));
  constexpr png_uint_32 kLargest = 16384;
  if (png.width > kLargest || png.height > kLargest) {
    png_image_free(&png);
    throw FileError(say("{}: is larger than 16384 pixels", file));
  }
  png.format = PNG_FORMAT_RGBA;
  Image image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
  image.rgba.resize(PNG_IMAGE_SIZE(png));
  // A negative stride: the file's first row is the picture's top, which is OpenGL's last.
  const auto stride = -static_cast<png_int_32>(4 * png.width);
  if (png_image_finish_read(&png, nullptr, image.rgba.data(), stride, nullptr) == 0)
    throw FileError(say("{}: is damaged: {}", file, png.message));
  return image;
}

void writePng(const std::string& file, const Image& image) {
  std::vector<std::uint8_t> rgb;
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    if (i % 4 != 3) rgb.push_back(image.rgba[i]);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  const auto stride = -static_cast<png_int_32>(3 * png.width); // OpenGL's last row is the top
  png_alloc_size_t size = 0;
  png_image_write_to_memory(&png, nullptr, &size, 0, rgb.data(), stride, nullptr);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, rgb.data(), stride, nullptr) == 0)
    throw FileError(say("{}: can't be written: {}", file, png.message));
  std::ofstream stream(fromUtf8(file), std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(size));
  if (!stream.flush()) throw FileError(say("{}: can't be written", file));
}

} // namespace gg
