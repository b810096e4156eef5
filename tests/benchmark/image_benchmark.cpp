// Milliseconds a megapixel of every comparison and how they grow with the size, and the time to
// score a frame with its passes. One thread; look at the CPU column. Times a megapixel: 1000 over
// "MP/s".

#include "rubric/measures.hpp"
#include "rubric_passes.hpp"
#include "rubric_pyramid.hpp"

#include "image/compare.hpp"
#include "image/difference.hpp"
#include "image/flip.hpp"
#include "image/statistics.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

using namespace ggrade;

namespace {

/// A smooth picture with objects, shifted by `shift` pixels: what a scene is to a comparison.
Image picture(int width, int height, int channels, int shift, float brightest = 1) {
  Image image(width, height, channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float u = float(x + shift) / float(width), v = float(y) / float(height);
      const bool object =
          std::hypot(std::fmod(6 * u, 1.0f) - 0.5f, std::fmod(5 * v, 1.0f) - 0.5f) < 0.3f;
      for (int c = 0; c < channels; ++c) {
        const float value = object ? 0.5f + 0.4f * std::sin(9 * v + float(c)) : 0.3f + 0.2f * u;
        image.at(x, y, c) = brightest * std::round(255 * value) / 255;
      }
    }
  return image;
}

/// The worst case of everything: every pixel differs.
Image noise(int side, int channels, unsigned seed) {
  std::mt19937 random(seed);
  Image image(side, side, channels);
  for (float& value : image.values()) value = float(random() % 256) / 255;
  return image;
}

void perPixel(benchmark::State& state, std::size_t pixels) {
  state.counters["MP/s"] = benchmark::Counter(double(pixels) * 1e-6 * double(state.iterations()),
                                              benchmark::Counter::kIsRate);
}

/// `metric(student, reference)` on shifted pictures (0) or noise (1) of a side.
template <class Metric> void metricOf(benchmark::State& state, Metric metric) {
  const int side = int(state.range(0));
  const bool worst = state.range(1) != 0;
  const Image student = worst ? noise(side, 3, 1) : picture(side, side, 3, 1);
  const Image reference = worst ? noise(side, 3, 2) : picture(side, side, 3, 0);
  for (auto _ : state) benchmark::DoNotOptimize(metric(student, reference));
  perPixel(state, reference.pixelCount());
}

void compareImages(benchmark::State& state) {
  metricOf(state, [](const Image& a, const Image& b) { return compare(a, b).wrongShare; });
}
void ldrFlipOfImages(benchmark::State& state) {
  metricOf(state, [](const Image& a, const Image& b) { return ldrFlip(a, b).mean; });
}
void hdrFlipOfImages(benchmark::State& state) {
  metricOf(state, [](const Image& a, const Image& b) { return hdrFlip(a, b).mean; });
}
void ssimOfImages(benchmark::State& state) {
  metricOf(state, [](const Image& a, const Image& b) { return ssim(a, b); });
}

#define GGRADE_SIZES                                                                               \
  ArgNames({"side", "noise"})                                                                      \
      ->ArgsProduct({{256, 512, 1024, 2048}, {0, 1}})                                              \
      ->Unit(benchmark::kMillisecond)
BENCHMARK(compareImages)->GGRADE_SIZES;
BENCHMARK(ldrFlipOfImages)->GGRADE_SIZES;
BENCHMARK(hdrFlipOfImages)->GGRADE_SIZES;
BENCHMARK(ssimOfImages)->GGRADE_SIZES;

constexpr int kWidth = 640, kHeight = 480, kMap = 1024;

std::vector<std::uint8_t> bytesOf(const Image& image) {
  std::vector<std::uint8_t> bytes;
  for (const float value : image.values()) bytes.push_back(std::uint8_t(std::lround(255 * value)));
  return bytes;
}

/// A frame and the pictures of its passes: a texture of 1024^2 RGBA8, a depth map of 1024^2 and two
/// textures of half floats of the window's size, already in memory as bytes and floats.
struct Evidence {
  explicit Evidence(int shift)
      : frame{0, kWidth, kHeight, bytesOf(picture(kWidth, kHeight, 4, shift))},
        texture(bytesOf(picture(kMap, kMap, 4, shift))),
        depth(picture(kMap, kMap, 1, shift)), light{picture(kWidth, kHeight, 4, shift, 9),
                                                    picture(kWidth, kHeight, 4, shift, 5)} {}

  rubric::RawFrame frame;
  std::vector<std::uint8_t> texture;
  Image depth, light[2];
};

/// As the rubrics do it: the frame in two regions, the texture at the window's size, the map in its
/// own, both lights.
double scoreFrame(const Evidence& student, const Evidence& wanted) {
  using namespace floor_rubric;
  using namespace ggrade::rubric;
  const Image frame = rubric::toImage(student.frame), reference = rubric::toImage(wanted.frame);
  const Image black(kWidth, kHeight, 3);
  const Mask objects = differenceMask(reference, black, 0.5f);
  double sum = 0;
  for (const Mask& region : {erode(objects, 1), ~dilate(objects, 2)}) {
    CompareOptions options;
    options.mask = &region;
    sum += compare(frame, reference, options).wrongShare;
  }
  const auto texture = [](const std::vector<std::uint8_t>& bytes) {
    return resampled(Image::fromBytes(bytes, kMap, kMap), kWidth, kHeight, 3);
  };
  const Image a = texture(student.texture), b = texture(wanted.texture);
  const Mask region = dilate(
      differenceMask(b, black, 2 * kTolerance) | differenceMask(a, black, 2 * kTolerance), 1);
  CompareOptions options;
  options.mask = &region;
  sum += compare(a, b, options).wrongShare;
  sum += compare(student.depth, wanted.depth).wrongShare;
  for (int i = 0; i < 2; ++i)
    sum += compareLight(firstChannels(student.light[i], 3), firstChannels(wanted.light[i], 3), 1)
               .wrongShare;
  return sum;
}

void frameWithFourPasses(benchmark::State& state) {
  const Evidence student(int(state.range(0))), wanted(0);
  for (auto _ : state) benchmark::DoNotOptimize(scoreFrame(student, wanted));
}
BENCHMARK(frameWithFourPasses)->ArgName("shift")->Arg(0)->Arg(3)->Unit(benchmark::kMillisecond);

void maskOperations(benchmark::State& state) {
  const Image a = picture(kWidth, kHeight, 3, 0), black(kWidth, kHeight, 3);
  const Mask mask = differenceMask(a, black, 0.5f);
  for (auto _ : state) {
    benchmark::DoNotOptimize(differenceMask(a, black, 0.5f));
    benchmark::DoNotOptimize(dilate(mask, 2) & ~erode(mask, 1));
    benchmark::DoNotOptimize(densestWindow(mask));
  }
  perPixel(state, a.pixelCount());
}
BENCHMARK(maskOperations)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
