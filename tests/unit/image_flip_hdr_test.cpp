#include "flip_direct.hpp"
#include "flip_pictures.hpp"

#include "image/flip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace ggrade;
using namespace flip_pictures;

namespace {

// ACES as Narkowicz fits it, 2.51 x^2 + 0.03 x over 2.43 x^2 + 0.59 x + 0.14, at 0.6 x.
double toneMapped(double x) {
  x *= 0.6;
  return std::min(1.0, (2.51 * x * x + 0.03 * x) / (2.43 * x * x + 0.59 * x + 0.14));
}

// Where the curve reaches 0.85, found by bisection.
double brightValue() {
  double low = 0, high = 10;
  for (int i = 0; i < 200; ++i)
    (toneMapped((low + high) / 2) < 0.85 ? low : high) = (low + high) / 2;
  return low;
}

flip_direct::Picture exposed(const Image& image, double stops) {
  flip_direct::Picture picture{image.width(), image.height(), {}};
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      flip_direct::Colour colour;
      for (int c = 0; c < 3; ++c)
        colour[std::size_t(c)] =
            toneMapped(std::max(0.0, double(image.at(x, y, c))) * std::exp2(stops));
      picture.pixels.push_back(colour);
    }
  return picture;
}

TEST(HdrFlip, ChoosesExposuresFromTheReferencesLuminance) {
  // Nine pixels of luminance 1, four of 4, two of 0.25: the median is 1.
  Image image(15, 1, 3, 1.0f);
  for (int x = 0; x < 4; ++x)
    for (int c = 0; c < 3; ++c) image.at(x, 0, c) = 4;
  for (int x = 13; x < 15; ++x)
    for (int c = 0; c < 3; ++c) image.at(x, 0, c) = 0.25f;
  const Exposures found = flipExposures(image);
  EXPECT_NEAR(found.start, std::log2(brightValue() / 4), 1e-9);
  EXPECT_NEAR(found.stop, std::log2(brightValue()), 1e-9);
  EXPECT_EQ(found.count, 2);
  image.at(0, 0, 1) = 400; // luminance 4 + 396 * 0.7152
  EXPECT_NEAR(flipExposures(image).start, std::log2(brightValue() / 287.2192), 1e-6);
  EXPECT_EQ(flipExposures(image).count, 9); // 8.17 stops
}

TEST(HdrFlip, LeavesBlackOutOfTheMedianOnlyWhereItWouldBeBlack) {
  Image image(10, 1, 3);
  for (int c = 0; c < 3; ++c) {
    image.at(3, 0, c) = 8;
    image.at(4, 0, c) = 0.5f;
    image.at(5, 0, c) = -7; // counts as black
    image.at(6, 0, c) = 0.5f;
  }
  EXPECT_NEAR(flipExposures(image).start, std::log2(brightValue() / 8), 1e-9);
  EXPECT_NEAR(flipExposures(image).stop, std::log2(brightValue() / 0.5), 1e-9);
  const Exposures black = flipExposures(Image(4, 4, 3));
  EXPECT_EQ(black.start, 0.0);
  EXPECT_EQ(black.stop, 0.0);
  EXPECT_EQ(black.count, 1);
}

TEST(HdrFlip, IsTheLargestErrorOfItsExposures) {
  const Image reference = hdrNoise(5, 20, 8), student = hdrNoise(6, 20, 8);
  const Exposures exposures = flipExposures(reference);
  ASSERT_EQ(exposures.count, 9);
  std::vector<double> expected(reference.pixelCount());
  for (int i = 0; i < exposures.count; ++i) {
    const double stops =
        exposures.start + (exposures.stop - exposures.start) * i / (exposures.count - 1);
    const auto errors = flip_direct::errors(exposed(student, stops), exposed(reference, stops),
                                            kFlipPixelsPerDegree);
    for (std::size_t k = 0; k < errors.size(); ++k) expected[k] = std::max(expected[k], errors[k]);
  }
  const Flip found = hdrFlip(student, reference);
  double mean = 0;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_NEAR(double(found.map.values()[k]), expected[k], 5e-4);
    mean += expected[k] / double(expected.size());
  }
  EXPECT_NEAR(found.mean, mean, 2e-5);
}

