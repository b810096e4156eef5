// Every number that a quiz calls right, or a mistake to expect, reckoned anew from the geometry,
// the matrices and the rules that it is about.

#include "quiz_files.hpp"

#include <gmock/gmock.h>

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstdint>
#include <numeric>

using quizzes::OfPart;

namespace {

/// The right one first, then the mistakes, as the file has them.
using Reckoned = std::vector<double>;

constexpr double kPi = 3.14159265358979323846, kMiB = 1024.0 * 1024.0;

double radians(double degrees) {
  return degrees * kPi / 180;
}

/// The place on the line between `low` and `high` where a rising function is 0.
template <class Function> double zeroOf(const Function& function, double low, double high) {
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    (function(middle) < 0 ? low : high) = middle;
  }
  return low;
}

/// What a rasteriser would store of a point at this distance, from -1 to 1.
double deviceZ(double near, double far, double distance) {
  const glm::dmat4 projection = glm::frustum(-1.0, 1.0, -1.0, 1.0, near, far);
  const glm::dvec4 clip = projection * glm::dvec4(0, 0, -distance, 1);
  return clip.z / clip.w;
}

/// What sRGB has of light from 0 to 1.
double shownAs(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

Reckoned mirrorHeight() {
  const glm::dmat4 view = glm::lookAt(glm::dvec3(0, 3, 8), {0, 3, 0}, {0, 1, 0});
  const glm::dmat4 scale = glm::scale(glm::dmat4(1), {1, -1, 1});
  const glm::dvec4 point(0, 2, 0, 1);
  return {(view * scale * point).y, (scale * view * point).y, (view * point).y};
}

Reckoned mirrorClip() {
  int drawn = 0, all = 100000;
  for (int i = 0; i < all; ++i) drawn += std::lerp(0.3, -0.1, (i + 0.5) / all) >= 0;
  const double share = double(drawn) / all;
  return {share, 1 - share, 1};
}

Reckoned shadowDepth() {
  const double z = deviceZ(2, 10, 5);
  return {0.5 * z + 0.5, z, (5.0 - 2) / (10 - 2)};
}

/// By how far to go until the stored depth has risen by one step of 16 bits.
Reckoned shadowStep() {
  const double n = 0.1, f = 100, z = 50, step = std::pow(2.0, -16), h = 1e-4;
  const double slope = 0.5 * (deviceZ(n, f, z + h) - deviceZ(n, f, z - h)) / (2 * h);
  return {step / slope, (f - n) * step, step / slope / z};
}

/// A plane through the origin, light along -z: how far it falls over a texel's width.
Reckoned shadowSlope() {
  const glm::dvec3 normal(std::sin(radians(60)), 0, std::cos(radians(60)));
  const double width = 0.01, fall = width * normal.x / normal.z;
  EXPECT_NEAR(glm::dot(normal, glm::dvec3(width, 0, -fall)), 0, 1e-12);
  return {fall, width * normal.x, width * normal.z};
}

Reckoned shadowPcf() {
  const std::vector<double> stored = {0.3, 0.4, 0.9, 0.4};
  double lit = 0, mean = 0;
  for (double depth : stored) lit += (0.6 <= depth) / 4.0, mean += depth / 4;
  return {lit, double(0.6 <= mean), 1 - lit, mean};
}

Reckoned bloomBright() {
  const glm::dvec3 color(3, 1.5, 0.6);
  const double brightness = std::max({color.r, color.g, color.b});
  return {(color * (std::max(brightness - 1, 0.0) / brightness)).g, color.g - 1, color.g};
}

Reckoned bloomTexels() {
  int width = 800, height = 600, before = 0;
  for (int level = 0; level <= 3; ++level) {
    before = width * height;
    width = std::max(width / 2, 1), height = std::max(height / 2, 1);
  }
  return {double(width * height), double(before), 50.0 * std::ceil(75 / 2.0)};
}

Reckoned bloomShare() {
  double both = 0, one = 0;
  for (int level = 1; level < 50; ++level) {
    both += 100 * std::pow(0.5, level) * std::pow(0.5, level);
    one += 100 * std::pow(0.5, level);
  }
  return {both, one, 100 * 0.5 * 0.5};
}

Reckoned bloomDisplay() {
  const double inverse = zeroOf([&](double light) { return shownAs(light) - 0.1; }, 0, 1);
  return {shownAs(0 + 0.1), shownAs(0) + 0.1, inverse};
}

Reckoned targetsMemory() {
  const double pixels = 1280.0 * 720, half = 2, depth = 3;
  const auto inMiB = [&](double bytes) { return pixels * bytes / kMiB; };
  return {inMiB(3 * 4 * half + depth), inMiB(3 * 4 * 1 + depth), inMiB(4 * half + depth)};
}

Reckoned targetsEdge() {
  const std::vector<double> around = {0.5, 0.7, 0.6, 0.2};
  const double sum = std::accumulate(around.begin(), around.end(), 0.0), middle = 0.6;
  return {5 * middle - sum, middle + (middle - sum / 4), 0.25 * (5 * middle - sum)};
}

Reckoned targetsNegative() {
  const double diffuse = 5 * 0.1 - 4 * 0.3, others = 0.2 + 0.3;
  return {std::max(diffuse, 0.0) + others, diffuse + others, std::max(diffuse + others, 0.0)};
}

Reckoned figureBytes() {
  const double albedo = 4 * 2, normal = 2 * 2, ids = 2 * 1, depth = 3;
  return {albedo + normal + ids + depth, albedo + 4 * 2 + ids + depth, 4 * 1 + normal + ids + depth,
          albedo + normal + ids};
}

/// The irradiance summed up over rings of the half space.
Reckoned figureDiffuse() {
  double irradiance = 0;
  const int rings = 10000;
  for (int i = 0; i < rings; ++i) {
    const double angle = (i + 0.5) * kPi / 2 / rings;
    irradiance += 0.8 * std::cos(angle) * 2 * kPi * std::sin(angle) * (kPi / 2 / rings);
  }
  return {0.5 * irradiance / kPi, 0.5 * irradiance, 0.5 * 0.8 / kPi};
}

Reckoned figureFresnel() {
  const double f0 = 0.04, c = 0.2;
  return {f0 + (1 - f0) * std::pow(1 - c, 5), f0 + (1 - f0) * std::pow(c, 5),
          f0 + std::pow(1 - c, 5)};
}

Reckoned figureReflect() {
  const glm::dvec3 direction(0, -1, 0), normal(0.6, 0.8, 0);
  return {glm::reflect(direction, normal).y, glm::reflect(-direction, normal).y,
          (direction - glm::dot(direction, normal) * normal).y};
}

/// +1 for a front face, -1 for a back face.
std::uint8_t counted(std::initializer_list<int> faces) {
  return static_cast<std::uint8_t>(std::accumulate(faces.begin(), faces.end(), 0));
}

Reckoned volumeCount() {
  const std::uint8_t zPass = counted({1, 1, 1, -1});
  // Behind the surface, z-fail: one front face counts down, three back faces up.
  EXPECT_EQ(counted({-1, 1, 1, 1}), zPass);
  return {double(zPass), double(counted({1, 1, 1, 1})), double(counted({-1, -1, -1, 1}))};
}

Reckoned volumeSaturated() {
  const int stopped = std::max(0 - 1, 0) + 1;
  const std::uint8_t between = counted({-1});
  return {double(stopped), double(counted({-1, 1})), double(between)};
}

Reckoned volumeTriangles() {
  const int faces = 200, sides = 3 * faces, edges = sides / 2;
  return {double(faces + 2 * edges), double(faces + 2 * sides), double(faces + edges),
          double(2 * edges)};
}

Reckoned volumeInside() {
  return {double(counted({-1})), double(counted({})), double(counted({1}))};
}

Reckoned ssaoOpen() {
  const double radius = 0.5, hidden = std::max(1 - 0.3 / radius, 0.0);
  return {1 - 0.5 * hidden, 1 - 0.5, 1 - 0.5 * (1 - hidden), 0.5 * hidden};
}

Reckoned ssaoDistance() {
  const glm::dmat4 projection = glm::frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 9.0);
  EXPECT_NEAR(projection[2][2], -1.25, 1e-12);
  EXPECT_NEAR(projection[3][2], -2.25, 1e-12);
  const auto distanceAt = [](double z) {
    return zeroOf([&](double distance) { return deviceZ(1, 9, distance) - z; }, 1, 9);
  };
  return {distanceAt(2 * 0.875 - 1), distanceAt(0.875), std::lerp(1.0, 9.0, 0.875)};
}

