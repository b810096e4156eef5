// Mirror, shadow and bloom on one scene: each alone is what its part draws, together they are the
// composition of their passes, and passes that a scene can't show are not made.

#include "tool.hpp"

#include "../../solutions/floor/rubric_pyramid.hpp"
#include "grading/overlay.hpp"
#include "grading/program.hpp"
#include "grading/scenes.hpp"
#include "image/mask.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

using namespace tool;
using namespace ggrade;
using nlohmann::json;

namespace {

const Assignment& assignment() {
  static const Assignment loaded = Assignment::load(kSource / "assignments/floor");
  return loaded;
}

/// A built program, kept for all tests of a process.
class Built {
public:
  explicit Built(const fs::path& sources) {
    grading::overlay(assignment(), sources, folder_.path());
    fs::create_directory(shaders_);
    const grading::Happened built =
        grading::buildProgram("floor", folder_.path(), sandbox::Isolation::none);
    if (!built.ok()) throw std::runtime_error(built.output);
  }
  channel::Capture render(const json& scene, const trace::Request& request = {}) const {
    grading::Rendering rendering = grading::renderScene(
        "floor", folder_.path(), scene, {0.4, 1.3}, {shaders_}, sandbox::Isolation::none, request);
    EXPECT_EQ(rendering.happened.outcome, results::Outcome::graded) << rendering.happened.detail;
    return std::move(rendering.capture);
  }

private:
  TemporaryFolder folder_;
  fs::path shaders_ = folder_.path() / "shaders"; ///< compiled once
};

const Built& solution() {
  static const Built built(kSource / "solutions/floor");
  return built;
}

/// The assignment's scene with all parts' settings, some effects on, and more.
json scene(bool mirror, bool shadow, bool bloom, const json& more = json::object()) {
  json all = readJson(kSource / "assignments/floor/scene.json");
  for (const Part& part : assignment().parts) all.merge_patch(part.scene);
  all["effects"] = {{"mirror", mirror}, {"shadow", shadow}, {"bloom", bloom}};
  all.merge_patch(more);
  return all;
}

trace::Request everything() {
  trace::Request request{};
  request.passes = 1;
  request.copies = 1u | 1u << trace::kDepth;
  request.windowCopies = request.copies;
  request.copyFrames = 1;
  request.copyBytes = std::uint64_t{512} << 20;
  return request;
}

Image window(const channel::Capture& capture, std::size_t frame = 0) {
  const channel::CapturedFrame& one = capture.frames.at(frame);
  return firstChannels(Image::fromBytes(one.pixels, int(one.width), int(one.height)), 3);
}

/// The texture that a pass drew objects into in colour: 0 the first, that is the reflection.
Image drawnTexture(const channel::Capture& capture, bool last) {
  Image found;
  for (const floor_rubric::Drawn& drawn : floor_rubric::sampledLater(capture.trace)) {
    if (drawn.attachment != 0 || !drawn.ofObjects) continue;
    if (last || found.empty()) found = firstChannels(capture.trace.image(*drawn.copy), 3);
  }
  EXPECT_FALSE(found.empty());
  return found;
}

/// The pixels where the floor is seen.
Mask floorMask() {
  const json black = {
      {"background", {0, 0, 0}},
      {"ring", {{"glow", 0}}},
      {"light", {{"ambient", {1, 1, 1}}, {"diffuse", {0, 0, 0}}, {"specular", {0, 0, 0}}}},
      {"materials", {{"object", {{"ambient", {0, 0, 0}}}}, {"floor", {{"ambient", {1, 1, 1}}}}}}};
  const Image image = window(solution().render(scene(false, false, false, black)));
  return differenceMask(image, Image(image.width(), image.height(), 3), 0.1f);
}

/// `base` with the reflection, weighted with the floor's specular colour, where the floor is.
Image reflected(const Image& base, const Image& reflection) {
  const json from = scene(true, true, true);
  const auto specular = from.at("materials").at("floor").at("specular").get<std::array<float, 3>>();
  const Image sampled = floor_rubric::resampled(reflection, base.width(), base.height(), 3);
  const Mask floor = floorMask();
  Image out = base;
  for (int y = 0; y < out.height(); ++y)
    for (int x = 0; x < out.width(); ++x)
      for (int c = 0; c < 3; ++c)
        if (floor.at(x, y)) out.at(x, y, c) += specular[std::size_t(c)] * sampled.at(x, y, c);
  return out;
}

/// What the composite pass must make of the recorded scene and the sum of the levels.
Image composed(const channel::Capture& capture) {
  Image light = drawnTexture(capture, true);
  const floor_rubric::Pyramid pyramid = floor_rubric::ownPyramid(capture.trace);
  EXPECT_EQ(pyramid.levels.size(), 6u);
  const Image bloom = floor_rubric::byTent(pyramid.levels.at(0).up, light.width(), light.height());
  for (std::size_t i = 0; i < light.values().size(); ++i) {
    const double sum = std::clamp(double(light.values()[i]) + double(bloom.values()[i]), 0.0, 1.0);
    light.values()[i] =
        float(sum <= 0.0031308 ? 12.92 * sum : 1.055 * std::pow(sum, 1 / 2.4) - 0.055);
  }
  return light;
}

void clampToOne(Image& image) {
  for (float& value : image.values()) value = std::clamp(value, 0.0f, 1.0f);
}

/// The greatest difference of two pictures, and where.
void expectWithin(const Image& a, const Image& b, double tolerance) {
  ASSERT_TRUE(sameSize(a, b));
  double worst = 0;
  std::string where;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      for (int c = 0; c < 3; ++c) {
        const double difference = std::abs(double(a.at(x, y, c)) - double(b.at(x, y, c)));
        if (difference > worst)
          worst = difference, where = fmt::format("({},{}) channel {}: {} and {}", x, y, c,
                                                  a.at(x, y, c), b.at(x, y, c));
      }
  EXPECT_LE(worst, tolerance) << where;
}

class OneEffect : public testing::TestWithParam<std::pair<const char*, int>> {};

TEST_P(OneEffect, IsBitIdenticalToThePartAlone) {
  const auto& [part, todos] = GetParam();
  const Built alone(Submission::firstSteps(todos, part).path());
  const json settings = scene(part == std::string("mirror"), part == std::string("shadow"),
                              part == std::string("bloom"));
  const channel::Capture a = solution().render(settings), b = alone.render(settings);
  ASSERT_EQ(a.frames.size(), 2u);
  ASSERT_EQ(b.frames.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_TRUE(a.frames[i].pixels == b.frames[i].pixels) << i;
}

INSTANTIATE_TEST_SUITE_P(Together, OneEffect,
                         testing::Values(std::pair("mirror", 7), std::pair("shadow", 6),
                                         std::pair("bloom", 7)),
                         [](const auto& info) { return std::string(info.param.first); });

constexpr double kStep = 1.0 / 255 + 1e-6;

TEST(Together, MirrorAndShadowAreTheShadowedSceneAndItsReflection) {
  const channel::Capture both = solution().render(scene(true, true, false), everything());
  const Image shadowed = window(solution().render(scene(false, true, false)));
  Image expected = reflected(shadowed, drawnTexture(both, false));
  clampToOne(expected);
  expectWithin(window(both), expected, kStep);
  // The reflection itself is shadowed: it isn't the one of the mirror alone.
  const channel::Capture mirror = solution().render(scene(true, false, false), everything());
  EXPECT_GT(differenceMask(drawnTexture(both, false), drawnTexture(mirror, false), 0.05f).count(),
            500u);
}

TEST(Together, ShadowAndBloomAreTheShadowedSceneAndItsLight) {
  const channel::Capture both = solution().render(scene(false, true, true), everything());
  expectWithin(window(both), composed(both), kStep);
  Image light = drawnTexture(both, true);
  clampToOne(light);
  expectWithin(light, window(solution().render(scene(false, true, false))), kStep);
}

TEST(Together, MirrorAndBloomAreTheReflectingSceneAndItsLight) {
  const channel::Capture both = solution().render(scene(true, false, true), everything());
  expectWithin(window(both), composed(both), kStep);
  const channel::Capture bloom = solution().render(scene(false, false, true), everything());
  // Half floats: 11 bits of values up to 4.
  expectWithin(drawnTexture(both, true),
               reflected(drawnTexture(bloom, true), drawnTexture(both, false)), kStep);
}

TEST(Together, AllThreeAreTheCompositionOfTheirPasses) {
  const channel::Capture all = solution().render(scene(true, true, true), everything());
  expectWithin(window(all), composed(all), kStep);
  const channel::Capture shadowed = solution().render(scene(false, true, true), everything());
  expectWithin(drawnTexture(all, true),
               reflected(drawnTexture(shadowed, true), drawnTexture(all, false)), kStep);
}

/// Sums of the three channels over all pixels.
double energy(const Image& image) {
  double sum = 0;
  for (const float value : image.values()) sum += double(value);
  return sum;
}

class BloomSize : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(BloomSize, IsTheFilterInDoublePrecisionAndKeepsItsEnergy) {
  // Floats, so that only the filter is measured. The bright pass has the greatest share of light
  // where the threshold is low.
  const auto [width, height] = GetParam();
  const json tiny = {{"size", {width, height}},
                     {"bloom", {{"threshold", 0.1}}},
                     {"quality", {{"bloom_format", 3}}}};
  const channel::Capture capture = solution().render(scene(false, false, true, tiny), everything());
  const floor_rubric::Pyramid pyramid = floor_rubric::ownPyramid(capture.trace);
  ASSERT_EQ(pyramid.levels.size(), 6u);
  int w = width, h = height;
  for (std::size_t k = 0; k < 6; ++k) {
    const floor_rubric::Level& level = pyramid.levels[k];
    w = std::max(w / 2, 1), h = std::max(h / 2, 1);
    EXPECT_EQ(level.width, w) << k;
    EXPECT_EQ(level.height, h) << k;
    ASSERT_FALSE(findNonFinite(level.down)) << k;
    if (k == 0) continue;
    const Image& before = pyramid.levels[k - 1].down;
    const Image expected = floor_rubric::byTent(before, w, h);
    double most = 1e-3;
    for (const float value : expected.values()) most = std::max(most, double(value));
    expectWithin(level.down, expected, 1e-4 * most);
    const double share = double(before.width() * before.height()) / (w * h);
    EXPECT_NEAR(energy(level.down) * share, energy(before), 0.01 * energy(before) + 1e-6) << k;
  }
  expectWithin(window(capture), composed(capture), kStep);
}

INSTANTIATE_TEST_SUITE_P(Together, BloomSize,
                         testing::Values(std::pair(640, 480), std::pair(101, 67), std::pair(45, 37),
                                         std::pair(7, 13), std::pair(1, 90), std::pair(90, 1),
                                         std::pair(3, 3), std::pair(1, 1)));

/// A scene in which some pass has nothing to show.
struct Spared {
  const char* name;
  bool mirror, shadow, bloom;
  json more;
};
void PrintTo(const Spared& spared, std::ostream* out) {
  *out << spared.name;
}

class SparedPasses : public testing::TestWithParam<Spared> {};

TEST_P(SparedPasses, LeaveThePictureAsItIsAndSaveMemory) {
  const Spared& spared = GetParam();
  trace::Request request{};
  request.passes = 1;
  json forced = spared.more;
  forced["debug"] = {{"draw_all_passes", true}};
  const channel::Capture usual =
      solution().render(scene(spared.mirror, spared.shadow, spared.bloom, spared.more), request);
  const channel::Capture all =
      solution().render(scene(spared.mirror, spared.shadow, spared.bloom, forced), request);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_TRUE(usual.frames[i].pixels == all.frames[i].pixels) << "frame " << i;
  const trace::FrameTrace &few = usual.trace.frames.at(0), &many = all.trace.frames.at(0);
  EXPECT_LT(few.passCount, many.passCount);
  EXPECT_LT(few.imageBytes, many.imageBytes);
  fmt::print("{}: {} of {} passes, {:.2f} of {:.2f} MB of textures and renderbuffers\n",
             spared.name, few.passCount, many.passCount, double(few.imageBytes) / 1e6,
             double(many.imageBytes) / 1e6);
}

INSTANTIATE_TEST_SUITE_P(
    Together, SparedPasses,
    testing::Values(Spared{"FloorReflectsNothing", true, false, false,
                           json{{"materials", {{"floor", {{"specular", {0, 0, 0}}}}}}}},
                    Spared{"EyeBelowTheFloor", true, false, false,
                           json{{"camera", {{"position", {0, -1, 7}}}}}},
                    Spared{"FloorOutOfView", true, false, false,
                           json{{"camera", {{"position", {0, 3, 20}}, {"target", {0, 10, 40}}}}}},
                    Spared{"NoObjects", false, true, false, json{{"ring", {{"count", 0}}}}},
                    Spared{"NothingToShade", false, true, false,
                           json{{"light", {{"diffuse", {0, 0, 0}}, {"specular", {0, 0, 0}}}}}},
                    Spared{"NothingGlows", false, false, true,
                           json{{"ring", {{"glow", 0}}}, {"bloom", {{"threshold", 2}}}}},
                    Spared{"NothingOfAll", true, true, true,
                           json{{"ring", {{"glow", 0}, {"count", 0}}},
                                {"bloom", {{"threshold", 2}}},
                                {"materials", {{"floor", {{"specular", {0, 0, 0}}}}}}}}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(Together, TheFloorHasOneHundredPointsOfAllParts) {
  const Graded reference = gradePart("floor", kSource / "solutions/floor", {.solution = true});
  EXPECT_EQ(reference.score(), 100);
  EXPECT_EQ(reference.bonus(), 10);
  const Graded stub = gradePart("floor", kSource / "assignments/floor");
  EXPECT_EQ(stub.results.at("score"), 0);
  // The mirror alone has its share.
  const Graded mirror = gradePart("floor", Submission::firstSteps(7, "mirror"));
  EXPECT_EQ(mirror.score(), 40);
  EXPECT_EQ(mirror.earned("bloom.keep_together"), 0);
}

} // namespace
