#include "rubric_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace deferred_rubric {

namespace {

/// Of stored light: more is white in the window, whatever is added.
constexpr float kMostLight = 4;

Image cutOff(const Image& image) {
  Image out = firstChannels(image, 3);
  for (float& value : out.values()) value = std::clamp(value, -kMostLight, kMostLight);
  return out;
}

} // namespace

const std::vector<Texture>& texturesOf(const trace::Trace& trace, const Image& window) {
  static std::map<const trace::Trace*, std::vector<Texture>> known;
  const auto [entry, fresh] = known.try_emplace(&trace);
  if (!fresh) return entry->second;
  for (const Drawn& drawn : sampledLater(trace)) {
    const bool whole =
        int(drawn.copy->width) == window.width() && int(drawn.copy->height) == window.height();
    if (drawn.attachment >= trace::kColors || !whole) continue;
    entry->second.push_back({drawn, cutOff(trace.image(*drawn.copy))});
  }
  return entry->second;
}

const Texture* wanted(const SceneEvidence& scene, const std::string& sampler) {
  const Texture* last = nullptr;
  for (const Texture& one : texturesOf(scene.referenceTrace, scene.reference.at(0)))
    if (one.drawn.uniform == sampler) last = &one;
  return last;
}

std::vector<PassOutput> outputOf(const View& view, const std::vector<std::string>& samplers) {
  std::vector<PassOutput> outputs;
  for (const std::string& sampler : samplers)
    for (const Drawn& drawn : sampledLater(view.trace))
      if (drawn.uniform == sampler) outputs.push_back({drawn.copy->pass, drawn.attachment});
  return outputs;
}

Match match(const Texture& found, const Texture& right, const Mask& region,
            const std::string& name) {
  CompareOptions options;
  options.mask = &region;
  const Comparison comparison = compare(found.image, right.image, options);
  return {comparison.compared() ? qualityOf(comparison.wrongShare) : 0, &found,
          fmt::format("{}: {:.1f}% of {} pixels differ{}", name, 100 * comparison.wrongShare,
                      comparison.judgedPixels, densestAt(comparison.densest))};
}

Verdict passesOrPicture(const Verdict& passes, const Verdict& picture) {
  if (picture.quality <= std::max(passes.quality, kRightPicture)) return passes;
  return {picture.quality, passes.message + "; but the picture counts: " + picture.message};
}

Verdict sameAgain(const View& view) {
  // What noise may differ, and at which share nothing is left: the same program draws the same.
  constexpr double kNoise = 0.001, kAllLeft = 0.01;
  const rubric::Frames& reference = view.scene.reference;
  for (std::size_t i = view.frames.size() - 1; i > 0; --i) {
    if (compare(reference[i], reference[0]).wrongPixels > 0) continue;
    const Comparison changed = compare(view.frames[i], view.frames[0]);
    return {1 - std::clamp((changed.wrongShare - kNoise) / kAllLeft, 0.0, 1.0),
            fmt::format("frame {}, with everything where it was in frame 1: {:.1f}% of the pixels "
                        "have changed{}",
                        i + 1, 100 * changed.wrongShare, densestAt(changed.densest))};
  }
  return {1, "nothing is where it was again"};
}

} // namespace deferred_rubric
