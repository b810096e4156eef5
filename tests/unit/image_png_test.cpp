#include "image/png.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

using namespace ggrade;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace {

/// Every byte value once in each channel.
Image allBytes(int channels) {
  Image image(16, 16, channels);
  for (int i = 0; i < 256; ++i)
    for (int c = 0; c < channels; ++c)
      image.at(i % 16, i / 16, c) = float((i + 37 * c) % 256) / 255.0f;
  return image;
}

/// A file that libpng's simplified interface makes of samples in one of its own formats.
std::vector<unsigned char> fileOf(int width, int height, png_uint_32 format, const void* samples,
                                  const void* colours = nullptr, int colourCount = 0) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = png_uint_32(width);
  png.height = png_uint_32(height);
  png.format = format;
  png.colormap_entries = png_uint_32(colourCount);
  png_alloc_size_t size = 4096;
  std::vector<unsigned char> file(size);
  EXPECT_TRUE(png_image_write_to_memory(&png, file.data(), &size, 0, samples, 0, colours))
      << png.message;
  file.resize(size);
  return file;
}

TEST(Png, KeepsEveryByte) {
  for (int channels : {1, 3, 4})
    for (PngEffort effort : {PngEffort::normal, PngEffort::fast}) {
      const Image image = allBytes(channels);
      const Image back = decodePng(encodePng(image, effort));
      ASSERT_EQ(back.channels(), channels);
      ASSERT_EQ(back.width(), 16);
      EXPECT_TRUE(std::ranges::equal(back.values(), image.values())) << channels;
    }
}

TEST(Png, RoundsAndClamps) {
  const float values[] = {-3,
                          1e9f,
                          0.49f / 255,
                          0.51f / 255,
                          254.4f / 255,
                          254.6f / 255,
                          std::numeric_limits<float>::quiet_NaN(),
                          std::numeric_limits<float>::infinity()};
  const Image back = decodePng(encodePng(Image::fromFloats(values, 8, 1, 1)));
  EXPECT_THAT(back.values(), ElementsAre(0, 1, 0, 1 / 255.0f, 254 / 255.0f, 1, 0, 1));
}

TEST(Png, ReadsSixteenBitsWithoutConversion) {
  const std::uint16_t samples[] = {0, 1, 32768, 65535, 257, 1000};
  const Image image = decodePng(fileOf(2, 1, PNG_FORMAT_LINEAR_RGB, samples));
  EXPECT_THAT(image.values(),
              ElementsAre(0, 1 / 65535.0f, 32768 / 65535.0f, 1, 257 / 65535.0f, 1000 / 65535.0f));
}

TEST(Png, ExpandsPalettesAndGreyWithAlpha) {
  const unsigned char colours[] = {255, 0, 51, 0, 102, 204}, indices[] = {1, 0, 1};
  const Image palette = decodePng(fileOf(3, 1, PNG_FORMAT_RGB_COLORMAP, indices, colours, 2));
  ASSERT_EQ(palette.channels(), 3);
  EXPECT_THAT(palette.pixel(0, 0), ElementsAre(0, 0.4f, 0.8f));
  EXPECT_THAT(palette.pixel(1, 0), ElementsAre(1, 0, 0.2f));
  const unsigned char greyAlpha[] = {51, 102};
  const Image grey = decodePng(fileOf(1, 1, PNG_FORMAT_GA, greyAlpha));
  EXPECT_THAT(grey.values(), ElementsAre(0.2f, 0.2f, 0.2f, 0.4f));
}

TEST(Png, RefusesWhatIsNotAWholePng) {
  const auto whole = encodePng(allBytes(4));
  EXPECT_THAT([] { decodePng({}); }, ThrowsMessage<std::runtime_error>("the file is empty"));
  const std::vector<unsigned char> text(100, 'x');
  EXPECT_THAT([&] { decodePng(text); }, ThrowsMessage<std::runtime_error>("it is not a PNG file"));
  // Cut anywhere: an error, never a crash or half an image.
  for (std::size_t size = 1; size < whole.size(); ++size)
    EXPECT_THROW(decodePng(std::span(whole).first(size)), std::runtime_error) << size;
  EXPECT_THAT([&] { decodePng(std::span(whole).first(whole.size() / 2)); },
              ThrowsMessage<std::runtime_error>(HasSubstr("the data ends too early")));
}

TEST(Png, NeverCrashesOnFlippedBytes) {
  const auto whole = encodePng(allBytes(3));
  for (std::size_t at = 8; at < whole.size(); ++at) {
    auto broken = whole;
    broken[at] ^= 0x55;
    try {
      EXPECT_FALSE(decodePng(broken).empty());
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr("PNG"));
    }
  }
}

TEST(Png, RefusesImagesThatItCannotHold) {
  EXPECT_THAT([] { encodePng(Image()); },
              ThrowsMessage<std::invalid_argument>("encodePng: the image is empty"));
  EXPECT_THAT([] { encodePng(Image(1, 1, 2)); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("not 2")));
}

TEST(Png, ReadingNamesThePathAndTheCause) {
  EXPECT_THAT(
      [] { readPng("/no/such.png"); },
      ThrowsMessage<std::runtime_error>("cannot read '/no/such.png': No such file or directory"));
  EXPECT_THAT(
      [] { readPng("/tmp"); },
      ThrowsMessage<std::runtime_error>("cannot read '/tmp': it is a folder; name a file in it"));
  const auto path = std::filesystem::path(testing::TempDir()) / "image_png_test_not.png";
  std::ofstream(path) << "hello, this is text";
  EXPECT_THAT([&] { readPng(path); },
              ThrowsMessage<std::runtime_error>(HasSubstr("not.png': it is not a PNG file")));
  std::filesystem::remove(path);
}

} // namespace
