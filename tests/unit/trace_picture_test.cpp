// Pictures of what passes left.

#include "trace/picture.hpp"

#include "trace_samples.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace ggrade::trace {
namespace {

using samples::depthAt;
using samples::mirror;
using samples::perspective;
using testing::ElementsAre;
using testing::FloatNear;

std::vector<float> at(const CopyPicture& picture, int x, int y) {
  const auto values = picture.rgb.pixel(x, y);
  return {values.begin(), values.end()};
}

/// The picture of a copy of the first pass.
template <typename Value>
CopyPicture pictureOf(std::uint32_t attachment, PixelType type, std::uint32_t width,
                      const std::vector<Value>& values, std::uint32_t format = GL_RGBA32F) {
  Trace trace = mirror();
  trace.passes[0].images[0].format = format;
  const CopyRecord copy = samples::addCopy(trace, 0, attachment, type, width, 1, values);
  return picture(trace, copy);
}

TEST(TracePicture, HighRangeIsDividedByItsGreatestValue) {
  const Trace trace = mirror();
  const CopyPicture shown = picture(trace, trace.copies[0]);
  EXPECT_EQ(shown.scale, "divided by the greatest value");
  EXPECT_EQ(shown.high, 2);
  EXPECT_THAT(at(shown, 0, 0), ElementsAre(0.25F, 0.5F, 1));
  EXPECT_THAT(at(shown, 1, 0), ElementsAre(0, 0, 0));
}

TEST(TracePicture, WhatFitsIsShownAsStored) {
  const CopyPicture bytes = pictureOf<std::uint8_t>(0, PixelType::u8x4, 1, {0, 51, 255, 0});
  EXPECT_EQ(bytes.scale, "as stored");
  EXPECT_THAT(at(bytes, 0, 0), ElementsAre(0, 0.2F, 1));
  const CopyPicture floats = pictureOf<float>(0, PixelType::f32x4, 1, {-3, 0.5F, 1, 9});
  EXPECT_EQ(floats.scale, "as stored") << "alpha is not shown";
  EXPECT_THAT(at(floats, 0, 0), ElementsAre(0, 0.5F, 1));
}

TEST(TracePicture, NoNumberStandsOut) {
  const CopyPicture shown = pictureOf<float>(
      0, PixelType::f32x4, 4, {NAN, 0, 0, 1, INFINITY, 0, 0, 1, -INFINITY, NAN, 0, 1, 4, 2, 1, 1});
  EXPECT_THAT(at(shown, 0, 0), ElementsAre(1, 0, 1));
  EXPECT_THAT(at(shown, 1, 0), ElementsAre(0, 1, 1));
  EXPECT_THAT(at(shown, 2, 0), ElementsAre(1, 0, 1));
  EXPECT_THAT(at(shown, 3, 0), ElementsAre(1, 0.5F, 0.25F)) << "the scale is of finite values";
  EXPECT_EQ(shown.high, 4);
}

TEST(TracePicture, OneChannelIsGrey) {
  const CopyPicture shown = pictureOf<float>(0, PixelType::f32x4, 1, {0.5F, 0, 0, 1}, GL_R32F);
  EXPECT_THAT(at(shown, 0, 0), ElementsAre(0.5F, 0.5F, 0.5F));
}

TEST(TracePicture, DepthIsInEvenStepsOfDistance) {
  const Trace trace = mirror();
  const CopyPicture shown = picture(trace, trace.copies[1]);
  EXPECT_EQ(shown.scale, "stretched depth by uProjection");
  EXPECT_NEAR(shown.low, 2, 1e-5);
  EXPECT_NEAR(shown.high, 4, 1e-5);
  EXPECT_THAT(at(shown, 0, 0), testing::Each(FloatNear(0, 1e-5F)));
  EXPECT_THAT(at(shown, 1, 0), testing::Each(FloatNear(1, 1e-5F)));
  EXPECT_THAT(at(shown, 0, 1), testing::Each(FloatNear(0.5435F, 1e-3F)))
      << "a little more than half";
  EXPECT_THAT(at(shown, 1, 1), ElementsAre(1, 1, 1)) << "only cleared";
}

/// a times b, column by column.
void multiply(MatrixRecord& a, const float (&b)[16]) {
  float product[16] = {};
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      for (int k = 0; k < 4; ++k)
        product[4 * column + row] += a.values[4 * k + row] * b[4 * column + k];
  std::copy(product, product + 16, a.values);
}

TEST(TracePicture, AProductOfAProjectionServesAsWell) {
  Trace trace = mirror();
  const float c = 0.8F, s = 0.6F;
  const float view[16] = {c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 3, -2, -7, 1};
  trace.matrices = {perspective("uShadow", 1, 9)};
  multiply(trace.matrices[0], view);
  const auto scale = depthScale(trace, trace.passes[0]);
  ASSERT_TRUE(scale);
  EXPECT_EQ(scale->matrix, "uShadow");
  for (const float distance : {1.0F, 2.5F, 9.0F})
    EXPECT_NEAR(scale->distance(depthAt(distance, 1, 9)), distance, 1e-4F);
  // The projection itself is preferred.
  trace.matrices.push_back(perspective("uProjection", 0.5F, 20));
  trace.steps[0].matrixCount = 2;
  EXPECT_EQ(depthScale(trace, trace.passes[0])->matrix, "uProjection");
}

TEST(TracePicture, WithoutAPerspectiveDepthIsStretched) {
  Trace trace = mirror();
  MatrixRecord& matrix = trace.matrices[0];
  const auto set = [&](std::initializer_list<float> values) {
    std::copy(values.begin(), values.end(), matrix.values);
  };
  // Orthographic; an oblique near plane; nothing at all; no numbers.
  set({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -0.2F, 0, 0, 0, -1, 1});
  EXPECT_FALSE(depthScale(trace, trace.passes[0]));
  set({1, 0, 0.5F, 0, 0, 1, 0.25F, 0, 0, 0, -1, -1, 0, 0, -2, 0});
  EXPECT_FALSE(depthScale(trace, trace.passes[0]));
  set({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_FALSE(depthScale(trace, trace.passes[0]));
  set({NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN});
  EXPECT_FALSE(depthScale(trace, trace.passes[0]));
  const CopyRecord copy =
      samples::addCopy<float>(trace, 0, kDepth, PixelType::f32x1, 4, 1, {0.5F, 1, 0.875F, 0.75F});
  const CopyPicture shown = picture(trace, copy);
  EXPECT_EQ(shown.scale, "stretched depth");
  EXPECT_EQ(shown.low, 0.5);
  EXPECT_EQ(shown.high, 0.875);
  EXPECT_THAT(at(shown, 0, 0), ElementsAre(0, 0, 0));
  EXPECT_THAT(at(shown, 1, 0), ElementsAre(1, 1, 1));
  EXPECT_THAT(at(shown, 2, 0), ElementsAre(1, 1, 1));
  EXPECT_THAT(at(shown, 3, 0), testing::Each(FloatNear(0.5F, 1e-3F)));
}

TEST(TracePicture, DepthOfNothingAndOfOneValue) {
  const CopyPicture cleared = pictureOf<float>(kDepth, PixelType::f32x1, 2, {1, 1});
  EXPECT_THAT(at(cleared, 1, 0), ElementsAre(1, 1, 1));
  EXPECT_EQ(cleared.low, 0);
  const CopyPicture flat = pictureOf<float>(kDepth, PixelType::f32x1, 2, {0.5F, 0.5F});
  EXPECT_THAT(at(flat, 0, 0), ElementsAre(0, 0, 0));
  const CopyPicture odd = pictureOf<float>(kDepth, PixelType::f32x1, 2, {NAN, 0.5F});
  EXPECT_THAT(at(odd, 0, 0), ElementsAre(1, 0, 1));
}

TEST(TracePicture, IntegersHaveAColourEach) {
  const CopyPicture stencil = pictureOf<std::uint8_t>(kStencil, PixelType::u8x1, 4, {0, 1, 2, 1});
  EXPECT_EQ(stencil.scale, "a colour a value");
  EXPECT_EQ(stencil.high, 2);
  EXPECT_THAT(at(stencil, 0, 0), ElementsAre(0, 0, 0));
  EXPECT_EQ(at(stencil, 1, 0), at(stencil, 3, 0));
  double apart = 0;
  for (std::size_t c = 0; c < 3; ++c)
    apart += std::abs(at(stencil, 1, 0)[c] - at(stencil, 2, 0)[c]);
  EXPECT_GT(apart, 0.3);
  const CopyPicture integers = pictureOf<std::int32_t>(
      0, PixelType::i32x4, 3, {-5, 0, 0, 1, 5, 0, 0, 1, 5, 0, 0, 9}, GL_RGBA32I);
  EXPECT_NE(at(integers, 0, 0), at(integers, 1, 0));
  EXPECT_EQ(at(integers, 1, 0), at(integers, 2, 0)) << "alpha is not shown";
}

} // namespace
} // namespace ggrade::trace
