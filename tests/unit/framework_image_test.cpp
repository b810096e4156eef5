#include <gg/texture.hpp>

#include <algorithm>
#include <stdexcept>

#include "framework_temporary_folder.hpp"
#include "framework_throws.hpp"
#include <gg/error.hpp>
#include <gmock/gmock.h>
#include <png.h>

namespace {

using testing::ElementsAre;

std::vector<int> pixel(const gg::Image& image, int x, int y) {
  const std::uint8_t* p = &image.rgba[4 * (static_cast<std::size_t>(y) * image.width + x)];
  return {p[0], p[1], p[2], p[3]};
}

TEST(Image, CheckerAlternatesFromTheBottomLeft) {
  const gg::Image image = gg::checkerImage(8, 4, {1, 0, 0}, {0, 0.5f, 2});
  ASSERT_EQ(image.rgba.size(), 8u * 8 * 4);
  EXPECT_THAT(pixel(image, 0, 0), ElementsAre(255, 0, 0, 255));
  EXPECT_THAT(pixel(image, 1, 1), ElementsAre(255, 0, 0, 255));
  EXPECT_THAT(pixel(image, 2, 0), ElementsAre(0, 128, 255, 255));
  EXPECT_THAT(pixel(image, 2, 2), ElementsAre(255, 0, 0, 255));
  EXPECT_THAT(pixel(image, 7, 0), ElementsAre(0, 128, 255, 255));
}

TEST(Image, NoiseIsRepeatableGreyAndVaried) {
  const gg::Image image = gg::noiseImage(64, 4, 3, 7);
  EXPECT_EQ(image.rgba, gg::noiseImage(64, 4, 3, 7).rgba);
  EXPECT_NE(image.rgba, gg::noiseImage(64, 4, 3, 8).rgba);
  int lowest = 255, highest = 0;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const std::vector<int> p = pixel(image, x, y);
      EXPECT_EQ(p[0], p[1]);
      EXPECT_EQ(p[0], p[2]);
      EXPECT_EQ(p[3], 255);
      lowest = std::min(lowest, p[0]);
      highest = std::max(highest, p[0]);
    }
  }
  EXPECT_LT(lowest, 90);
  EXPECT_GT(highest, 165);
}

TEST(Image, NoiseHasNoSeam) {
  const int n = 128;
  const gg::Image image = gg::noiseImage(n, 4, 1, 1);
  // Between neighbours 1/32 of a cell apart, smooth interpolation changes by 1.5 / 32 at the most.
  for (int y = 0; y < n; ++y)
    EXPECT_LE(std::abs(pixel(image, 0, y)[0] - pixel(image, n - 1, y)[0]), 13);
  for (int x = 0; x < n; ++x)
    EXPECT_LE(std::abs(pixel(image, x, 0)[0] - pixel(image, x, n - 1)[0]), 13);
}

TEST(Image, ParametersWithoutMeaningAreErrors) {
  EXPECT_THROW(gg::checkerImage(0, 1, {}, {}), std::invalid_argument);
  EXPECT_THROW(gg::checkerImage(4, 5, {}, {}), std::invalid_argument);
  EXPECT_THROW(gg::noiseImage(4, 0, 1, 0), std::invalid_argument);
  EXPECT_THROW(gg::noiseImage(4, 1, 17, 0), std::invalid_argument);
}

TEST(Image, PngComesBackWithItsBottomRowFirst) {
  const TemporaryFolder folder;
  // In a folder with a name beyond ASCII, as many homes have.
  const std::filesystem::path file = folder.write("\xE7\xB5\xB5/two.png", "");
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = 1;
  png.height = 2;
  png.format = PNG_FORMAT_RGBA;
  const std::uint8_t topFirst[] = {10, 20, 30, 255, 40, 50, 60, 128};
  ASSERT_NE(png_image_write_to_file(&png, file.c_str(), 0, topFirst, 0, nullptr), 0);

  const gg::Image image = gg::readPng(file.string());
  EXPECT_EQ(image.width, 1);
  EXPECT_EQ(image.height, 2);
  EXPECT_THAT(pixel(image, 0, 0), ElementsAre(40, 50, 60, 128));
  EXPECT_THAT(pixel(image, 0, 1), ElementsAre(10, 20, 30, 255));
}

TEST(Image, WhatIsNoPngIsNamed) {
  const TemporaryFolder folder;
  const std::string text = folder.write("a.png", "hello").string();
  EXPECT_THAT(messageOf<gg::FileError>([&] { gg::readPng(text); }),
              testing::StartsWith(text + ": is not a PNG image: "));
  EXPECT_THAT(messageOf<gg::FileError>([&] { gg::readPng("/no/such.png"); }),
              "/no/such.png: cannot be read: No such file or directory");
}

TEST(Image, ATruncatedPngIsDamaged) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("a.png", "");
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = png.height = 64;
  png.format = PNG_FORMAT_RGBA;
  const gg::Image noise = gg::noiseImage(64, 32, 2, 5);
  ASSERT_NE(png_image_write_to_file(&png, file.c_str(), 0, noise.rgba.data(), 0, nullptr), 0);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  EXPECT_THAT(messageOf<gg::FileError>([&] { gg::readPng(file.string()); }),
              testing::StartsWith(file.string() + ": is damaged: "));
}

} // namespace