Reckoned ssaoPoints() {
  const int all = 16, unknown = 2 + 3, hidden = 5;
  return {1 - double(hidden) / all, 1 - double(hidden) / (all - unknown),
          1 - double(hidden + unknown) / all};
}

/// The mean of luma between two pixels' middles, as a linear filter reads it.
double between(double here, double there, double shift) {
  return (1 - shift) * here + shift * there;
}

Reckoned antialiasShift() {
  // How deep a line from half a pixel in one row to half a pixel in the other still is.
  const double nearEnd = 2, farEnd = 8, length = nearEnd + farEnd;
  const auto depth = [&](double at) { return std::lerp(0.5, -0.5, at / length); };
  return {depth(nearEnd), nearEnd / length, 0.5 - nearEnd / farEnd, depth(farEnd)};
}

Reckoned antialiasBlend() {
  return {between(0.2, 0.8, 0.3), between(0.8, 0.2, 0.3), between(0.2, 0.8, 0.5),
          between(0.2, 0.8, 0)};
}

Reckoned antialiasSingle() {
  const double luma[3][3] = {{0.8, 0.2, 0.8}, {0.8, 0.2, 0.8}, {0.8, 0.2, 0.8}};
  const double weight[3][3] = {{1, 2, 1}, {2, 0, 2}, {1, 2, 1}};
  double sum = 0, weights = 0;
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) sum += weight[y][x] * luma[y][x], weights += weight[y][x];
  const double difference = std::abs(sum / weights - luma[1][1]), contrast = 0.8 - 0.2;
  const auto smooth = [](double x) { return x * x * (3 - 2 * x); };
  const auto squared = [](double x) { return x * x; };
  return {0.75 * squared(smooth(difference / contrast)), 0.75 * smooth(difference / contrast),
          0.75 * squared(difference / contrast), 0.75 * squared(smooth(difference))};
}

