#include "flip_direct.hpp"
#include "flip_pictures.hpp"

#include "image/flip.hpp"
#include "image/flip_filters.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace ggrade;
using namespace flip_pictures;

namespace {

constexpr double kPpd = kFlipPixelsPerDegree;

flip_direct::Picture linearPicture(const Image& srgb) {
  flip_direct::Picture picture{srgb.width(), srgb.height(), {}};
  for (int y = 0; y < srgb.height(); ++y)
    for (int x = 0; x < srgb.width(); ++x) {
      flip_direct::Colour colour;
      for (int c = 0; c < 3; ++c)
        colour[std::size_t(c)] = flip_direct::linearFromSrgb(double(srgb.at(x, y, c)));
      picture.pixels.push_back(colour);
    }
  return picture;
}

std::string refusal(const Image& student, const Image& reference, double ppd = kPpd) {
  try {
    ldrFlip(student, reference, ppd);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Flip, IsExactlyZeroForIdenticalImages) {
  for (const int channels : {1, 3, 4})
    for (const int side : {1, 2, 19, 40}) {
      const Image image = noise(std::uint32_t(side), side, side + 3, channels);
      const Flip found = ldrFlip(image, image);
      EXPECT_EQ(found.mean, 0.0);
      ASSERT_EQ(found.map.sizeText(), image.sizeText());
      EXPECT_EQ(found.map.channels(), 1);
      EXPECT_EQ(largest(found.map), 0.0f);
    }
}

// A constant image has no features, and no filter changes it: what is left is the closed form.
TEST(Flip, OfConstantsIsTheDistanceOfTheirColours) {
  const std::array<std::array<float, 3>, 8> colours{{{0, 0, 0},
                                                     {1, 1, 1},
                                                     {0, 1, 0},
                                                     {0, 0, 1},
                                                     {0.2f, 0.4f, 0.8f},
                                                     {0.4f, 0.4f, 0.6f},
                                                     {0.5f, 0.5f, 0.5f},
                                                     {0.01f, 0.02f, 0}}};
  for (const auto& p : colours)
    for (const auto& q : colours) {
      const Image a = constant(9, 5, p[0], p[1], p[2]), b = constant(9, 5, q[0], q[1], q[2]);
      const double expected =
          flip_direct::colourError(linearPicture(a).pixels[0], linearPicture(b).pixels[0]);
      const Flip found = ldrFlip(a, b);
      EXPECT_NEAR(found.mean, expected, 3e-6)
          << p[0] << p[1] << p[2] << ' ' << q[0] << q[1] << q[2];
      for (const float error : found.map.values()) EXPECT_NEAR(double(error), expected, 3e-6);
    }
}

// By hand: black and white differ by 100 in L and in nothing else. Green and blue, the farthest
// apart on a screen, differ by 203.3017.
TEST(Flip, ReachesOneForGreenAndBlueAndNearlySoForBlackAndWhite) {
  EXPECT_NEAR(ldrFlip(constant(4, 4, 0, 1, 0), constant(4, 4, 0, 0, 1)).mean, 1.0, 1e-6);
  const double largest = std::pow(203.3017, 0.7), error = std::pow(100.0, 0.7);
  EXPECT_NEAR(ldrFlip(Image(4, 4, 1, 0.0f), Image(4, 4, 1, 1.0f)).mean,
              0.95 + 0.05 * (error - 0.4 * largest) / (0.6 * largest), 2e-6);
}

class FlipImpulse : public testing::TestWithParam<double> {};

// An impulse shows a filter's weights: the products of lines against the paper's 2D kernels.
TEST_P(FlipImpulse, OfTheFiltersIsThePapersKernel) {
  const double ppd = GetParam();
  const int reach = flip::filterReach(ppd), side = 2 * reach + 3, middle = reach + 1;
  flip::Plane impulse(side, side);
  impulse.row(middle)[middle] = 1;
  const auto response = [&](const flip::LineFilter& across, const flip::LineFilter& down) {
    const flip::Plane rows = alongRows(impulse, across);
    flip::Plane all(side, side);
    for (int y = 0; y < side; ++y) alongColumns(rows, down, y, all.row(y));
    return all;
  };
  // A filter is applied turned by 180 degrees to what an impulse shows.
  const auto expectKernel = [&](const flip::Plane& found, const flip_direct::Kernel& expected,
                                const char* what) {
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x) {
        const bool inside = std::max(std::abs(x), std::abs(y)) <= expected.radius;
        EXPECT_NEAR(double(found.row(middle - y)[middle - x]), inside ? expected.at(x, y) : 0.0,
                    1e-7)
            << what << ' ' << x << ' ' << y;
      }
  };
  const auto spatial = flip::spatialFilters(ppd);
  expectKernel(response(spatial.y, spatial.y), flip_direct::sensitivity(0, ppd), "Y");
  expectKernel(response(spatial.cx, spatial.cx), flip_direct::sensitivity(1, ppd), "Cx");
  flip::Plane cz = response(spatial.cz1, spatial.cz1);
  const flip::Plane second = response(spatial.cz2, spatial.cz2);
  for (std::size_t i = 0; i < cz.values.size(); ++i) cz.values[i] += second.values[i];
  expectKernel(cz, flip_direct::sensitivity(2, ppd), "Cz");
  const auto feature = flip::featureFilters(ppd);
  expectKernel(response(feature.edge, feature.gauss), flip_direct::feature(false, ppd), "edge");
  expectKernel(response(feature.point, feature.gauss), flip_direct::feature(true, ppd), "point");
}

INSTANTIATE_TEST_SUITE_P(PixelsPerDegree, FlipImpulse, testing::Values(1.0, 20.0, kPpd, 120.0));

struct Pair {
  const char* name;
  Image student, reference;
};

// What this implementation and the paper's definitions, computed without any shortcut, agree on.
TEST(Flip, AgreesWithTheDefinitionPixelByPixel) {
  const std::array<Pair, 6> pairs{
      {{"noise", noise(2, 27, 18), noise(1, 27, 18)},
       {"square", withSquare(gradient(40, 20), 25, 8, 4, 1, 0, 0), gradient(40, 20)},
       {"step", step(40, 9, 21), step(40, 9, 20)},
       {"row", noise(4, 40, 1), noise(3, 40, 1)},
       {"column", noise(4, 1, 40), noise(3, 1, 40)},
       {"one pixel", constant(1, 1, 0.6f, 0.4f, 0.2f), constant(1, 1, 0.2f, 0.4f, 0.6f)}}};
  for (const double ppd : {kPpd, 25.0})
    for (const Pair& pair : pairs) {
      const Flip found = ldrFlip(pair.student, pair.reference, ppd);
      const auto expected =
          flip_direct::errors(linearPicture(pair.student), linearPicture(pair.reference), ppd);
      double mean = 0;
      for (std::size_t i = 0; i < expected.size(); ++i) {
        // A colour difference near 0 is raised to the power 0.7: rounding shows.
        EXPECT_NEAR(double(found.map.values()[i]), expected[i], 5e-4) << pair.name << ' ' << i;
        mean += expected[i] / double(expected.size());
      }
      EXPECT_NEAR(found.mean, mean, 2e-5) << pair.name << ' ' << ppd;
    }
}

// Means that the authors' own program gives: github.com/NVlabs/flip, FLIP.h of version 1.6.0.1,
// commit 1eb247c, its map averaged in double precision. In constant images its rounding leaves a
// feature of 1e-8, whose square root shows in the fifth digit; hence the tolerance.
TEST(Flip, AgreesWithTheAuthorsProgram) {
  const auto mean = [](const Image& reference, const Image& student) {
    return ldrFlip(student, reference).mean;
  };
  EXPECT_NEAR(mean(Image(32, 24, 3, 0.0f), Image(32, 24, 3, 1.0f)), 0.96738833, 1e-4);
  EXPECT_NEAR(mean(constant(32, 24, 0, 0, 1), constant(32, 24, 0, 1, 0)), 1.0, 1e-4);
  EXPECT_NEAR(mean(constant(8, 8, 51 / 255.f, 102 / 255.f, 204 / 255.f),
                   constant(8, 8, 102 / 255.f, 102 / 255.f, 153 / 255.f)),
              0.36321211, 1e-4);
  EXPECT_NEAR(mean(noise(1, 64, 48), noise(2, 64, 48)), 0.43158367, 1e-4);
  EXPECT_NEAR(mean(step(64, 16, 32), step(64, 16, 33)), 0.03549838, 1e-4);
  EXPECT_NEAR(mean(gradient(96, 64), withSquare(gradient(96, 64), 60, 30, 5, 1, 0, 0)), 0.00619052,
              1e-4);
  EXPECT_NEAR(mean(noise(3, 40, 1), noise(4, 40, 1)), 0.68954464, 1e-4);
  EXPECT_NEAR(mean(constant(1, 1, 0.2f, 0.4f, 0.6f), constant(1, 1, 0.6f, 0.4f, 0.2f)), 0.72990942,
              1e-4);
  EXPECT_NEAR(mean(noise(7, 512, 512), noise(8, 512, 512)), 0.43449292, 1e-4);
}

// The same change of colour counts more where it makes an edge.
TEST(Flip, CountsFeaturesThatOnlyOneImageHas) {
  const Image grey(64, 64, 3, 0.5f);
  Image half = grey;
  for (int y = 0; y < 64; ++y)
    for (int x = 32; x < 64; ++x)
      for (int c = 0; c < 3; ++c) half.at(x, y, c) = 0.7f;
  const Image map = ldrFlip(half, grey).map;
  EXPECT_GT(map.at(34, 32), map.at(60, 32) + 0.05f);
  EXPECT_NEAR(double(map.at(60, 32)), ldrFlip(Image(8, 8, 3, 0.7f), Image(8, 8, 3, 0.5f)).mean,
              1e-5);
  EXPECT_EQ(map.at(10, 32), 0.0f);
}

TEST(Flip, IsSymmetricAndFollowsAMirroredImage) {
  const Image a = noise(1, 33, 21), b = noise(2, 33, 21);
  const Flip forth = ldrFlip(a, b), back = ldrFlip(b, a);
  EXPECT_EQ(forth.mean, back.mean);
  const auto mirrored = [](const Image& image) {
    Image result = image;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        std::ranges::copy(image.pixel(image.width() - 1 - x, image.height() - 1 - y),
                          result.pixel(x, y).begin());
    return result;
  };
  const Image turned = mirrored(ldrFlip(mirrored(a), mirrored(b)).map);
  for (std::size_t i = 0; i < turned.values().size(); ++i)
    EXPECT_NEAR(turned.values()[i], forth.map.values()[i], 1e-4);
}

// Only the surroundings of what differs are computed: that must not show.
TEST(Flip, DoesNotDependOnHowFarDifferencesLieApart) {
  const Image reference = noise(1, 150, 120);
  const Image one = withSquare(reference, 70, 60, 3, 1, 0, 0);
  const Image corners = withSquare(withSquare(one, 0, 0, 1, 0, 1, 0), 149, 119, 1, 0, 1, 0);
  const Image alone = ldrFlip(one, reference).map, whole = ldrFlip(corners, reference).map;
  for (int y = 20; y < 100; ++y)
    for (int x = 20; x < 130; ++x) ASSERT_EQ(alone.at(x, y), whole.at(x, y)) << x << ' ' << y;
  EXPECT_GT(alone.at(71, 61), 0.1f);
  EXPECT_GT(whole.at(0, 0), 0.1f);
  EXPECT_EQ(alone.at(0, 0), 0.0f);
}

TEST(Flip, IgnoresAlphaAndReadsOneChannelAsGrey) {
  Image opaque = noise(1, 12, 9, 4), clear = opaque;
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 12; ++x) clear.at(x, y, 3) = 0;
  EXPECT_EQ(ldrFlip(clear, opaque).mean, 0.0);
  EXPECT_EQ(ldrFlip(firstChannels(clear, 3), opaque).mean, 0.0);
  EXPECT_EQ(ldrFlip(Image(5, 5, 1, 0.25f), Image(5, 5, 3, 0.25f)).mean, 0.0);
}

