#include "image/files.hpp"

#include "image/png.hpp"
#include "image/temporary_file.hpp"
#include "words/words.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace fs = std::filesystem;

namespace ggrade {
namespace {

[[noreturn]] void cannotRead(const fs::path& path, const std::string& cause) {
  throw std::runtime_error(gg::say("cannot read '{}': {}", path.string(), cause));
}

[[noreturn]] void cannotWrite(const fs::path& path, const std::string& cause) {
  throw std::runtime_error(gg::say("cannot write '{}': {}", path.string(), cause));
}

// What OpenImageIO says may have several lines, of which the last ones repeat the first.
std::string firstLine(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

// Names what OpenImageIO would only call unreadable.
void checkReadable(const fs::path& path) {
  std::error_code error;
  const auto status = fs::status(path, error);
  if (!fs::exists(status)) {
    if (status.type() == fs::file_type::not_found)
      cannotRead(path, gg::say("there is no such file; check the name"));
    cannotRead(path, error.message());
  }
  if (fs::is_directory(status))
    cannotRead(path, gg::say("it is a folder; name an image file in it"));
  if (!fs::is_regular_file(status)) cannotRead(path, gg::say("it is not a regular file"));
  if (access(path.c_str(), R_OK) != 0) cannotRead(path, std::strerror(errno));
  if (fs::file_size(path, error) == 0)
    cannotRead(path, gg::say("the file is empty (0 bytes); write it again"));
}

bool isPng(const fs::path& path) {
  constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
  char start[signature.size()] = {};
  std::ifstream(path, std::ios::binary).read(start, sizeof start);
  return std::string_view(start, sizeof start) == signature;
}

void checkSpec(const fs::path& path, const OIIO::ImageSpec& spec) {
  if (spec.deep) cannotRead(path, "deep images cannot be compared; flatten it first");
  if (spec.full_depth > 1 || spec.depth > 1) cannotRead(path, "volumes cannot be compared");
  if (spec.nchannels < 1 || spec.nchannels > 4) {
    std::string names;
    for (const auto& name : spec.channelnames) names += (names.empty() ? "" : ", ") + name;
    cannotRead(path,
               "it has " + std::to_string(spec.nchannels) + " channels (" + names +
                   "), at most 4 can be compared; save the ones you mean in a file of their own");
  }
  const auto pixels = std::size_t(spec.width) * std::size_t(spec.height);
  const auto shown = std::size_t(spec.full_width) * std::size_t(spec.full_height);
  if (std::max({spec.width, spec.height, spec.full_width, spec.full_height}) > Image::kMaxSide ||
      std::max(pixels, shown) > Image::kMaxFilePixels)
    cannotRead(path, "it has too many pixels: " + std::to_string(spec.width) + "x" +
                         std::to_string(spec.height));
}

// Puts the stored pixels (the data window) where they belong in the display window.
Image displayed(const std::vector<float>& stored, const OIIO::ImageSpec& spec) {
  const bool whole = spec.full_width < 1 || spec.full_height < 1;
  const int left = whole ? spec.x : spec.full_x, top = whole ? spec.y : spec.full_y;
  Image image(whole ? spec.width : spec.full_width, whole ? spec.height : spec.full_height,
              spec.nchannels);
  const int x0 = std::max(spec.x, left), x1 = std::min(spec.x + spec.width, left + image.width());
  if (x0 >= x1) return image;
  for (int y = 0; y < image.height(); ++y) {
    const int row = y + top - spec.y;
    if (row < 0 || row >= spec.height) continue;
    const auto from = (std::ptrdiff_t(row) * spec.width + (x0 - spec.x)) * spec.nchannels;
    std::copy_n(stored.begin() + from, std::ptrdiff_t(x1 - x0) * spec.nchannels,
                image.pixel(x0 - left, y).begin());
  }
  return image;
}

} // namespace

FileImage readImageFile(const fs::path& path) {
  checkReadable(path);
  // Under OpenImageIO, libpng prints its errors to stderr as well; our own reader throws them.
  if (isPng(path)) return {.image = readPng(path)};
  OIIO::ImageSpec wishes;
  wishes["oiio:UnassociatedAlpha"] =
      1; // else colour under alpha 0 would be lost, and with it errors there
  const auto input = OIIO::ImageInput::open(path.string(), &wishes);
  if (!input)
    cannotRead(path, gg::say("{}; is it an image, and complete?", firstLine(OIIO::geterror())));
  const OIIO::ImageSpec spec = input->spec();
  checkSpec(path, spec);

  std::vector<float> stored(std::size_t(spec.width) * std::size_t(spec.height) *
                            std::size_t(spec.nchannels));
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, stored.data()))
    cannotRead(path, gg::say("{}; the file is damaged or cut short, write it again",
                             firstLine(input->geterror())));
  FileImage result;
  result.image = displayed(stored, spec);
  result.floats = spec.format.is_floating_point();
  result.parts = input->seek_subimage(1, 0) ? 2 : 1;
  return result;
}

void writeImageFile(const fs::path& path, const Image& image) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return std::tolower(c); });
  if (extension == ".png" && image.channels() != 2) return writePng(path, image);

  TemporaryFile file(path);
  const auto output = OIIO::ImageOutput::create(file.path().string());
  if (!output)
    cannotWrite(path, extension.empty()
                          ? gg::say("the name needs an extension such as .png or .exr")
                          : gg::say("no image format is called '{}'; use .png or .exr", extension));
  OIIO::ImageSpec spec(image.width(), image.height(), image.channels(), OIIO::TypeDesc::FLOAT);
  spec["oiio:UnassociatedAlpha"] = 1;
  if (!output->open(file.path().string(), spec) ||
      !output->write_image(OIIO::TypeDesc::FLOAT, image.values().data()) || !output->close())
    cannotWrite(path, firstLine(output->geterror()));
  file.commit();
}

ErrorStatistics openImageIoStatistics(const Image& a, const Image& b, float fail, float warn) {
  const auto wrap = [](const Image& image) {
    const OIIO::ImageSpec spec(image.width(), image.height(), image.channels(),
                               OIIO::TypeDesc::FLOAT);
    // OpenImageIO wants a writable buffer even where it only reads.
    return OIIO::ImageBuf(spec, const_cast<float*>(image.values().data()));
  };
  const OIIO::ImageBuf left = wrap(a), right = wrap(b);
  // Its `error` means that a pixel failed; what went wrong is kept in the buffers.
  const auto found = OIIO::ImageBufAlgo::compare(left, right, fail, warn, OIIO::ROI(), 1);
  for (const auto* buffer : {&left, &right})
    if (buffer->has_error())
      throw std::runtime_error("OpenImageIO cannot compare: " + buffer->geterror());
  ErrorStatistics result;
  result.meanError = found.meanerror;
  result.rmsError = found.rms_error;
  result.psnr = found.PSNR;
  result.maxError = found.maxerror;
  result.maxX = found.maxx;
  result.maxY = found.maxy;
  result.maxChannel = found.maxc;
  result.failPixels = std::size_t(found.nfail);
  result.warnPixels = std::size_t(found.nwarn);
  return result;
}

} // namespace ggrade