Reckoned antialiasLinear() {
  const auto lightOf = [](double shown) {
    return zeroOf([&](double light) { return shownAs(light) - shown; }, 0, 1);
  };
  return {lightOf(0.3) - lightOf(0.2), 0.3 - 0.2, lightOf(0.3)};
}

Reckoned motionBlurPixels() {
  const glm::dvec4 now(1.2, 0, 0, 2), last(0.4, 0, 0, 1);
  const auto pixel = [](double x) { return 480 * (0.5 * x + 0.5); };
  const double moved = pixel(now.x / now.w) - pixel(last.x / last.w);
  return {moved, 2 * moved, pixel(now.x) - pixel(last.x), -moved};
}

Reckoned motionBlurSample() {
  const double path = 24, samples = 4, piece = path / samples;
  const double begin = -path / 2 + 2 * piece; // of the third piece
  return {begin + piece / 2, begin + piece / 2 + path / 2, begin, 2 * path};
}

Reckoned motionBlurGems() {
  const double velocity = 6;
  const int samples = 16;
  double place = 0;
  for (int i = 1; i < samples; ++i) place += velocity;
  return {place, samples * velocity, velocity};
}

Reckoned motionBlurLight() {
  const auto toned = [](double light) { return 1 - std::exp(-light); };
  const double mean = 0.25 * 8;
  return {shownAs(toned(mean)), 0.25 * shownAs(toned(8)), toned(mean)};
}

Reckoned afterglowLeft() {
  const double tau = 0.25, frame = 1 / 50.0;
  double left = 1;
  for (int i = 0; i < 25; ++i) left *= std::exp(-frame / tau); // half a second
  return {left, std::exp(-frame / tau), std::exp(-0.5), std::pow(0.5, 0.5 / tau)};
}

