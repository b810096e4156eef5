// Irradiance against its definition: the integral of radiance times cosine, summed in double
// precision by other means than irradiance.hpp's.

#include "irradiance.hpp"

#include <gmock/gmock.h>

#include <iostream>

namespace {

using glm::dvec3;
using glm::vec3;

constexpr double kPi = std::numbers::pi;

/// A piece of the sphere: its middle and its radiance times its solid angle.
struct Piece {
  dvec3 direction;
  dvec3 light;
};

/// The disc, in rings of equal area.
void addDisc(std::vector<Piece>& pieces, const Sky& sky, int rings, int around) {
  const dvec3 middle = glm::normalize(dvec3(sky.sunDirection));
  const dvec3 u = glm::normalize(
      glm::cross(middle, std::abs(middle.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 0, 1)));
  const dvec3 v = glm::cross(middle, u);
  const double low = std::cos(double(sky.sunRadius)), area = 2 * kPi * (1 - low) / rings / around;
  for (int i = 0; i < rings; ++i)
    for (int k = 0; k < around; ++k) {
      const double z = low + (1 - low) * (i + 0.5) / rings, r = std::sqrt(1 - z * z);
      const double turn = 2 * kPi * (k + 0.5) / around;
      pieces.push_back({z * middle + r * (std::cos(turn) * u + std::sin(turn) * v),
                        area * dvec3(sky.sunRadiance)});
    }
}

/// The sky without its disc, in bands of equal area, the horizon between two of them.
void addSky(std::vector<Piece>& pieces, const Sky& sky, int bands, int around) {
  for (int i = 0; i < bands; ++i)
    for (int k = 0; k < around; ++k) {
      const double y = 1 - 2 * (i + 0.5) / bands, r = std::sqrt(1 - y * y);
      const double turn = 2 * kPi * (k + 0.5) / around;
      const dvec3 direction(r * std::cos(turn), y, r * std::sin(turn));
      pieces.push_back({direction, 4 * kPi / bands / around * dvec3(skyRadiance(sky, direction))});
    }
}

dvec3 summed(const std::vector<Piece>& pieces, const dvec3& normal) {
  dvec3 sum(0);
  for (const Piece& piece : pieces)
    sum += std::max(glm::dot(normal, piece.direction), 0.0) * piece.light;
  return sum;
}

/// Normals spread evenly over the sphere, and the axes.
std::vector<vec3> normals() {
  std::vector<vec3> all = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  constexpr int kCount = 150;
  for (int i = 0; i < kCount; ++i) {
    const double y = 1 - 2 * (i + 0.5) / kCount, r = std::sqrt(1 - y * y), turn = 2.4 * i;
    all.emplace_back(r * std::cos(turn), y, r * std::sin(turn));
  }
  return all;
}

struct Named {
  const char* name;
  Sky sky;
  int needed; // degree of harmonics, as irradianceMap's comment says
};

std::vector<Named> skies() {
  Sky evening, night, oneSided;
  evening.zenith = {0.1f, 0.15f, 0.4f}, evening.horizon = {2, 0.9f, 0.4f};
  evening.sunDirection = glm::normalize(vec3(-0.8f, 0.02f, 0.3f));
  night.zenith = vec3(0.01f), night.horizon = vec3(3), night.ground = vec3(0);
  night.sunRadiance = vec3(0);
  oneSided.zenith = oneSided.horizon = vec3(1), oneSided.ground = vec3(0);
  oneSided.sunRadius = 0.3f, oneSided.sunRadiance = vec3(5);
  return {{"a clear day", {}, 2},
          {"a low sun", evening, 4},
          {"light from the horizon alone", night, 8},
          {"white above, black below, a large sun", oneSided, 2}};
}

Sky withoutSun(Sky sky) {
  sky.sunRadiance = vec3(0);
  return sky;
}

/// The irradiance of a sky and its sun by definition, for every normal.
class Definition {
public:
  explicit Definition(const Sky& sky) {
    std::vector<Piece> pieces;
    addSky(pieces, sky, 200, 400);
    addDisc(pieces, sky, 60, 200);
    for (const vec3& normal : normals()) {
      wanted_.push_back(summed(pieces, dvec3(normal)));
      for (int c = 0; c < 3; ++c) peak_ = std::max(peak_, wanted_.back()[c]);
    }
  }
  /// The largest difference of any channel, as a share of the largest irradiance.
  template <class Irradiance> double error(Irradiance irradianceOf) const {
    double most = 0;
    std::size_t i = 0;
    for (const vec3& normal : normals()) {
      const dvec3 apart = glm::abs(dvec3(irradianceOf(normal)) - wanted_[i++]);
      most = std::max({most, apart.x, apart.y, apart.z});
    }
    return most / peak_;
  }

private:
  std::vector<dvec3> wanted_;
  double peak_ = 0;
};

TEST(Harmonics, AreOrthonormalUpToDegreeEight) {
  // 400 bands of equal area and 20 steps around: exact around, to 1e-4 along.
  constexpr int kBands = 400, kAround = 20;
  std::vector<std::vector<double>> products(81, std::vector<double>(81));
  for (int i = 0; i < kBands; ++i)
    for (int k = 0; k < kAround; ++k) {
      const double z = 1 - 2 * (i + 0.5) / kBands, r = std::sqrt(1 - z * z);
      const double turn = 2 * kPi * k / kAround;
      const std::vector<double> values =
          harmonicsAt({r * std::cos(turn), r * std::sin(turn), z}, 8);
      ASSERT_EQ(values.size(), 81u);
      for (std::size_t a = 0; a < 81; ++a)
        for (std::size_t b = 0; b < 81; ++b)
          products[a][b] += values[a] * values[b] * 4 * kPi / kBands / kAround;
    }
  for (std::size_t a = 0; a < 81; ++a)
    for (std::size_t b = 0; b < 81; ++b)
      EXPECT_NEAR(products[a][b], a == b ? 1 : 0, 2e-3) << a << " " << b;
}

// The constants of Ramamoorthi and Hanrahan, equation 3.
TEST(Harmonics, AreThePublishedOnesUpToDegreeTwo) {
  const dvec3 d = glm::normalize(dvec3(0.3, -0.5, 0.7));
  const std::vector<double> values = harmonicsAt(d, 2);
  const double wanted[] = {0.282095,
                           0.488603 * d.y,
                           0.488603 * d.z,
                           0.488603 * d.x,
                           1.092548 * d.x * d.y,
                           1.092548 * d.y * d.z,
                           0.315392 * (3 * d.z * d.z - 1),
                           1.092548 * d.x * d.z,
                           0.546274 * (d.x * d.x - d.y * d.y)};
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(values[i], wanted[i], 1e-6) << i;
}

// 2 pi times the integral of u P_l(u) over u from 0 to 1.
TEST(Irradiance, TheCosinesFactorsAreItsLegendreCoefficients) {
  constexpr int kSteps = 20000;
  for (unsigned l = 0; l <= 12; ++l) {
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double u = (i + 0.5) / kSteps;
      sum += u * std::legendre(l, u) / kSteps;
    }
    EXPECT_NEAR(cosineFactor(int(l)), 2 * kPi * sum, 1e-6) << l;
  }
}

