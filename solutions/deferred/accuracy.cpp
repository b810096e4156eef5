// Both parts against forward shading in double precision, and against light from all sides.

#include "truth_light.hpp"

#include "drawn.hpp"
#include "irradiance.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <iostream>
#include <numbers>

using namespace ggrade;
using namespace deferred_truth;
using testing::AllOf;
using testing::Ge;
using testing::Le;

namespace {

constexpr double kStep = 1.0 / 255;

json sceneOf(const std::string& part, const json& patch) {
  json all = {{"size", {320, 240}}};
  all.merge_patch(patch);
  return extremes::sceneOf("deferred", {part}, all);
}

/// Differences in the pixels that stand for one smooth piece of a surface.
struct Off {
  double window = 0; ///< largest, 0 to 1
  double floats = 0; ///< largest in the textures, as a share of the light or of 1 if that is more
  std::size_t pixels = 0;
};

void report(const char* name, const Off& off) {
  std::cout << name << ": " << off.pixels << " pixels, window off by at most " << off.window / kStep
            << " of 255, textures by " << off.floats << "\n";
  testing::Test::RecordProperty(std::string(name) + ": window", std::to_string(off.window));
  testing::Test::RecordProperty(std::string(name) + ": textures", std::to_string(off.floats));
}

double share(double found, double wanted) {
  return std::abs(found - wanted) / std::max(wanted, 1.0);
}

/// Part "targets" against forward shading.
Off targetsOff(const json& patch, double time = 7) {
  const json scene = sceneOf("targets", patch);
  const extremes::Drawn drawn = extremes::draw("deferred", scene, {time});
  const Image& window = drawn.frames.at(0);
  const World world(scene, time, window.width(), window.height());
  const std::vector<truth::Surface> surfaces = look(world);
  const std::vector<Kinds> kinds = shade(world, surfaces, scene);
  const std::vector<dvec3> light =
      compose(world, kinds, scene.at("effects").at("edges").get<bool>());
  const std::vector<bool> counts = smooth(world, surfaces);
  const std::uint32_t pass = drawn.writerOf("uDiffuse");
  std::array<Image, 3> stored;
  for (std::uint32_t i = 0; i < 3; ++i) stored[i] = drawn.trace.image(*drawn.trace.copyOf(pass, i));
  Off off;
  for (std::size_t i = 0; i < light.size(); ++i) {
    if (!counts[i]) continue;
    ++off.pixels;
    const int x = int(i) % world.width, y = int(i) / world.width;
    for (int c = 0; c < 3; ++c) {
      off.window =
          std::max(off.window, std::abs(double(window.at(x, y, c)) - truth::cut(light[i])[c]));
      const double kindsOff[] = {share(double(stored[0].at(x, y, c)), kinds[i].diffuse[c]),
                                 share(double(stored[1].at(x, y, c)), kinds[i].specular[c]),
                                 share(double(stored[2].at(x, y, c)), kinds[i].ambient[c])};
      for (const double one : kindsOff) off.floats = std::max(off.floats, one);
    }
  }
  return off;
}

const json kElsewhere = {{"camera", {{"position", {2.6, 1.1, 3.9}}, {"fov", 0.8}}},
                         {"light", {{"position", {-3, 4, 2}}}}};

json with(json patch, const json& more) {
  patch.merge_patch(more);
  return patch;
}

/// One test a format: 0 to 2.
class Targets : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(DeferredAccuracy, Targets, testing::Values(0, 1, 2));

TEST_P(Targets, ComposeWhatForwardShadingGives) {
  const int format = GetParam();
  const json patch = {{"quality", {{"format", format}}}};
  constexpr const char* kFormats[] = {"RGBA8", "RGBA16F", "RGBA32F"};
  std::cout << kFormats[format] << "\n";
  for (const json& view : {json::object(), kElsewhere}) {
    const Off plain = targetsOff(with(with(patch, view), {{"effects", {{"edges", false}}}}));
    report("without edges", plain);
    EXPECT_GT(plain.pixels, 60000u);
    EXPECT_LE(plain.window, (format == 0 ? 2 : 1) * kStep); // three kinds are rounded, and the sum
    constexpr double kStored[] = {0.51 / 255, 6e-4, 3e-5};
    EXPECT_LE(plain.floats, kStored[format]);
    // Five times one rounding, and four others.
    const Off edges = targetsOff(with(patch, view));
    report("edges emphasised", edges);
    EXPECT_LE(edges.window, (format == 0 ? 6 : 1) * kStep);
  }
}

// What is measured isn't there by itself.
TEST(DeferredAccuracy, TellsAnotherLight) {
  const json scene = sceneOf("targets", json::object());
  const extremes::Drawn drawn = extremes::draw("deferred", scene, {7});
  json other = scene;
  other["light"]["position"] = {3, 5, 4.2};
  const auto error = [&](const json& wanted) {
    return truth::judgeOf("targets")({wanted, 7, drawn.frames.at(0), &drawn.trace})
        .errors.at(1)
        .value;
  };
  EXPECT_LE(error(scene), kStep);
  EXPECT_GT(error(other), 3 * kStep);
}

/// A map of all directions, linear between texels, around and across the poles.
dvec3 lookUp(const EnvironmentMap& map, const dvec3& direction) {
  const glm::dvec2 uv = uvOf(direction);
  const double x = uv.x * map.width - 0.5, y = uv.y * map.height - 0.5;
  const auto texel = [&](int column, int row) {
    if (row < 0 || row >= map.height) // beyond a pole, on the other side
      row = row < 0 ? 0 : map.height - 1, column += map.width / 2;
    column = (column + 2 * map.width) % map.width;
    return dvec3(map.texels[std::size_t(row) * std::size_t(map.width) + std::size_t(column)]);
  };
  const int column = int(std::floor(x)), row = int(std::floor(y));
  const double right = x - column, down = y - row;
  return (1 - down) * ((1 - right) * texel(column, row) + right * texel(column + 1, row)) +
         down * ((1 - right) * texel(column, row + 1) + right * texel(column + 1, row + 1));
}

/// Part "figure" without occlusion against forward shading by the same two maps.
Off figureOff(const json& patch, double time = 7) {
  const json scene = sceneOf(
      "figure", with({{"quality", {{"ao_samples", 0}}}, {"sun", {{"brightness", 0}}}}, patch));
  const extremes::Drawn drawn = extremes::draw("deferred", scene, {time});
  const Image& window = drawn.frames.at(0);
  const World world(scene, time, window.width(), window.height());
  const std::vector<truth::Surface> surfaces = look(world);
  const std::vector<bool> counts = smooth(world, surfaces);
  const Sky sky = skyOf(scene);
  const EnvironmentMap environment = environmentMap(sky, 1024),
                       irradiance = irradianceMap(sky, 4, 64);
  const Image composition = drawn.leftBy(drawn.writerOf("uComposition"));
  Off off;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!counts[i]) continue;
    ++off.pixels;
    const int x = int(i) % world.width, y = int(i) / world.width;
    const dvec3 view = glm::normalize(world.camera.through(x, y)), &normal = surfaces[i].normal;
    dvec3 light = surfaces[i].id < 0 ? lookUp(environment, view) : dvec3(0);
    if (surfaces[i].id >= 0) {
      const Paint& paint = world.paint(surfaces[i]);
      const dvec3 mirrored = fresnel(paint.straight, -glm::dot(normal, view));
      light = (1.0 - mirrored) * paint.albedo / std::numbers::pi * lookUp(irradiance, normal) +
              mirrored * lookUp(environment, glm::reflect(view, normal));
    }
    for (int c = 0; c < 3; ++c) {
      off.window = std::max(off.window, std::abs(double(window.at(x, y, c)) - display(light)[c]));
      off.floats = std::max(off.floats, share(double(composition.at(x, y, c)), light[c]));
    }
  }
  return off;
}

