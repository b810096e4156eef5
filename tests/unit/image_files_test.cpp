#include "image/compare.hpp"
#include "image/files.hpp"
#include "image/png.hpp"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

using namespace ggrade;
namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::FloatNear;
using testing::HasSubstr;
using testing::Pointwise;
using testing::ThrowsMessage;

namespace {

Image noise(int width, int height, int channels, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-0.5f, 2.0f);
  Image image(width, height, channels);
  for (float& value : image.values()) value = uniform(random);
  return image;
}

class ImageFiles : public testing::Test {
protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "/image_files_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, OIIO::ImageSpec spec, const std::vector<float>& values) {
    const auto path = folder_ / name;
    spec["oiio:UnassociatedAlpha"] = 1;
    const auto output = OIIO::ImageOutput::create(path.string());
    EXPECT_TRUE(output && output->open(path.string(), spec) &&
                output->write_image(OIIO::TypeDesc::FLOAT, values.data()) && output->close());
    return path;
  }

  fs::path folder_;
};

TEST_F(ImageFiles, ExrKeepsFloatsExactlyNaNIncluded) {
  for (int channels : {1, 2, 3, 4}) {
    Image image = noise(13, 7, channels, unsigned(channels));
    image.at(3, 2) = std::numeric_limits<float>::quiet_NaN();
    image.at(4, 2) = 1e30f;
    writeImageFile(folder_ / "a.exr", image);
    const FileImage file = readImageFile(folder_ / "a.exr");
    ASSERT_EQ(file.image.channels(), channels);
    EXPECT_EQ(file.parts, 1);
    EXPECT_TRUE(std::isnan(file.image.at(3, 2)));
    image.at(3, 2) = 0;
    Image back = file.image;
    back.at(3, 2) = 0;
    EXPECT_TRUE(std::ranges::equal(back.values(), image.values())) << channels;
  }
}

TEST_F(ImageFiles, ReadsIntegersAsZeroToOne) {
  using OIIO::TypeDesc;
  const std::vector<float> values{0, 0.2f, 1, 0.4f, 0.6f, 0.8f};
  for (const auto& [name, type, step] : {std::tuple("a.png", TypeDesc(TypeDesc::UINT8), 255.0f),
                                         std::tuple("b.png", TypeDesc(TypeDesc::UINT16), 65535.0f),
                                         std::tuple("c.tif", TypeDesc(TypeDesc::UINT16), 65535.0f),
                                         std::tuple("d.bmp", TypeDesc(TypeDesc::UINT8), 255.0f),
                                         std::tuple("e.exr", TypeDesc(TypeDesc::HALF), 2048.0f)}) {
    const auto path = write(name, OIIO::ImageSpec(2, 1, 3, type), values);
    const Image image = readImageFile(path).image;
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_NEAR(image.values()[i], values[i], 0.5f / step + 1e-6f) << name;
  }
}

TEST_F(ImageFiles, KeepsColourUnderAlphaZero) {
  const std::vector<float> values{1, 0.2f, 0.4f, 0};
  for (const char* name : {"a.png", "a.tif"}) {
    const auto path = write(name, OIIO::ImageSpec(1, 1, 4, OIIO::TypeDesc::UINT8), values);
    EXPECT_THAT(readImageFile(path).image.values(),
                ElementsAre(1, FloatNear(0.2f, 1e-6f), FloatNear(0.4f, 1e-6f), 0))
        << name;
  }
}

TEST_F(ImageFiles, PutsStoredPixelsWhereTheyAreDisplayed) {
  OIIO::ImageSpec spec(2, 2, 1, OIIO::TypeDesc::FLOAT);
  spec.x = 2;
  spec.y = -1; // its upper row lies outside
  spec.full_width = 5;
  spec.full_height = 3;
  const Image image = readImageFile(write("window.exr", spec, {1, 2, 3, 4})).image;
  EXPECT_EQ(image.sizeText(), "5x3");
  EXPECT_THAT(image.row(0), ElementsAre(0, 0, 3, 4, 0));
  EXPECT_THAT(image.row(1), ElementsAre(0, 0, 0, 0, 0));
}

TEST_F(ImageFiles, OtherProgramsReadOurPng) {
  const Image image = noise(9, 5, 4, 3);
  writeImageFile(folder_ / "a.png", image);
  OIIO::ImageSpec wishes;
  wishes["oiio:UnassociatedAlpha"] = 1;
  const auto input = OIIO::ImageInput::open((folder_ / "a.png").string(), &wishes);
  ASSERT_TRUE(input);
  std::vector<float> values(image.values().size());
  ASSERT_TRUE(input->read_image(0, 0, 0, 4, OIIO::TypeDesc::FLOAT, values.data()));
  EXPECT_THAT(values, Pointwise(FloatNear(1e-6f), readPng(folder_ / "a.png").values()));
}

