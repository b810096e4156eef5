#include "not_finite.hpp"

#include "image/difference.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

using namespace ggrade;
using testing::ElementsAre;
using testing::FloatNear;

namespace {

double linear(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/// CIE L*, a*, b* (D65): another uniform space than the one that the map was made in.
std::array<double, 3> cieLab(const std::array<float, 3>& rgb) {
  const double r = linear(rgb[0]), g = linear(rgb[1]), b = linear(rgb[2]);
  const auto f = [](double t) {
    return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
  };
  const double x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
  const double y = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
  const double z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.0890);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

TEST(HeatColour, RunsFromNearBlackToPaleYellow) {
  EXPECT_THAT(heatColour(0),
              ElementsAre(FloatNear(0, 1e-3f), FloatNear(0, 1e-3f), FloatNear(4 / 255.0f, 1e-3f)));
  EXPECT_THAT(heatColour(1), ElementsAre(FloatNear(252 / 255.0f, 1e-3f), FloatNear(1, 1e-3f),
                                         FloatNear(164 / 255.0f, 1e-3f)));
  EXPECT_EQ(heatColour(-5), heatColour(0));
  EXPECT_EQ(heatColour(7), heatColour(1));
  EXPECT_THAT(heatColour(kNaN), ElementsAre(0, 1, 1));
}

TEST(HeatColour, OnlyGetsLighter) {
  double before = -1;
  for (int i = 0; i < 256; ++i) {
    const double lightness = cieLab(heatColour(float(i) / 255.0f))[0];
    EXPECT_GT(lightness, before) << i;
    before = lightness;
  }
}

TEST(HeatColour, EqualStepsLookEqual) {
  constexpr int kSteps = 32;
  double least = 1e9, most = 0;
  for (int i = 0; i < kSteps; ++i) {
    const auto a = cieLab(heatColour(float(i) / kSteps));
    const auto b = cieLab(heatColour(float(i + 1) / kSteps));
    const double step = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    least = std::min(least, step);
    most = std::max(most, step);
  }
  // The two spaces disagree by some; a rainbow map reaches 10.
  EXPECT_LT(most / least, 4.0) << least << " to " << most;
}

TEST(DifferencePicture, ShowsTheLargestColourDifference) {
  Image student(3, 1, 4, 0.5f), reference(3, 1, 4, 0.5f);
  student.at(1, 0, 1) = 0.6f;
  student.at(1, 0, 2) = 0.375f;
  student.at(2, 0, 3) = 0.0f; // alpha
  const Image picture = differencePicture(student, reference, 0.25f);
  ASSERT_EQ(picture.channels(), 4);
  const auto colourAt = [&](int x) {
    return std::array{picture.at(x, 0, 0), picture.at(x, 0, 1), picture.at(x, 0, 2)};
  };
  EXPECT_EQ(colourAt(0), heatColour(0));
  EXPECT_EQ(colourAt(1), heatColour(0.5f)); // 0.125 of 0.25
  EXPECT_EQ(colourAt(2), heatColour(0));
  EXPECT_EQ(picture.at(0, 0, 3), 1.0f);
}

TEST(DifferencePicture, ShowsNaNAndHasNothingForOtherSizes) {
  Image student(2, 1, 3), reference(2, 1, 3);
  student.at(0, 0, 0) = kNaN; // the channels after it are equal
  const Image picture = differencePicture(student, reference);
  EXPECT_THAT(picture.pixel(0, 0), ElementsAre(0, 1, 1, 1));
  EXPECT_TRUE(differencePicture(student, Image(3, 1, 3)).empty());
  EXPECT_TRUE(differencePicture(Image(), reference).empty());
  EXPECT_THROW(differencePicture(student, reference, 0), std::invalid_argument);
}

TEST(MarkWindow, DrawsAroundTheWindow) {
  Image image(20, 20, 3);
  markWindow(image, {.x = 8, .y = 8, .width = 4, .height = 4}, {1, 0, 0}, 2);
  int painted = 0;
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) painted += image.at(x, y, 0) == 1;
  EXPECT_EQ(painted, 8 * 8 - 4 * 4);
  EXPECT_EQ(image.at(8, 8, 0), 0);
  EXPECT_THAT(image.pixel(7, 7), ElementsAre(1, 0, 0));
}

TEST(MarkWindow, IsClippedAndKnowsOtherLayouts) {
  Image grey(4, 4, 1), rgba(4, 4, 4);
  markWindow(grey, {.x = 0, .y = 0, .width = 3, .height = 3}, {0.3f, 0.6f, 0.9f}, 5);
  EXPECT_NEAR(grey.at(3, 0), 0.6f, 1e-6);
  EXPECT_EQ(grey.at(2, 2), 0);
  markWindow(rgba, {.x = 0, .y = 0, .width = 3, .height = 3});
  EXPECT_THAT(rgba.pixel(3, 3), ElementsAre(0, 1, 0, 1));
  Image untouched(4, 4, 1);
  markWindow(untouched, {});
  EXPECT_EQ(untouched.at(0, 0), 0);
}

} // namespace
