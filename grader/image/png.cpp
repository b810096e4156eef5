#include "image/png.hpp"

#include "image/temporary_file.hpp"

#include <png.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

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

namespace {

// libpng's own reader rather than its simplified interface, which would apply the file's gamma.
// libpng reports errors by longjmp: `read...` therefore hold nothing that has a destructor.
class PngReader {
public:
  explicit PngReader(std::span<const unsigned char> bytes) : bytes_(bytes) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, onError, onWarning);
    if (png_) info_ = png_create_info_struct(png_);
    if (!info_) throw std::runtime_error("libpng cannot be initialised");
    png_set_user_limits(png_, Image::kMaxSide, Image::kMaxSide);
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  bool readHeader() {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_set_read_fn(png_, this, onRead);
    png_read_info(png_, info_);
    png_set_expand(png_); // palettes, 1 to 4 bits, transparent colours
    if (png_get_color_type(png_, info_) == PNG_COLOR_TYPE_GRAY_ALPHA) png_set_gray_to_rgb(png_);
    if (png_get_color_type(png_, info_) == PNG_COLOR_TYPE_GRAY &&
        png_get_valid(png_, info_, PNG_INFO_tRNS))
      png_set_gray_to_rgb(png_);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }
  bool readRows(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_read_image(png_, rows);
    png_read_end(png_, nullptr);
    return true;
  }

  int width() const { return int(png_get_image_width(png_, info_)); }
  int height() const { return int(png_get_image_height(png_, info_)); }
  int channels() const { return png_get_channels(png_, info_); }
  int bitDepth() const { return png_get_bit_depth(png_, info_); }
  std::size_t rowBytes() const { return png_get_rowbytes(png_, info_); }
  std::string error() const { return error_; }

private:
  static PngReader& self(png_voidp pointer) { return *static_cast<PngReader*>(pointer); }
  static void onError(png_structp png, png_const_charp message) {
    std::snprintf(self(png_get_error_ptr(png)).error_, sizeof error_, "%s", message);
    std::longjmp(png_jmpbuf(png), 1);
  }
  static void onWarning(png_structp, png_const_charp) {}
  static void onRead(png_structp png, png_bytep into, png_size_t count) {
    auto& reader = self(png_get_io_ptr(png));
    if (count > reader.bytes_.size())
      png_error(png, "the data ends too early; write the file again");
    std::memcpy(into, reader.bytes_.data(), count);
    reader.bytes_ = reader.bytes_.subspan(count);
  }

  std::span<const unsigned char> bytes_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  char error_[128] = "";
};

std::string atPath(const std::filesystem::path& path, const std::string& cause) {
  return "cannot read '" + path.string() + "': " + cause;
}

} // namespace

Image decodePng(std::span<const unsigned char> bytes) {
  if (bytes.empty()) throw std::runtime_error("the file is empty");
  if (bytes.size() < 8 || png_sig_cmp(bytes.data(), 0, 8) != 0)
    throw std::runtime_error("it is not a PNG file");
  PngReader reader(bytes);
  if (!reader.readHeader()) throw std::runtime_error("broken PNG: " + reader.error());
  if (std::size_t(reader.width()) * std::size_t(reader.height()) > Image::kMaxFilePixels)
    throw std::runtime_error("it has too many pixels: " + std::to_string(reader.width()) + "x" +
                             std::to_string(reader.height()));
  Image image(reader.width(), reader.height(), reader.channels());

  std::vector<unsigned char> pixels(reader.rowBytes() * std::size_t(reader.height()));
  std::vector<png_bytep> rows;
  rows.reserve(std::size_t(reader.height()));
  for (int y = 0; y < reader.height(); ++y)
    rows.push_back(pixels.data() + std::size_t(y) * reader.rowBytes());
  if (!reader.readRows(rows.data())) throw std::runtime_error("broken PNG: " + reader.error());

  const auto values = image.values();
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = reader.bitDepth() == 16 ? float(pixels[2 * i] * 256 + pixels[2 * i + 1]) / 65535.0f
                                        : float(pixels[i]) / 255.0f;
  return image;
}

Image readPng(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    throw std::runtime_error(atPath(path, "it is a folder; name a file in it"));
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(atPath(path, std::strerror(errno)));
  const std::vector<unsigned char> bytes{std::istreambuf_iterator<char>(file), {}};
  try {
    return decodePng(bytes);
  } catch (const std::runtime_error& cause) {
    throw std::runtime_error(atPath(path, cause.what()));
  }
}

} // namespace ggrade