/// The largest difference from pi times `light`, as a share of it, over all normals.
template <class Irradiance> double worstOfConstant(float light, Irradiance irradianceOf) {
  double most = 0;
  for (const vec3& normal : normals())
    most = std::max(most, std::abs(double(irradianceOf(normal).y) / (kPi * double(light)) - 1));
  return most;
}

TEST(Irradiance, OfAConstantEnvironmentIsPiTimesIt) {
  const float light = 0.7f;
  const auto constant = [&](int width) {
    return tabulate(width, [&](const vec3&) { return vec3(0, light, 0); });
  };
  for (const int degree : {0, 1, 2, 5, 8}) {
    const Harmonics harmonics = project(constant(64), degree);
    EXPECT_LT(worstOfConstant(light, [&](const vec3& n) { return irradiance(harmonics, n); }), 1e-5)
        << degree;
  }
  // The surface's plane cuts texels, unless it is level.
  double before = 1;
  for (const int width : {16, 64, 256}) {
    const std::vector<Lamp> all = lamps(constant(width));
    EXPECT_NEAR(irradiance(all, {0, 1, 0}).y, kPi * double(light), 1e-5);
    EXPECT_NEAR(irradiance(all, {0, -1, 0}).y, kPi * double(light), 1e-5);
    const double error = worstOfConstant(light, [&](const vec3& n) { return irradiance(all, n); });
    EXPECT_LT(error, before / 8) << width;
    before = error;
  }
  EXPECT_LT(before, 1e-4);
}

