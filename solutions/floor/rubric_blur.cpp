// The rubric of part "mirror", its blur: how the light that the floor adds is spread.

#include "rubric/measures.hpp"
#include "rubric_passes.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cmath>
#include <map>

using namespace floor_rubric;
using namespace ggrade::rubric;

namespace {

/// The floor's pixels, one pixel away from the objects before it.
Mask floorOf(const SceneEvidence& scene, std::size_t frame) {
  return shown(scene.probes.at("floor").at(frame)) &
         ~dilate(shown(scene.probes.at("objects").at(frame)), 1);
}

/// Sums over `2 reach + 1` values along one line of `length` values that lie `step` apart.
void boxSums(const float* from, float* to, int length, std::size_t step, int reach) {
  double sum = 0;
  const auto at = [&](int i) { return double(from[std::size_t(i) * step]); };
  for (int i = 0; i < std::min(reach, length); ++i) sum += at(i);
  for (int i = 0; i < length; ++i) {
    if (i + reach < length) sum += at(i + reach);
    if (i > reach) sum -= at(i - reach - 1);
    to[std::size_t(i) * step] = float(sum);
  }
}

/// Mean over a square of 7 x 7 pixels of what was added to the floor: noise goes, blur stays.
Image smoothed(const Image& image, const Image& plain, const Mask& floor) {
  constexpr int kReach = 3;
  const int width = image.width(), height = image.height();
  // Three channels of added light, and how many pixels of floor there are.
  Image sums(width, height, 4), rows(width, height, 4);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!floor.at(x, y)) continue;
      for (int c = 0; c < 3; ++c) sums.at(x, y, c) = image.at(x, y, c) - plain.at(x, y, c);
      sums.at(x, y, 3) = 1;
    }
  }
  for (int y = 0; y < height; ++y)
    for (int c = 0; c < 4; ++c) boxSums(&sums.at(0, y, c), &rows.at(0, y, c), width, 4, kReach);
  for (int x = 0; x < width; ++x)
    for (int c = 0; c < 4; ++c)
      boxSums(&rows.at(x, 0, c), &sums.at(x, 0, c), height, std::size_t(width) * 4, kReach);
  Image out(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (floor.at(x, y))
        for (int c = 0; c < 3; ++c) out.at(x, y, c) = sums.at(x, y, c) / sums.at(x, y, 3);
  return out;
}

double rms(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.values().size(); ++i) {
    const double d = double(a.values()[i]) - double(b.values()[i]);
    sum += d * d;
  }
  return std::sqrt(sum / double(a.values().size()));
}

/// What the floor should add to its own light when it blurs, and how far off a sharp reflection is.
struct Blur {
  Image wanted;
  double sharp = 0; // RMS
};

const Blur& blurOf(const SceneEvidence& scene, std::size_t frame) {
  static std::map<std::pair<const SceneEvidence*, std::size_t>, Blur> known;
  const auto [entry, fresh] = known.try_emplace({&scene, frame});
  Blur& blur = entry->second;
  if (fresh) {
    const Image& plain = scene.probes.at("plain").at(frame);
    const Mask floor = floorOf(scene, frame);
    blur.wanted = smoothed(scene.reference.at(frame), plain, floor);
    blur.sharp = rms(smoothed(scene.probes.at("sharp").at(frame), plain, floor), blur.wanted);
  }
  return blur;
}

GGRADE_ITEM("mirror.blur", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) -> Verdict {
    const Blur& blur = blurOf(view.scene, i);
    const double found = rms(
        smoothed(view.frames.at(i), view.scene.probes.at("plain").at(i), floorOf(view.scene, i)),
        blur.wanted);
    const double quality = std::clamp((1 - found / blur.sharp) / 0.8, 0.0, 1.0);
    return {quality,
            gg::say("the blurred reflection is off by {:.4f} (RMS); a sharp one is by {:.4f}",
                    found, blur.sharp)};
  });
});

} // namespace
