#pragma once
/// \file
/// Images, and textures made from them.

#include <cstdint>
#include <string>
#include <vector>

#include <gg/handle.hpp>
#include <glm/vec3.hpp>

namespace gg {

/// width x height x 4 bytes RGBA, row 0 at the bottom, as OpenGL has it.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// A chequerboard of two colours (components 0 to 1); the square at the bottom left is `a`.
///   size: pixels, width and height;  squares: number of squares along a side, 1 to `size`
Image checkerImage(int size, int squares, const glm::vec3& a, const glm::vec3& b);

/// Grey value noise that repeats without a seam: `octaves` layers, each twice as fine and half as
/// strong as the one before. The same seed gives the same image everywhere.
///   size: pixels, width and height;  cells: of the coarsest layer, along a side
Image noiseImage(int size, int cells, int octaves, std::uint32_t seed);

/// Reads a PNG file of any kind; `file` is UTF-8. Throws FileError.
Image readPng(const std::string& file);

/// Writes a PNG file without its alpha; `file` is UTF-8. Throws FileError.
void writePng(const std::string& file, const Image& image);

/// A repeating texture with mipmaps (trilinear). The values are used as they are.
/// Leaves it bound. Calls glTexImage2D, glGenerateMipmap, glTexParameteri.
Texture makeTexture(const Image& image);

/// makeTexture(readPng(...)); a relative path starts at the program's folder.
Texture loadTexture(const std::string& file);

} // namespace gg