TEST(Irradiance, IsNeverNegative) {
  // Two degrees are too few for a point: behind it they fall below 0.
  EnvironmentMap map{64, 32, std::vector<vec3>(64 * 32)};
  map.texels[20] = vec3(1000);
  const Harmonics harmonics = project(map, 2);
  for (const vec3& normal : normals()) EXPECT_GE(irradiance(harmonics, normal).x, 0);
}

// Seen whole, cut at every height, and set.
TEST(Irradiance, OfTheDiscIsTheIntegralOverIt) {
  Sky sky;
  sky.sunRadiance = {1, 2, 4};
  for (const float radius : {0.00465f, 0.1f, 0.5f})
    for (const double height : {-1.2, -1.0, -0.9, -0.5, -0.1, 0.0, 0.1, 0.5, 0.9, 0.99, 1.0, 1.01,
                                2.0}) { // of the disc's middle over the surface, in radii
      sky.sunRadius = radius;
      // A normal at that angle from the sun, about an axis of no special direction.
      const dvec3 s = glm::normalize(dvec3(sky.sunDirection));
      const dvec3 u = glm::normalize(glm::cross(s, dvec3(0.2, -0.3, 0.9)));
      const double angle = kPi / 2 - height * double(radius);
      const vec3 normal(std::cos(angle) * s + std::sin(angle) * u);
      std::vector<Piece> pieces;
      addDisc(pieces, sky, 250, 1000);
      const dvec3 wanted = summed(pieces, dvec3(normal));
      const dvec3 found(discIrradiance(sky, normal));
      // The normal's rounding moves the disc by 1e-7; the sum is good for 1e-6 of the whole disc.
      const double half = 2.0 / 3 * std::pow(double(radius), 3);
      EXPECT_NEAR(found.x, wanted.x, 1e-3 * wanted.x + 2e-4 * half) << radius << " " << height;
      EXPECT_NEAR(found.z, 4 * found.x, 1e-5 * found.z);
      if (height <= -1.2) {
        EXPECT_EQ(found.x, 0);
      }
    }
}

// A half disc: radius minus sine times cosine, the segment of a circle.
TEST(Irradiance, OfAHalfDiscIsASegment) {
  Sky sky;
  sky.sunDirection = {1, 0, 0};
  sky.sunRadiance = vec3(1);
  for (const float radius : {0.00465f, 0.1f, 0.5f}) {
    sky.sunRadius = radius;
    const double r = double(radius), wanted = r - std::sin(r) * std::cos(r);
    EXPECT_NEAR(discIrradiance(sky, {0, 1, 0}).x, wanted, 1e-6 * wanted);
  }
  sky.sunRadius = 0.1f;
  const double straight = kPi * std::pow(std::sin(0.1), 2);
  EXPECT_NEAR(discIrradiance(sky, {1, 0, 0}).x, straight, 1e-6 * straight);
  EXPECT_EQ(discIrradiance(sky, {-1, 0, 0}).x, 0);
}

