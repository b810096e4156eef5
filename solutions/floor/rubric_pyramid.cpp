#include "rubric_pyramid.hpp"

#include "rubric/measures.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cmath>

namespace floor_rubric {

namespace {

/// A copy of what a full-screen pass drew into a texture.
struct ScreenPass {
  int width, height;
  std::uint32_t texture, level, format;
  const trace::CopyRecord* copy;
  rubric::PassOutput output() const { return {copy->pass, copy->attachment}; }
};

std::vector<ScreenPass> screenPasses(const trace::Trace& trace) {
  std::vector<ScreenPass> all;
  if (trace.frames.empty()) return all;
  for (const trace::PassRecord& pass : trace.passesOf(0)) {
    if (pass.draws == 0 || trace.drewObjects(pass)) continue;
    for (std::uint32_t a = 0; a < trace::kColors; ++a) {
      if (pass.images[a].kind != std::uint32_t(trace::ImageKind::texture)) continue;
      if (const trace::CopyRecord* copy = trace.copyOf(trace.indexOf(pass), a))
        all.push_back({int(copy->width), int(copy->height), pass.images[a].name,
                       pass.images[a].level, pass.images[a].format, copy});
    }
  }
  return all;
}

void findScene(const trace::Trace& trace, Pyramid& pyramid) {
  for (const Drawn& drawn : sampledLater(trace)) {
    if (drawn.attachment >= trace::kColors || !drawn.ofObjects) continue;
    pyramid.scene = firstChannels(trace.image(*drawn.copy), 3);
    pyramid.sceneFormat = drawn.format; // the last one: a reflection is drawn before the scene
    pyramid.sceneOutput = {drawn.copy->pass, drawn.attachment};
  }
}

/// Integral of the tent max(1 - |x|, 0) from minus infinity to x.
double tentArea(double x) {
  x = std::clamp(x, -1.0, 1.0);
  return x < 0 ? 0.5 * (1 + x) * (1 + x) : 1 - 0.5 * (1 - x) * (1 - x);
}

struct Tap {
  int at;
  double weight;
};

/// Weights of the source texels (mirrored at the edges) for each target pixel along one axis.
std::vector<std::vector<Tap>> taps(int from, int to) {
  std::vector<std::vector<Tap>> all(static_cast<std::size_t>(to));
  const double ratio = double(from) / to;
  for (int i = 0; i < to; ++i) {
    const double low = i * ratio, high = (i + 1) * ratio, centre = (i + 0.5) * ratio;
    const double reach = from >= to ? ratio : high - centre + 1;
    for (int j = int(std::floor(centre - reach)); j < std::ceil(centre + reach); ++j) {
      const double weight =
          from >= to ? tentArea((j + 1 - centre) / ratio) - tentArea((j - centre) / ratio)
                     : (tentArea(high - j - 0.5) - tentArea(low - j - 0.5)) / ratio;
      int at = j < 0 ? -1 - j : j;
      at = at >= from ? 2 * from - 1 - at : at;
      if (weight > 0) all[std::size_t(i)].push_back({std::clamp(at, 0, from - 1), weight});
    }
  }
  return all;
}

double percentile(std::vector<double>& values, double share) {
  const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

} // namespace

Image byTent(const Image& image, int width, int height) {
  const auto across = taps(image.width(), width), down = taps(image.height(), height);
  const int channels = image.channels();
  Image rows(width, image.height(), channels), out(width, height, channels);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c) {
        double sum = 0;
        for (const Tap& tap : across[std::size_t(x)])
          sum += tap.weight * double(image.at(tap.at, y, c));
        rows.at(x, y, c) = float(sum);
      }
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c) {
        double sum = 0;
        for (const Tap& tap : down[std::size_t(y)])
          sum += tap.weight * double(rows.at(x, tap.at, c));
        out.at(x, y, c) = float(sum);
      }
  return out;
}