TEST_F(ImageFiles, NamesTheFileTheCauseAndTheRemedy) {
  const auto refuses = [](const fs::path& path, const std::string& cause) {
    EXPECT_THAT([&] { readImageFile(path); },
                ThrowsMessage<std::runtime_error>(
                    AllOf(HasSubstr("cannot read '" + path.string() + "': "), HasSubstr(cause))));
  };
  refuses(folder_ / "no.png", "there is no such file; check the name");
  refuses(folder_, "it is a folder; name an image file in it");
  refuses("/dev/null", "it is not a regular file");
  std::ofstream(folder_ / "zero.exr");
  refuses(folder_ / "zero.exr", "the file is empty (0 bytes); write it again");
  std::ofstream(folder_ / "text.jpg") << "no picture at all";
  refuses(folder_ / "text.jpg", "is it an image, and complete?");

  const auto eight =
      write("eight.exr", OIIO::ImageSpec(1, 1, 8, OIIO::TypeDesc::FLOAT), std::vector<float>(8));
  refuses(eight, "it has 8 channels");
  writeImageFile(folder_ / "cut.png", noise(64, 64, 3, 1));
  fs::resize_file(folder_ / "cut.png", fs::file_size(folder_ / "cut.png") / 2);
  refuses(folder_ / "cut.png", "the data ends too early; write the file again");
  writeImageFile(folder_ / "cut.exr", noise(64, 64, 3, 1));
  fs::resize_file(folder_ / "cut.exr", fs::file_size(folder_ / "cut.exr") / 2);
  refuses(folder_ / "cut.exr", "");
}

TEST_F(ImageFiles, RefusesToWriteWhatItCannot) {
  const Image image(2, 2, 3);
  EXPECT_THAT([&] { writeImageFile(folder_ / "a", image); },
              ThrowsMessage<std::runtime_error>(HasSubstr("needs an extension")));
  EXPECT_THAT([&] { writeImageFile(folder_ / "a.foo", image); },
              ThrowsMessage<std::runtime_error>(HasSubstr("no image format is called '.foo'")));
  EXPECT_THAT([&] { writeImageFile(folder_ / "no" / "a.exr", image); },
              ThrowsMessage<std::runtime_error>(HasSubstr("create it first")));
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST(ErrorStatistics, AgreeWithOpenImageIo) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Image a = noise(61, 47, int(1 + seed % 4), seed);
    Image b = a;
    std::mt19937 random(seed);
    for (int i = 0; i < 300; ++i)
      b.values()[random() % b.values().size()] += float(random() % 1000) * 1e-3f;
    const auto ours = errorStatistics(a, b, 0.3f, 0.01f);
    const auto theirs = openImageIoStatistics(a, b, 0.3f, 0.01f);
    EXPECT_NEAR(ours.meanError, theirs.meanError, 1e-7);
    EXPECT_NEAR(ours.rmsError, theirs.rmsError, 1e-7);
    EXPECT_NEAR(ours.psnr, theirs.psnr, 1e-4);
    EXPECT_NEAR(ours.maxError, theirs.maxError, 1e-6);
    EXPECT_EQ(ours.maxX, theirs.maxX);
    EXPECT_EQ(ours.maxY, theirs.maxY);
    EXPECT_EQ(ours.maxChannel, theirs.maxChannel);
    EXPECT_EQ(ours.failPixels, theirs.failPixels);
    EXPECT_EQ(ours.warnPixels, theirs.warnPixels);
  }
}

// Values from 1e-6 to 1e30 of either sign, of which a few differ.
TEST(ErrorStatistics, AgreeWithOpenImageIoOnLargeValues) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> exponent(-6, 30);
    Image a(61, 47, 3);
    for (float& value : a.values())
      value = (random() % 2 ? 1.0f : -1.0f) * std::pow(10.0f, exponent(random));
    Image b = a;
    for (int i = 0; i < 500; ++i) b.values()[random() % b.values().size()] *= 1.5f;
    const auto ours = errorStatistics(a, b, 1e10f, 1.0f);
    const auto theirs = openImageIoStatistics(a, b, 1e10f, 1.0f);
    EXPECT_NEAR(ours.meanError / theirs.meanError, 1, 1e-6);
    EXPECT_NEAR(ours.rmsError / theirs.rmsError, 1, 1e-6);
    EXPECT_NEAR(ours.psnr, theirs.psnr, 1e-4);
    EXPECT_NEAR(ours.maxError / theirs.maxError, 1, 1e-6);
    EXPECT_EQ(ours.maxX, theirs.maxX);
    EXPECT_EQ(ours.maxY, theirs.maxY);
    EXPECT_EQ(ours.failPixels, theirs.failPixels);
    EXPECT_EQ(ours.warnPixels, theirs.warnPixels);
    EXPECT_GT(ours.failPixels, 50u);
  }
}

// Why it is a cross-check and no more: an image of nothing but NaN equals any other to it, and its
// mean hides a small thing that is missing, of which ours names the densest window.
TEST(ErrorStatistics, OfOpenImageIoAreBlindToNaNAndDiluteSmallThings) {
  const Image grey(200, 100, 3, 0.5f);
  const Image bad(200, 100, 3, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(openImageIoStatistics(bad, grey, 1e-6f, 1e-6f).failPixels, 0u);
  EXPECT_EQ(compare(bad, grey).status, ComparisonStatus::studentNotFinite);

  Image dot = grey;
  for (int y = 40; y < 46; ++y)
    for (int x = 90; x < 96; ++x) dot.at(x, y, 0) = 0;
  EXPECT_LT(openImageIoStatistics(grey, dot, 1e-6f, 1e-6f).meanError, 4e-4);
  EXPECT_NEAR(compare(grey, dot).densest.share, 36.0 / 1024, 1e-9);
}

} // namespace