// What irradianceMap's comment claims.
TEST(Irradiance, HarmonicsAndTheDiscAreWithinOnePercent) {
  for (const auto& [name, sky, needed] : skies()) {
    const Definition definition(sky);
    for (const int degree : {0, 1, 2, 4, 6, 8}) {
      const Harmonics harmonics = project(environmentMap(withoutSun(sky), 64), degree);
      const double error = definition.error([&](const vec3& normal) {
        return irradiance(harmonics, normal) + discIrradiance(sky, normal);
      });
      std::cout << name << ", degree " << degree << ": " << 100 * error
                << "% of the largest irradiance\n";
      RecordProperty(std::string(name) + ", degree " + std::to_string(degree),
                     std::to_string(error));
      EXPECT_EQ(error < 0.01, degree >= needed) << name << ", degree " << degree;
    }
  }
}

// Why the sun stays out of the harmonics.
TEST(Irradiance, TheSunInHarmonicsIsWorse) {
  const Harmonics harmonics = project(environmentMap(Sky(), 256), 2);
  EXPECT_GT(
      Definition(Sky()).error([&](const vec3& normal) { return irradiance(harmonics, normal); }),
      0.02);
}

TEST(Irradiance, BruteForceIsWithinOnePercent) {
  for (const auto& [name, sky, needed] : skies()) {
    const std::vector<Lamp> all = lamps(environmentMap(sky, 256));
    const double error =
        Definition(sky).error([&](const vec3& normal) { return irradiance(all, normal); });
    std::cout << name << ", 256 x 128 texels: " << 100 * error << "%\n";
    EXPECT_LT(error, 0.01) << name;
  }
}

// As maps, and both ways to make one.
TEST(Irradiance, MapsAreLookedUpAsTheEnvironmentIs) {
  const Sky sky;
  const EnvironmentMap smooth = irradianceMap(sky, 6, 16);
  const EnvironmentMap summedUp = irradianceMap(environmentMap(sky, 128), 16);
  ASSERT_EQ(smooth.texels.size(), 128u);
  ASSERT_EQ(summedUp.texels.size(), 128u);
  std::vector<Piece> pieces;
  addSky(pieces, sky, 200, 400);
  addDisc(pieces, sky, 60, 200);
  for (std::size_t i = 0; i < 128; ++i) {
    const dvec3 normal(directionOf({(i % 16 + 0.5) / 16, (double(i / 16) + 0.5) / 8}));
    const dvec3 wanted = summed(pieces, normal);
    EXPECT_LT(glm::length(dvec3(smooth.texels[i]) - wanted), 0.06) << i;
    EXPECT_LT(glm::length(dvec3(summedUp.texels[i]) - wanted), 0.12) << i;
  }
}

// What a map loses when it is summed up in fewer texels, the sun in one of them.
TEST(Irradiance, ACoarserMapGivesAsMuch) {
  const EnvironmentMap fine = environmentMap(Sky(), 600);
  const EnvironmentMap coarse = coarser(fine, 256);
  ASSERT_EQ(coarse.texels.size(), 256u * 128);
  dvec3 all(0), left(0);
  for (std::size_t i = 0; i < fine.texels.size(); ++i)
    all += solidAngle(fine, int(i) / 600) * dvec3(fine.texels[i]);
  for (std::size_t i = 0; i < coarse.texels.size(); ++i)
    left += solidAngle(coarse, int(i) / 256) * dvec3(coarse.texels[i]);
  EXPECT_LT(glm::length(all - left), 1e-5 * glm::length(all));
  const std::vector<Lamp> lampsOfIt = lamps(coarse);
  EXPECT_LT(
      Definition(Sky()).error([&](const vec3& normal) { return irradiance(lampsOfIt, normal); }),
      0.01);
}

} // namespace
