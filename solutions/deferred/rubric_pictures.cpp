#include "rubric_pictures.hpp"

#include "rubric/follows.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cmath>

namespace deferred_rubric {

namespace {

/// Of stored light: more is white in the window, whatever is added.
constexpr float kMostLight = 4;

/// RGB as it was copied; light is cut off, whole numbers are not.
Image pixelsOf(const trace::Trace& trace, const trace::CopyRecord& copy) {
  Image out = firstChannels(trace.image(copy), 3);
  const auto type = trace::PixelType(copy.type);
  if (type == trace::PixelType::i32x4 || type == trace::PixelType::u32x4) return out;
  for (float& value : out.values()) value = std::clamp(value, -kMostLight, kMostLight);
  return out;
}

/// Pixels much brighter or darker than the one on the left or above.
Mask outlines(const View& view, std::size_t frame) {
  constexpr float kContrast = 0.15f;
  const Image& window = view.frames.at(frame);
  Mask mask(window.width(), window.height());
  for (int y = 1; y < window.height(); ++y)
    for (int x = 1; x < window.width(); ++x)
      for (int c = 0; c < 3; ++c)
        if (std::abs(window.at(x, y, c) - window.at(x - 1, y, c)) > kContrast ||
            std::abs(window.at(x, y, c) - window.at(x, y - 1, c)) > kContrast)
          mask.set(x, y);
  return mask;
}

} // namespace

const std::vector<Texture>& texturesOf(const trace::Trace& trace, const Image& window) {
  return remembered(&trace, [&] {
    std::vector<Texture> all;
    for (const Drawn& drawn : sampledLater(trace)) {
      const bool whole =
          int(drawn.copy->width) == window.width() && int(drawn.copy->height) == window.height();
      if (drawn.attachment < trace::kColors && whole)
        all.push_back({drawn, pixelsOf(trace, *drawn.copy)});
    }
    return all;
  });
}

const Texture* wanted(const SceneEvidence& scene, const std::string& sampler) {
  const Texture* last = nullptr;
  for (const Texture& one : texturesOf(scene.referenceTrace, scene.reference.at(0)))
    if (one.drawn.uniform == sampler) last = &one;
  return last;
}

std::vector<PassOutput> outputOf(const trace::Trace& trace,
                                 const std::vector<std::string>& samplers) {
  std::vector<PassOutput> outputs;
  for (const std::string& sampler : samplers)
    for (const Drawn& drawn : sampledLater(trace))
      if (drawn.uniform == sampler) outputs.push_back({drawn.copy->pass, drawn.attachment});
  return outputs;
}

std::vector<PassOutput> outputOfObjects(const View& view,
                                        const std::vector<std::string>& samplers) {
  const std::vector<PassOutput> own = outputOf(view.trace, samplers);
  std::vector<PassOutput> right = outputOf(view.scene.referenceTrace, samplers);
  if (own.size() == right.size() || view.trace.frames.empty()) return own;
  for (const trace::PassRecord& pass : view.trace.passesOf(0)) {
    if (pass.framebuffer == 0 || !view.trace.drewObjects(pass)) continue;
    for (PassOutput& output : right) output.pass = view.trace.indexOf(pass);
    return right;
  }
  return {};
}

Verdict nowhere(const std::string& name) {
  return {0, gg::say("{}: no pass draws it into a texture that a later pass reads", name)};
}

Match match(const Texture& found, const Texture& right, const Mask& region, const std::string& name,
            double nothingLeft) {
  CompareOptions options;
  options.mask = &region;
  const Comparison comparison = compare(found.image, right.image, options);
  return {{comparison.compared() ? qualityOf(comparison.wrongShare, nothingLeft) : 0,
           gg::say("{}: {:.1f}% of {} pixels differ{}", name, 100 * comparison.wrongShare,
                   comparison.judgedPixels, densestAt(comparison.densest))},
          &found};
}

Verdict together(const std::vector<Verdict>& pictures) {
  if (pictures.empty()) return {1, gg::say("this scene has none")};
  double worst = 1, sum = 0;
  std::string message;
  for (const Verdict& one : pictures) {
    worst = std::min(worst, one.quality);
    sum += one.quality;
    if (one.quality < 1) message += (message.empty() ? "" : "; ") + one.message;
  }
  return {(worst + sum / double(pictures.size())) / 2,
          message.empty() ? gg::say("all match") : message};
}

Verdict passesOrPicture(const Verdict& passes, const Verdict& picture) {
  if (picture.quality <= std::max(passes.quality, kRightPicture)) return passes;
  return {picture.quality,
          gg::say("{}; but the picture counts: {}", passes.message, picture.message)};
}

Verdict sameAgain(const View& view) {
  // What noise may differ, and at which share nothing is left: the same program draws the same.
  constexpr double kNoise = 0.001, kAllLeft = 0.006;
  const rubric::Frames& reference = view.scene.reference;
  for (std::size_t i = view.frames.size() - 1; i > 0; --i) {
    if (compare(reference[i], reference[0]).wrongPixels > 0) continue;
    const Comparison changed = compare(view.frames[i], view.frames[0]);
    return {1 - std::clamp((changed.wrongShare - kNoise) / kAllLeft, 0.0, 1.0),
            gg::say("frame {}, with everything where it was in frame 1: {:.1f}% of the pixels "
                    "have changed{}",
                    i + 1, 100 * changed.wrongShare, densestAt(changed.densest))};
  }
  return {1, gg::say("nothing is where it was again")};
}

Verdict outlinesFollow(const View& view) {
  return follows(view, outlines, gg::say("outlines"));
}

} // namespace deferred_rubric