Reckoned afterglowGhost() {
  int greatest = 0, whole = 0;
  for (int v = 0; v <= 255; ++v) {
    if (std::lround(0.96 * v) == v) greatest = std::max(greatest, v);
    if (v - 0.96 * v < 1 + 1e-9) whole = v;
  }
  return {double(greatest), double(whole), 0};
}

Reckoned afterglowTau() {
  const auto tau = [](double framesASecond) {
    return zeroOf([&](double t) { return std::exp(-1 / framesASecond / t) - 0.9; }, 1e-3, 10);
  };
  return {tau(30), tau(60), 1 / tau(30)};
}

Reckoned afterglowSum() {
  double light = 0, second = 0;
  for (int frame = 1; frame <= 1000; ++frame) {
    light = 1 + 0.875 * light;
    if (frame == 2) second = light;
  }
  double greater = 0;
  for (int frame = 1; frame <= 1000; ++frame) greater = std::max(1.0, 0.875 * greater);
  return {light, second, greater};
}

const std::map<std::string, Reckoned (*)()> kReckoned = {
    {"mirror.height", mirrorHeight},
    {"mirror.lookup",
     []() -> Reckoned {
       const double v = 0.5 * (2 * 120.5 / 480 - 1) + 0.5; // by way of device coordinates
       return {v, 120.5 / 1024, 120.5 / 640};
     }},
    {"mirror.clip", mirrorClip},
    {"shadow.depth", shadowDepth},
    {"shadow.step", shadowStep},
    {"shadow.slope", shadowSlope},
    {"shadow.pcf", shadowPcf},
    {"bloom.bright", bloomBright},
    {"bloom.texels", bloomTexels},
    {"bloom.share", bloomShare},
    {"bloom.display", bloomDisplay},
    {"targets.memory", targetsMemory},
    {"targets.edge", targetsEdge},
    {"targets.negative", targetsNegative},
    {"figure.bytes", figureBytes},
    {"figure.diffuse", figureDiffuse},
    {"figure.fresnel", figureFresnel},
    {"figure.reflect", figureReflect},
    {"shadow_volume.count", volumeCount},
    {"shadow_volume.saturated", volumeSaturated},
    {"shadow_volume.triangles", volumeTriangles},
    {"shadow_volume.inside", volumeInside},
    {"ssao.open", ssaoOpen},
    {"ssao.distance", ssaoDistance},
    {"ssao.points", ssaoPoints},
    {"antialias.shift", antialiasShift},
    {"antialias.blend", antialiasBlend},
    {"antialias.single", antialiasSingle},
    {"antialias.linear", antialiasLinear},
    {"motion_blur.pixels", motionBlurPixels},
    {"motion_blur.sample", motionBlurSample},
    {"motion_blur.gems", motionBlurGems},
    {"motion_blur.light", motionBlurLight},
    {"afterglow.left", afterglowLeft},
    {"afterglow.ghost", afterglowGhost},
    {"afterglow.sum", afterglowSum},
    {"afterglow.tau", afterglowTau},
};

TEST(QuizNumbers, AreWhatComesOutOfReckoning) {
  std::size_t asked = 0;
  for (const OfPart& one : quizzes::all())
    for (const ggrade::authoring::Question& question : one.quiz.questions) {
      if (!question.asksNumber) continue;
      const std::string id = one.part.id + '.' + question.id;
      SCOPED_TRACE(id);
      const auto found = kReckoned.find(id);
      ASSERT_NE(found, kReckoned.end()) << "reckon it here";
      ++asked;
      const Reckoned numbers = found->second();
      ASSERT_EQ(numbers.size(), question.answers.size());
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        const ggrade::authoring::Answer& answer = question.answers[i];
        // Rounded as it is written, it lies well within what is taken for it.
        EXPECT_NEAR(numbers[i], answer.value, std::max(0.35 * answer.tolerance, 1e-9)) << i;
      }
    }
  EXPECT_EQ(asked, kReckoned.size()) << "one is reckoned that nobody asks";
}

} // namespace