TEST(Flip, ClampsDisplayValues) {
  EXPECT_EQ(ldrFlip(constant(6, 6, -1e30f, -3, -0.0f), constant(6, 6, 0, 0, 0)).mean, 0.0);
  EXPECT_EQ(ldrFlip(constant(6, 6, 1e30f, 2, 1.001f), constant(6, 6, 1, 1, 1)).mean, 0.0);
  EXPECT_EQ(ldrFlip(Image(6, 6, 3, 1e30f), Image(6, 6, 3, -1e30f)).mean,
            ldrFlip(Image(6, 6, 3, 1.0f), Image(6, 6, 3, 0.0f)).mean);
}

TEST(Flip, StaysBetweenZeroAndOneWhateverTheShape) {
  for (const auto& [width, height] : {std::pair(1, 1), {1, 3000}, {3000, 1}, {2, 2}, {5, 700}})
    for (const double ppd : {1.0, 5.0, kPpd, 1000.0}) {
      const Flip found = ldrFlip(noise(1, width, height), noise(2, width, height), ppd);
      for (const float error : found.map.values()) ASSERT_TRUE(error >= 0 && error <= 1) << error;
      EXPECT_GT(found.mean, 0.001);
    }
}

TEST(Flip, RefusesWhatItCannotCompare) {
  const Image good(4, 3, 3, 0.5f);
  EXPECT_EQ(refusal(good, good), "accepted");
  EXPECT_EQ(refusal(Image(), good), "FLIP: there is no image");
  EXPECT_EQ(refusal(good, Image()), "FLIP: there is no reference image");
  EXPECT_EQ(refusal(Image(3, 4, 3), good), "FLIP: the image is 3x4, the reference 4x3");
  EXPECT_EQ(refusal(Image(4, 3, 2), good), "FLIP: two channels are no colour (the image)");
  Image bad = good;
  bad.at(1, 2, 1) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(refusal(bad, good),
            "FLIP: the image: 1 pixel holds NaN or Inf, the first NaN at (1,2), "
            "channel G");
  bad.at(1, 2, 1) = std::numeric_limits<float>::infinity();
  EXPECT_EQ(refusal(good, bad),
            "FLIP: the reference image: 1 pixel holds NaN or Inf, the first Inf "
            "at (1,2), channel G");
  const std::string range = "FLIP: pixels per degree must be 1 to 1000";
  for (const double ppd : {0.0, -67.0, 0.99, 1000.1, std::nan("")})
    EXPECT_EQ(refusal(good, good, ppd), range) << ppd;
}

// NaN in a channel that nobody sees is nobody's business.
TEST(Flip, DoesNotLookAtAlphaForNaN) {
  Image odd(4, 3, 4, 0.5f);
  odd.at(0, 0, 3) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(ldrFlip(odd, Image(4, 3, 4, 0.5f)).mean, 0.0);
}

} // namespace
