// An environment from a picture: Radiance's format (.hdr), in which each pixel has three mantissas
// and one exponent. Format: Ward, "Real pixels", Graphics Gems II (1991).
#pragma once

#include "sky.hpp"

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

#include <gg/error.hpp>
#include <gg/text_file.hpp>

namespace hdr {

using Pixel = std::array<std::uint8_t, 4>; // red, green, blue, exponent

// Takes bytes from the front of a file's text.
struct Reader {
  std::string name; // for messages
  std::string_view rest;

  [[noreturn]] void fail(const std::string& reason) const {
    throw gg::FileError(name + ": " + reason);
  }
  std::uint8_t byte() {
    if (rest.empty()) fail("ends in the middle of the picture");
    const auto value = static_cast<std::uint8_t>(rest.front());
    rest.remove_prefix(1);
    return value;
  }
  std::string line() {
    const std::size_t end = rest.find('\n');
    if (end == rest.npos) fail("ends in the middle of its header");
    std::string text(rest.substr(0, end));
    rest.remove_prefix(end + 1);
    return text;
  }
};

// A row of components, each packed for itself: runs of one byte, and bytes as they are.
inline void readPackedRow(Reader& file, std::vector<Pixel>& row) {
  for (std::size_t component = 0; component < 4; ++component)
    for (std::size_t x = 0; x < row.size();) {
      const std::size_t code = file.byte(), count = code > 128 ? code - 128 : code;
      if (count == 0 || count > row.size() - x) file.fail("a run of pixels ends outside its row");
      const std::uint8_t run = code > 128 ? file.byte() : std::uint8_t(0);
      for (std::size_t i = 0; i < count; ++i) row[x++][component] = code > 128 ? run : file.byte();
    }
}

// A row of whole pixels; those with mantissas 1, 1, 1 say how often to repeat the one before.
//   first: has been read already
inline void readPlainRow(Reader& file, std::vector<Pixel>& row, Pixel first) {
  int shift = 0;
  for (std::size_t x = 0; x < row.size();) {
    if (x > 0) first = {file.byte(), file.byte(), file.byte(), file.byte()};
    if (first[0] != 1 || first[1] != 1 || first[2] != 1) {
      row[x++] = first;
      shift = 0;
      continue;
    }
    const std::size_t count = shift < 24 ? std::size_t(first[3]) << shift : 0;
    if (x == 0 || count > row.size() - x) file.fail("a run of pixels ends outside its row");
    for (std::size_t i = 0; i < count; ++i, ++x) row[x] = row[x - 1];
    shift += 8;
  }
}

} // namespace hdr

// The environment in a .hdr file, which must be twice as wide as high.
//   file: UTF-8
// Throws gg::FileError, with what helps, for a file that it can't read.
inline EnvironmentMap loadEnvironment(const std::string& file) {
  const std::string text = gg::readFile(gg::fromUtf8(file));
  hdr::Reader reader{file, text};
  if (!text.starts_with("#?"))
    reader.fail("is no Radiance picture (.hdr). Make one: oiiotool " + file +
                " -o environment.hdr");
  double exposure = 1;
  for (std::string line = reader.line(); !line.empty(); line = reader.line()) {
    if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe")
      reader.fail("has " + line + "; only 32-bit_rle_rgbe can be read");
    double factor = 1;
    if (std::sscanf(line.c_str(), "EXPOSURE=%lf", &factor) == 1 && factor > 0) exposure *= factor;
  }
  const std::string size = reader.line();
  EnvironmentMap map;
  if (std::sscanf(size.c_str(), "-Y %d +X %d", &map.height, &map.width) != 2)
    reader.fail("has its pixels in another order (" + size + ") than -Y HEIGHT +X WIDTH");
  if (map.height < 1 || map.height > 8192 || map.width != 2 * map.height)
    reader.fail("is " + std::to_string(map.width) + " x " + std::to_string(map.height) +
                "; an environment is twice as wide as high, at most 16384 x 8192");

  std::vector<hdr::Pixel> row(std::size_t(map.width));
  for (int y = 0; y < map.height; ++y) {
    const hdr::Pixel first{reader.byte(), reader.byte(), reader.byte(), reader.byte()};
    const bool packed =
        map.width >= 8 && first[0] == 2 && first[1] == 2 && (first[2] << 8 | first[3]) == map.width;
    if (packed)
      hdr::readPackedRow(reader, row);
    else
      hdr::readPlainRow(reader, row, first);
    for (const hdr::Pixel& pixel : row) {
      // As Radiance does: the middle of what the bytes stand for. Exponent 0 is black.
      const double unit = pixel[3] == 0 ? 0 : std::ldexp(1 / exposure, pixel[3] - 136);
      map.texels.emplace_back((pixel[0] + 0.5) * unit, (pixel[1] + 0.5) * unit,
                              (pixel[2] + 0.5) * unit);
    }
  }
  return map;
}