TEST(DeferredAccuracy, TheFigureComposesWhatForwardShadingGives) {
  for (const json& view : {json::object(), kElsewhere}) {
    const Off floats = figureOff(with({{"quality", {{"format", 2}, {"normal", 0}}}}, view));
    report("32 bits", floats);
    EXPECT_GT(floats.pixels, 60000u);
    EXPECT_LE(floats.window, kStep);
    const Off usual = figureOff(view);
    report("the default", usual);
    EXPECT_LE(usual.window, 3 * kStep);
    const Off bytes = figureOff(with({{"quality", {{"normal", 3}}}}, view));
    report("normals in 2 bytes", bytes);
    EXPECT_GT(bytes.floats, 3 * usual.floats);
  }
}

/// Of the figure against the truth that sums up light over directions.
truth::Judgement ask(const json& patch, bool visibility, double time = 7) {
  const json scene = sceneOf("figure", patch);
  const extremes::Drawn drawn = extremes::draw("deferred", scene, {time});
  const truth::Judgement answer = truth::judgeOf("figure")(
      {scene, time, drawn.frames.at(0), &drawn.trace, {{"visibility", visibility}}});
  std::cout << patch.dump() << (visibility ? ", what is hidden is dark" : "") << ": mean error "
            << answer.errors.at(0).value / kStep << " of 255\n";
  return answer;
}

TEST(DeferredAccuracy, TheOpenSkysLightIsRight) {
  const json open = {{"quality", {{"ao_samples", 0}}}};
  for (const int method : {0, 1, 2})
    EXPECT_LE(ask(with(open, {{"quality", {{"irradiance", method}}}}), false).errors.at(0).value,
              0.3 * kStep)
        << method;
  EXPECT_GT(ask(with(open, {{"quality", {{"irradiance_height", 2}}}}), false).errors.at(0).value,
            2 * kStep);
}

TEST(DeferredAccuracy, OcclusionComesNearerToWhatIsHidden) {
  const json overcast = {{"size", {160, 120}}, {"sun", {{"brightness", 0}}}};
  const auto error = [&](int samples) {
    return ask(with(overcast, {{"quality", {{"ao_samples", samples}}}}), true).errors.at(0).value;
  };
  const double none = error(0), usual = error(16);
  EXPECT_LT(usual, 0.8 * none);
  EXPECT_GT(none, 2 * kStep);
}

} // namespace