Pyramid ownPyramid(const trace::Trace& trace) {
  Pyramid pyramid;
  findScene(trace, pyramid);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> known; // texture and level
  for (const ScreenPass& pass : screenPasses(trace)) {
    const auto key = std::pair(pass.texture, pass.level);
    const auto found = std::find(known.begin(), known.end(), key);
    const Image image = firstChannels(trace.image(*pass.copy), 3);
    if (found == known.end()) {
      known.push_back(key);
      pyramid.levels.push_back(
          {pass.width, pass.height, pass.format, image, image, false, pass.output()});
    } else {
      Level& level = pyramid.levels[std::size_t(found - known.begin())];
      level.up = image;
      level.summed = true;
    }
  }
  return pyramid;
}

Pyramid pyramidLike(const Pyramid& reference, const trace::Trace& trace) {
  Pyramid pyramid;
  findScene(trace, pyramid);
  const std::vector<ScreenPass> passes = screenPasses(trace);
  for (const Level& wanted : reference.levels) {
    Level level{wanted.width, wanted.height, 0, {}, {}, false, {}};
    for (const ScreenPass& pass : passes) {
      if (std::abs(pass.width - wanted.width) > 1 || std::abs(pass.height - wanted.height) > 1)
        continue;
      const Image image = firstChannels(trace.image(*pass.copy), 3);
      if (level.down.empty()) {
        level.down = image;
        level.format = pass.format;
        level.output = pass.output();
      } else {
        level.summed = true;
      }
      level.up = image;
    }
    pyramid.levels.push_back(std::move(level));
  }
  return pyramid;
}

LightComparison compareLight(const Image& found, const Image& wanted, double gain) {
  LightComparison result;
  if (found.empty()) {
    result.text = gg::say("nothing was drawn at its size");
    return result;
  }
  if (const auto bad = findNonFinite(found)) {
    result.text = bad->text(found.channels());
    return result;
  }
  Image changed;
  if (!sameSize(found, wanted)) changed = resampled(found, wanted.width(), wanted.height(), 3);
  if (gain != 1) {
    if (changed.empty()) changed = found;
    for (float& value : changed.values()) value = float(double(value) / gain);
  }
  const Image& image = changed.empty() ? found : changed;
  float most = 1e-20f;
  for (const float value : wanted.values()) most = std::max(most, value);
  // Light of any strength on a scale from 0 to 1: differences count in proportion where it is
  // bright, absolutely where it is dark.
  const auto compressed = [&](const Image& from) {
    Image to = from;
    for (float& value : to.values()) value /= std::abs(value) + 0.25f * most;
    return to;
  };
  CompareOptions options;
  options.tolerance = 0.012f; // 7% where it is brightest
  const Comparison comparison = compare(compressed(image), compressed(wanted), options);
  // Of the light, not of the dark around it.
  std::vector<double> ratios;
  std::size_t lit = 1;
  ratios.reserve(wanted.pixelCount());
  const float *p = image.values().data(), *q = wanted.values().data();
  for (std::size_t i = 0; i < wanted.pixelCount();
       ++i, p += image.channels(), q += wanted.channels()) {
    const double a = double(p[0]) + double(p[1]) + double(p[2]);
    const double b = double(q[0]) + double(q[1]) + double(q[2]);
    if (b > 0.02 * double(most)) {
      ++lit;
      ratios.push_back(a / b);
    }
  }
  result.wrongShare = std::min(1.0, double(comparison.wrongPixels) / double(lit));
  if (!ratios.empty()) {
    result.ratio = percentile(ratios, 0.5);
    const double low = percentile(ratios, 0.1), high = percentile(ratios, 0.9);
    result.uniform = result.ratio > 0 && high < 1.2 * low;
  }
  if (result.wrongShare < kOtherWays)
    result.text = gg::say("matches");
  else if (result.ratio == 0)
    result.text = gg::say("black where there must be light");
  else if (result.uniform && result.ratio > 1.05)
    result.text = gg::say("{:.1f}x too bright everywhere", result.ratio);
  else if (result.uniform && result.ratio < 0.95)
    result.text = gg::say("{:.1f}x too dark everywhere", 1 / result.ratio);
  else
    result.text = gg::say("{:.0f}% as many pixels as have light differ{}", 100 * result.wrongShare,
                          densestAt(comparison.densest));
  return result;
}

} // namespace floor_rubric