// Origin as in Flip.AgreesWithTheAuthorsProgram.
TEST(HdrFlip, AgreesWithTheAuthorsProgram) {
  const Image reference = hdrNoise(5, 48, 32);
  const Exposures exposures = flipExposures(reference);
  EXPECT_NEAR(exposures.start, -6.45812, 1e-5);
  EXPECT_NEAR(exposures.stop, 1.67264, 1e-5);
  EXPECT_EQ(exposures.count, 9);
  EXPECT_NEAR(hdrFlip(hdrNoise(6, 48, 32), reference).mean, 0.17348017, 1e-4);
  EXPECT_NEAR(hdrFlip(withSquare(reference, 20, 10, 5, 3, 2, 1), reference).mean, 0.03875802, 1e-4);
  EXPECT_NEAR(hdrFlip(constant(8, 8, 1, 2, 4), constant(8, 8, 4, 2, 1)).mean, 0.51278096, 1e-4);
}

TEST(HdrFlip, IsExactlyZeroForIdenticalImages) {
  for (const Image& image : {hdrNoise(5, 16, 16), Image(3, 3, 3), Image(1, 1, 1, 1e30f),
                             Image(2, 9, 4, -1e30f), Image(2, 2, 3, 1e-40f)}) {
    const Flip found = hdrFlip(image, image);
    EXPECT_EQ(found.mean, 0.0);
    EXPECT_EQ(largest(found.map), 0.0f);
  }
}

// FLIP of an LDR picture of the same light would call these equal: both are white.
TEST(HdrFlip, SeesDifferencesFarAboveWhite) {
  const Image bright(8, 8, 3, 1000.0f), brighter(8, 8, 3, 4000.0f);
  EXPECT_EQ(ldrFlip(brighter, bright).mean, 0.0);
  EXPECT_GT(hdrFlip(brighter, bright).mean, 0.1);
  // It is the ratio that counts: the reference is exposed to the same brightness.
  EXPECT_NEAR(hdrFlip(brighter, bright).mean,
              hdrFlip(Image(8, 8, 3, 0.004f), Image(8, 8, 3, 0.001f)).mean, 1e-5);
}

TEST(HdrFlip, CopesWithHugeAndNegativeLight) {
  const auto expectSane = [](const Flip& found, const char* what) {
    EXPECT_TRUE(found.mean > 0 && found.mean <= 1) << what << ' ' << found.mean;
    for (const float error : found.map.values())
      ASSERT_TRUE(error >= 0 && error <= 1) << what << ' ' << error;
  };
  Image lamp = hdrNoise(5, 24, 24);
  const Image plain = lamp;
  lamp.at(12, 12, 0) = 1e30f;
  expectSane(hdrFlip(lamp, plain), "a huge value");
  expectSane(hdrFlip(plain, lamp), "a huge value in the reference");
  EXPECT_EQ(flipExposures(lamp).count, kFlipMaxExposures); // more than 100 stops
  const float most = std::numeric_limits<float>::max();
  expectSane(hdrFlip(Image(4, 4, 3, most), Image(4, 4, 3, 1e-38f)),
             "the largest over the smallest");
  expectSane(hdrFlip(Image(4, 4, 3, 1e-38f), Image(4, 4, 3, most)),
             "the smallest over the largest");
  expectSane(hdrFlip(Image(4, 4, 3, 1.0f), Image(4, 4, 3)), "a black reference");
  expectSane(hdrFlip(Image(4, 4, 3, -1.0f), Image(4, 4, 3, 1.0f)), "negative");
  EXPECT_EQ(hdrFlip(Image(4, 4, 3, -1e30f), Image(4, 4, 3)).mean, 0.0);
}

TEST(HdrFlip, RefusesWhatIsNotANumber) {
  Image bad(4, 3, 3, 0.5f);
  bad.at(0, 0, 2) = -std::numeric_limits<float>::infinity();
  const Image good(4, 3, 3, 0.5f);
  EXPECT_THROW(hdrFlip(bad, good), std::invalid_argument);
  EXPECT_THROW(hdrFlip(good, bad), std::invalid_argument);
  EXPECT_THROW(flipExposures(bad), std::invalid_argument);
  EXPECT_THROW(flipExposures(Image()), std::invalid_argument);
  EXPECT_THROW(hdrFlip(good, Image(3, 3, 3)), std::invalid_argument);
}

} // namespace
