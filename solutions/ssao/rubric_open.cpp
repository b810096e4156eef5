#include "rubric_open.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace ssao_rubric {

namespace {

/// Textures that are looked at. A right program has three.
constexpr std::size_t kMostOpenings = 12;
/// Colours or normals of neighbours that differ by more belong to different surfaces.
constexpr float kOther = 12.0f / 255;
constexpr int kEdge = 2;
/// Least share of ambient light that must be kept out for a difference to count as a share of it.
constexpr double kLeastKeptOut = 0.01;

const Image& probe(const SceneEvidence& scene, const char* name, std::size_t frame) {
  return scene.probes.at(name).at(frame);
}

/// Pixels that differ from the next one to the right or below.
Mask steps(const Image& image) {
  Mask mask(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; c < 3; ++c) {
        const float here = image.at(x, y, c);
        if ((x + 1 < image.width() && std::abs(image.at(x + 1, y, c) - here) > kOther) ||
            (y + 1 < image.height() && std::abs(image.at(x, y + 1, c) - here) > kOther))
          mask.set(x, y);
      }
  return mask;
}

} // namespace

const Regions& regionsOf(const SceneEvidence& scene, std::size_t frame) {
  static std::map<std::pair<const SceneEvidence*, std::size_t>, Regions> known;
  auto [entry, fresh] = known.try_emplace({&scene, frame});
  Regions& regions = entry->second;
  if (fresh) {
    const Image& normals = probe(scene, "normals", frame);
    regions.covered = shown(normals);
    regions.edges = dilate(steps(normals) | steps(probe(scene, "unoccluded", frame)), kEdge);
    regions.open = firstChannels(probe(scene, "open", frame), 1);
  }
  return regions;
}

Image openInWindow(const View& view, std::size_t frame) {
  return visibility(view.frames.at(frame),
                    {probe(view.scene, "unlit", frame), probe(view.scene, "unoccluded", frame)});
}

std::vector<Opening> openings(const View& view) {
  std::vector<Opening> all;
  const Image& window = view.scene.reference.at(0);
  for (const Drawn& drawn : sampledLater(view.trace)) {
    if (drawn.attachment >= trace::kColors || drawn.ofObjects) continue;
    if (all.size() == kMostOpenings) break;
    const Image values = view.trace.image(*drawn.copy);
    Opening opening{drawn, Image(window.width(), window.height(), 1)};
    for (int y = 0; y < window.height(); ++y)
      for (int x = 0; x < window.width(); ++x)
        opening.open.at(x, y) =
            values.at(std::min(x * values.width() / window.width(), values.width() - 1),
                      std::min(y * values.height() / window.height(), values.height() - 1), 0);
    if (!findNonFinite(opening.open)) all.push_back(std::move(opening));
  }
  return all;
}

Image smoothed(const Image& image, const Mask& region, int reach) {
  const int width = image.width(), height = image.height();
  // Sums over all that is above and to the left, of values and of numbers of pixels.
  std::vector<double> sums(std::size_t(width + 1) * std::size_t(height + 1));
  std::vector<double> counts(sums.size());
  const auto at = [&](int x, int y) {
    return std::size_t(y) * std::size_t(width + 1) + std::size_t(x);
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool in = region.at(x, y);
      const auto add = [&](std::vector<double>& table, double value) {
        table[at(x + 1, y + 1)] =
            value + table[at(x, y + 1)] + table[at(x + 1, y)] - table[at(x, y)];
      };
      add(sums, in ? double(image.at(x, y)) : 0);
      add(counts, in ? 1 : 0);
    }
  Image out(width, height, 1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int left = std::max(x - reach, 0), right = std::min(x + reach + 1, width);
      const int top = std::max(y - reach, 0), bottom = std::min(y + reach + 1, height);
      const auto total = [&](const std::vector<double>& table) {
        return table[at(right, bottom)] - table[at(left, bottom)] - table[at(right, top)] +
               table[at(left, top)];
      };
      out.at(x, y) = float(total(sums) / std::max(total(counts), 1.0));
    }
  return out;
}

double apart(const Image& found, const Image& wanted, const Mask& region) {
  double difference = 0, keptOut = 0, count = 0;
  for (int y = 0; y < wanted.height(); ++y)
    for (int x = 0; x < wanted.width(); ++x) {
      if (!region.at(x, y)) continue;
      // Where ambient light makes no difference, what was found may be anything.
      difference += std::min(std::abs(double(found.at(x, y)) - double(wanted.at(x, y))), 1.0);
      keptOut += 1 - double(wanted.at(x, y));
      ++count;
    }
  return difference / std::max({keptOut, kLeastKeptOut * count, 1.0});
}

Image shownOpen(const View& view, std::size_t frame) {
  return firstChannels(view.frames.at(frame), 1);
}

} // namespace ssao_rubric
