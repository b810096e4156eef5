// What every metric does with images that no right program makes.

#include "not_finite.hpp"

#include "image/compare.hpp"
#include "image/difference.hpp"
#include "image/flip.hpp"
#include "image/statistics.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

using namespace ggrade;

namespace {

/// A frame with a bright square, as a window gives it: RGBA.
Image frame() {
  Image image(48, 32, 4, 0.25f);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 48; ++x) {
      if (x > 10 && x < 20 && y > 8 && y < 20) image.at(x, y, 0) = 0.9f;
      image.at(x, y, 3) = 1;
    }
  return image;
}

Image with(Image image, int x, int y, int channel, float value) {
  image.at(x, y, channel) = value;
  return image;
}

Image all(float value) {
  return {48, 32, 4, value};
}

std::string thrown(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

const CompareOptions kColour{.channels = 3};

TEST(BadInput, NaNAndInfAreNamedByEveryMetric) {
  for (const auto& [value, word] :
       {std::pair(kNaN, "NaN"), std::pair(kInf, "Inf"), std::pair(-kInf, "-Inf")}) {
    const Image bad = with(frame(), 5, 7, 1, value);
    const std::string where =
        std::string("1 pixel holds NaN or Inf, the first ") + word + " at (5,7), channel G";
    const Comparison student = compare(bad, frame(), kColour);
    EXPECT_EQ(student.status, ComparisonStatus::studentNotFinite);
    EXPECT_EQ(student.message, "the image: " + where);
    EXPECT_EQ(student.wrongShare, 1);
    const Comparison reference = compare(frame(), bad, kColour);
    EXPECT_EQ(reference.status, ComparisonStatus::referenceNotFinite);
    EXPECT_EQ(reference.message, "the reference: " + where);
    EXPECT_EQ(thrown([&] { ldrFlip(bad, frame()); }), "FLIP: the image: " + where);
    EXPECT_EQ(thrown([&] { hdrFlip(frame(), bad); }), "FLIP: the reference image: " + where);
    EXPECT_FALSE(std::isfinite(ssim(bad, frame()))) << word;
    ASSERT_TRUE(findNonFinite(bad));
    EXPECT_EQ(findNonFinite(bad)->text(4), where);
    // Its brightest colour, or cyan: seen in any case.
    EXPECT_GT(differencePicture(bad, frame()).at(5, 7, 1), 0.9f);
  }
}

TEST(BadInput, NegativeValuesAreWrongNotRefused) {
  const Comparison found = compare(all(-0.5f), frame(), kColour);
  EXPECT_TRUE(found.compared());
  EXPECT_EQ(found.wrongShare, 1);
  EXPECT_LT(found.meanDifference, -0.7);
  EXPECT_NEAR(errorStatistics(all(-0.5f), all(0.25f)).meanError, 0.75, 1e-7);
  EXPECT_LT(ssim(all(-0.5f), frame()), 0.1);
  // A screen shows black.
  EXPECT_EQ(ldrFlip(all(-0.5f), frame()).mean, ldrFlip(all(0), frame()).mean);
  EXPECT_EQ(hdrFlip(all(-0.5f), frame()).mean, hdrFlip(all(0), frame()).mean);
}

TEST(BadInput, HugeValuesAreWrongNotOverflowing) {
  for (const float huge : {1e30f, -1e30f, std::numeric_limits<float>::max()}) {
    const Image bad = with(frame(), 40, 25, 2, huge);
    for (const auto& found : {compare(bad, frame(), kColour), compare(frame(), bad, kColour)}) {
      EXPECT_TRUE(found.compared());
      // To its neighbours the value is in range; itself it is wrong.
      EXPECT_EQ(found.wrongPixels, 1u);
      EXPECT_TRUE(std::isfinite(found.meanAbsoluteError));
      ASSERT_TRUE(found.worst);
      EXPECT_EQ(found.worst->channel, 2);
    }
    const auto statistics = errorStatistics(bad, frame());
    EXPECT_TRUE(std::isfinite(statistics.meanError) && std::isfinite(statistics.rmsError));
    EXPECT_EQ(statistics.failPixels, 1u);
    EXPECT_EQ(statistics.maxX, 40);
    for (const Flip& flip : {ldrFlip(bad, frame()), hdrFlip(bad, frame()), hdrFlip(frame(), bad)})
      EXPECT_TRUE(flip.mean > 0 && flip.mean < 1) << flip.mean;
    EXPECT_TRUE(std::isfinite(ssim(bad, frame())));
    EXPECT_GT(differencePicture(bad, frame()).at(40, 25, 1), 0.9f);
  }
}

TEST(BadInput, OtherSizesAreNamed) {
  const Image other(32, 48, 4, 0.25f);
  const Comparison found = compare(other, frame(), kColour);
  EXPECT_EQ(found.status, ComparisonStatus::sizesDiffer);
  EXPECT_EQ(found.message, "the image is 32x48, the reference 48x32");
  EXPECT_EQ(found.wrongShare, 1);
  EXPECT_EQ(thrown([&] { ldrFlip(other, frame()); }),
            "FLIP: the image is 32x48, the reference 48x32");
  EXPECT_EQ(thrown([&] { hdrFlip(other, frame()); }),
            "FLIP: the image is 32x48, the reference 48x32");
  EXPECT_EQ(thrown([&] { ssim(other, frame()); }), "ssim: the images are 32x48 and 48x32");
  EXPECT_EQ(thrown([&] { errorStatistics(other, frame()); }),
            "errorStatistics: the images differ in size or channels");
  EXPECT_TRUE(differencePicture(other, frame()).empty());
}

// Nobody sees a window's alpha: an all-transparent frame of the right colours is right.
TEST(BadInput, AnAllTransparentFrameIsJudgedByItsColours) {
  Image clear = frame();
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 48; ++x) clear.at(x, y, 3) = 0;
  EXPECT_EQ(compare(clear, frame(), kColour).wrongShare, 0);
  EXPECT_EQ(ldrFlip(clear, frame()).mean, 0);
  EXPECT_EQ(ssim(clear, frame()), 1);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 48; ++x) EXPECT_EQ(differencePicture(clear, frame()).at(x, y, 3), 1);
  // Whoever asks for all channels gets alpha too, and transparent black is black.
  EXPECT_EQ(compare(clear, frame()).wrongShare, 1);
  EXPECT_EQ(errorStatistics(clear, frame()).maxChannel, 3);
  EXPECT_EQ(compare(all(0), frame(), kColour).wrongShare, 1);
  EXPECT_GT(ldrFlip(all(0), frame()).mean, 0.3);
}

TEST(BadInput, EmptyImagesAreNamed) {
  EXPECT_EQ(compare({}, frame(), kColour).message, "there is no image");
  EXPECT_EQ(compare(frame(), {}, kColour).message, "there is no reference image");
  EXPECT_EQ(compare({}, {}, kColour).wrongShare, 1);
  EXPECT_EQ(thrown([] { ldrFlip({}, frame()); }), "FLIP: there is no image");
  EXPECT_EQ(thrown([] { hdrFlip(frame(), {}); }), "FLIP: there is no reference image");
  EXPECT_EQ(thrown([] { ssim({}, {}); }), "ssim: the images are 0x0 and 0x0");
  EXPECT_NE(thrown([] { errorStatistics({}, {}); }), "");
  EXPECT_TRUE(differencePicture({}, frame()).empty());
  EXPECT_TRUE(heatPicture({}).empty());
  EXPECT_FALSE(findNonFinite({}));
}

} // namespace
