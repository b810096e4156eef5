// The rubric of part "bloom". Titles and points stand in assignment.json.
//
// Each item looks at the pass that it is about; where a pass can't be found or is made in another
// way, the picture in the window decides: who has that right has all of it right. A level counts as
// right if it matches the reference's, or what the filter makes of the submission's own level
// before it. A factor 1/levels may be applied in the bright pass (as the handout says) or at the
// end (as the lecture does): a bright pass that is brighter by the number of levels sets the gain
// for all.

#include "rubric/follows.hpp"
#include "rubric/measures.hpp"
#include "rubric_pyramid.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>

using namespace floor_rubric;
using namespace ggrade::rubric;

namespace {

/// Least difference that bloom makes where an item looks at the window.
constexpr float kReach = 10.0f / 255;
/// Share of wrong pixels at which a pass, or the picture, has nothing left.
constexpr double kNothingOfPass = 0.15, kNothingOfPicture = 0.25;
/// Light that differs by this share, in all, is right; and has nothing left.
constexpr double kFreeGain = 0.05, kNothingOfGain = 0.3;
/// A picture as right as this is made by passes that are right, in whatever way.
constexpr double kRightPicture = 0.9;

/// Probes: the reference with its other filters, its other edge rule, and with 11 bits a channel.
constexpr const char* kFilters[] = {"5x5",     "dual",   "13 samples", "13 samples, mirrored",
                                    "clamped", "11 bits"};

/// Formats that hold more than 0 to 1.
bool holdsLight(std::uint32_t format) {
  for (const char* name : {"RGBA16F", "RGB16F", "RGBA32F", "RGB32F", "R11F_G11F_B10F"})
    if (trace::glName(format) == name) return true;
  return false;
}

const Pyramid& referencePyramid(const View& view) {
  static std::map<const SceneEvidence*, Pyramid> known;
  auto [entry, fresh] = known.try_emplace(&view.scene);
  if (fresh) entry->second = ownPyramid(view.scene.referenceTrace);
  return entry->second;
}

const Pyramid& pyramidOf(const View& view) {
  static std::map<const trace::Trace*, Pyramid> known;
  auto [entry, fresh] = known.try_emplace(&view.trace);
  if (fresh) entry->second = pyramidLike(referencePyramid(view), view.trace);
  return entry->second;
}

/// Where bloom makes a difference in the window.
Mask halo(const View& view, std::size_t frame) {
  return differenceMask(view.scene.reference.at(frame), view.scene.probes.at("no bloom").at(frame),
                        kReach);
}

/// How much light bloom adds in all, as a share of what it adds in the reference. Where either one
/// ends at 1 nothing can be told.
double addedLight(const Image& image, const Image& reference, const Image& without,
                  const Mask& region) {
  double own = 0, wanted = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; region.at(x, y) && c < 3; ++c) {
        if (std::max(image.at(x, y, c), reference.at(x, y, c)) >= 1) continue;
        own += double(image.at(x, y, c)) - double(without.at(x, y, c));
        wanted += double(reference.at(x, y, c)) - double(without.at(x, y, c));
      }
  return wanted > 0 ? own / wanted : 1;
}

/// Are all levels those of the reference but for a factor? Then its filter is ours, and only our
/// picture is right.
bool isScaled(const View& view) {
  const std::vector<Level>&own = pyramidOf(view).levels, &wanted = referencePyramid(view).levels;
  const double ratio = compareLight(own.at(0).down, wanted.at(0).down, 1).ratio;
  if (ratio <= 0 || std::abs(ratio - 1) < kFreeGain) return false;
  for (std::size_t k = 0; k < wanted.size(); ++k)
    if (compareLight(own.at(k).down, wanted.at(k).down, ratio).wrongShare > kOtherWays)
      return false;
  return true;
}

/// The picture against the reference with each filter; other weights than ours are as good.
Verdict picture(const View& view) {
  const bool scaled = isScaled(view);
  return worstFrame(view, [&](std::size_t i) -> Verdict {
    const Mask region = halo(view, i);
    if (tooSmall(region)) return {1, gg::say("nothing glows in this frame")};
    CompareOptions options;
    options.mask = &region;
    std::vector<const Image*> right{&view.scene.reference.at(i)};
    for (const char* filter : kFilters)
      if (!scaled) right.push_back(&view.scene.probes.at(filter).at(i));
    const Comparison best = compareWithBest(view.frames.at(i), right, options).comparison;
    const Verdict seen{qualityOf(best.wrongShare, kNothingOfPicture),
                       gg::say("{:.1f}% of the {} pixels that bloom reaches differ{}",
                               100 * best.wrongShare, region.count(), densestAt(best.densest))};
    if (!scaled) return seen;
    const double light =
        addedLight(view.frames.at(i), *right[0], view.scene.probes.at("no bloom").at(i), region);
    const double quality =
        std::clamp((kNothingOfGain - std::abs(light - 1)) / (kNothingOfGain - kFreeGain), 0.0, 1.0);
    if (quality >= seen.quality) return seen;
    return {quality, gg::say("bloom adds {:.2f} of the light that it should", light)};
  });
}

GGRADE_ITEM("bloom.picture", picture);

/// What a pass shows, or the picture if that is right.
Verdict passOrPicture(const View& view, double quality, const std::string& message) {
  const Verdict whole = picture(view);
  if (whole.quality <= std::max(quality, kRightPicture)) return {quality, message};
  return {whole.quality, gg::say("{}; but the picture counts: {}", message, whole.message)};
}

double sceneQuality(const View& view, std::string& message) {
  const Pyramid& found = pyramidOf(view);
  if (found.scene.empty()) {
    message = gg::say("scene: no pass draws the objects into a texture that a later pass samples");
    return 0;
  }
  const std::string format = trace::glName(found.sceneFormat);
  if (!holdsLight(found.sceneFormat)) {
    message = gg::say("scene: kept in {}, which ends at 1", format);
    return 0;
  }
  const LightComparison light = compareLight(found.scene, referencePyramid(view).scene, 1);
  message = gg::say("scene: {}, {}", format, light.text);
  return qualityOf(light.wrongShare, kNothingOfPass);
}

GGRADE_ITEM("bloom.target", [](const View& view) -> Verdict {
  const Pyramid& found = pyramidOf(view);
  if (found.scene.empty() || !found.sceneOutput)
    return passOrPicture(
        view, 0, gg::say("no pass draws the objects into a texture that a later pass samples"));
  const std::string format = trace::glName(found.sceneFormat);
  if (!holdsLight(found.sceneFormat))
    return passOrPicture(view, 0, gg::say("kept in {}, which ends at 1", format));
  const trace::PassRecord& pass = view.trace.passes[found.sceneOutput->pass];
  if (pass.images[trace::kDepth].kind == std::uint32_t(trace::ImageKind::none))
    return passOrPicture(view, 0, gg::say("{} without a depth attachment", format));
  return {1, gg::say("{} with a depth attachment", format)};
});

GGRADE_ITEM("bloom.scene", [](const View& view) {
  std::string message;
  const double quality = sceneQuality(view, message);
  return passOrPicture(view, quality, message);
});

/// The factor that the submission's light carries until the end: 1, or the number of levels.
double gainOf(const View& view) {
  const Pyramid& wanted = referencePyramid(view);
  const double levels = double(wanted.levels.size());
  const LightComparison bright =
      compareLight(pyramidOf(view).levels.at(0).down, wanted.levels.at(0).down, 1);
  return std::abs(bright.ratio / levels - 1) < 0.1 ? levels : 1;
}

LightComparison brightPass(const View& view) {
  return compareLight(pyramidOf(view).levels.at(0).down, referencePyramid(view).levels.at(0).down,
                      gainOf(view));
}

/// Does a step of the pass read what another pass drew?
bool readsFrom(const View& view, const trace::PassRecord& pass, std::uint32_t writer) {
  for (const trace::StepRecord& step : view.trace.stepsOf(pass))
    for (const trace::SampleRecord& sample : view.trace.samplesOf(step))
      if (sample.writer == writer) return true;
  return false;
}

/// Does the viewport of one of its steps cover the level?
bool coversItsTarget(const View& view, const trace::PassRecord& pass, const Level& level) {
  return std::ranges::any_of(view.trace.stepsOf(pass), [&](const trace::StepRecord& step) {
    const auto& [x, y, width, height] = step.viewport;
    return x <= 0 && y <= 0 && x + width >= level.width && y + height >= level.height;
  });
}

GGRADE_ITEM("bloom.half", [](const View& view) -> Verdict {
  const Pyramid& found = pyramidOf(view);
  const Level& level = found.levels.at(0);
  if (!level.output)
    return passOrPicture(view, 0,
                         gg::say("no pass over the whole of a texture of half the scene's size"));
  if (!holdsLight(level.format))
    return passOrPicture(view, 0,
                         gg::say("kept in {}, which ends at 1", trace::glName(level.format)));
  const trace::PassRecord& pass = view.trace.passes[level.output->pass];
  if (!found.sceneOutput || !readsFrom(view, pass, found.sceneOutput->pass))
    return passOrPicture(view, 0, gg::say("level 0 is not drawn from the scene's texture"));
  if (!coversItsTarget(view, pass, level))
    return passOrPicture(view, 0, gg::say("the viewport is smaller than level 0"));
  return {1, gg::say("level 0 is drawn from the scene")};
});

GGRADE_ITEM("bloom.bright", [](const View& view) {
  std::string scene;
  const bool sceneRight = sceneQuality(view, scene) > 0.5;
  const LightComparison light = brightPass(view);
  const double quality = qualityOf(light.wrongShare, kNothingOfPass);
  std::string message = gg::say("bright pass: {}", light.text);
  if (quality < 1)
    message = sceneRight ? gg::say("the first wrong pass is the bright pass: {}", light.text)
                         : gg::say("bright pass: {}; the first wrong pass is the scene ({})",
                                   light.text, scene);
  return passOrPicture(view, quality, message);
});

/// One kind of level, from the largest to the smallest or back: the share that is right, and the
/// first that isn't in words. `nameOf(k)` names a level; `compareOne(k)` is empty for a level that
/// has none of the kind.
template <class NameOf, class CompareOne>
Verdict levelsInOrder(const std::vector<std::size_t>& order, NameOf nameOf, CompareOne compareOne) {
  double sum = 0;
  std::string wrong;
  bool earlier = false;
  for (const std::size_t k : order) {
    const LightComparison light = compareOne(k);
    const double quality = qualityOf(light.wrongShare, kNothingOfPass);
    sum += quality;
    if (quality < 1 && wrong.empty())
      wrong = earlier ? gg::say("{}: {}; earlier levels match", nameOf(k), light.text)
                      : fmt::format("{}: {}", nameOf(k), light.text);
    earlier = true;
  }
  if (order.empty()) return {1, gg::say("there is one level only")};
  return {sum / double(order.size()), wrong.empty() ? gg::say("all levels match") : wrong};
}

/// The better of two comparisons.
LightComparison better(const LightComparison& a, const LightComparison& b) {
  return a.wrongShare <= b.wrongShare ? a : b;
}

/// Every filter makes the same of black, of one colour, and of light near the end of what a float
/// holds: a level of that shows no filter.
bool provesNothing(const Image& filtered) {
  if (findNonFinite(filtered)) return true;
  const auto channels = std::size_t(filtered.channels());
  std::vector<double> mean(channels);
  for (std::size_t i = 0; i < filtered.values().size(); ++i)
    mean[i % channels] += double(filtered.values()[i]) / double(filtered.pixelCount());
  Image flat = filtered;
  for (std::size_t i = 0; i < flat.values().size(); ++i)
    flat.values()[i] = float(mean[i % channels]);
  return compareLight(flat, filtered, 1).wrongShare < kNothingOfPass;
}

GGRADE_ITEM("bloom.levels", [](const View& view) {
  const Pyramid& wanted = referencePyramid(view);
  const Pyramid& found = pyramidOf(view);
  const double gain = gainOf(view);
  std::vector<std::size_t> order;
  for (std::size_t k = 1; k < wanted.levels.size(); ++k) {
    // As of the scene: what ends at 1 has a handful of steps for a dim halo, and no room for a sum.
    if (!found.levels[k].down.empty() && !holdsLight(found.levels[k].format))
      return passOrPicture(view, 0,
                           gg::say("bloom level {}: kept in {}, which ends at 1", k,
                                   trace::glName(found.levels[k].format)));
    order.push_back(k);
  }
  Verdict verdict = levelsInOrder(
      order, [](std::size_t k) { return gg::say("bloom level {}", k); },
      [&](std::size_t k) {
        const Level& level = wanted.levels[k];
        const LightComparison light = compareLight(found.levels[k].down, level.down, gain);
        const Image& before = found.levels[k - 1].down;
        if (light.wrongShare < kOtherWays || before.empty() || findNonFinite(before)) return light;
        const Image filtered = byTent(before, level.width, level.height);
        if (provesNothing(filtered)) return light;
        return better(light, compareLight(found.levels[k].down, filtered, 1));
      });
  if (brightPass(view).wrongShare > kNothingLeft)
    verdict.message = gg::say("after a wrong bright pass: {}", verdict.message);
  return passOrPicture(view, verdict.quality, verdict.message);
});

GGRADE_ITEM("bloom.sum", [](const View& view) {
  const Pyramid& wanted = referencePyramid(view);
  const Pyramid& found = pyramidOf(view);
  const double gain = gainOf(view);
  std::vector<std::size_t> order;
  for (std::size_t k = wanted.levels.size() - 1; k-- > 0;) order.push_back(k);
  const Verdict verdict = levelsInOrder(
      order, [](std::size_t k) { return gg::say("the sum at level {}", k); },
      [&](std::size_t k) {
        const Level& level = wanted.levels[k];
        LightComparison light = compareLight(found.levels[k].up, level.up, gain);
        const Image &own = found.levels[k].down, &smaller = found.levels[k + 1].up;
        if (!found.levels[k].summed) {
          light.wrongShare = 1;
          light.text = gg::say("nothing was added");
          return light;
        }
        if (light.wrongShare < kOtherWays || findNonFinite(own) || smaller.empty() ||
            findNonFinite(smaller))
          return light;
        Image sum = byTent(smaller, own.width(), own.height());
        if (provesNothing(sum)) return light; // of what was added: the level itself is there anyway
        for (std::size_t i = 0; i < sum.values().size(); ++i) sum.values()[i] += own.values()[i];
        if (findNonFinite(sum)) return light;
        return better(light, compareLight(found.levels[k].up, sum, 1));
      });
  return passOrPicture(view, verdict.quality, verdict.message);
});

/// Where the levels `first` to `last` were drawn on the way down; empty unless all of them were.
std::vector<PassOutput> levelOutputs(const View& view, std::size_t first, std::size_t last) {
  const Pyramid& pyramid = pyramidOf(view);
  std::vector<PassOutput> outputs;
  for (std::size_t k = first; k < std::min(last, pyramid.levels.size()); ++k) {
    if (!pyramid.levels[k].output) return {};
    outputs.push_back(*pyramid.levels[k].output);
  }
  return outputs;
}

GGRADE_PASS("bloom.scene", [](const View& view) -> std::vector<PassOutput> {
  const Pyramid& pyramid = pyramidOf(view);
  if (!pyramid.sceneOutput) return {};
  return {*pyramid.sceneOutput};
});

GGRADE_PASS("bloom.bright", [](const View& view) { return levelOutputs(view, 0, 1); });

GGRADE_PASS("bloom.levels", [](const View& view) { return levelOutputs(view, 1, SIZE_MAX); });

GGRADE_ITEM("bloom.tiny", picture);

/// Pixels that a wrong bloom doesn't explain: where there is none they look like no allowed
/// picture; where there is some they are darker than without any.
double spoiled(const View& view, std::size_t frame, std::string& where) {
  const Image& image = view.frames.at(frame);
  const auto& probes = view.scene.probes;
  Mask wrong(image.width(), image.height(), true);
  const auto allow = [&](const Image& other) {
    if (const Comparison comparison = compare(image, other); comparison.compared())
      wrong = wrong & comparison.wrong;
  };
  allow(view.scene.reference.at(frame));
  allow(probes.at("undone").at(frame));
  if (const auto none = probes.find("no bloom"); none != probes.end()) {
    const Image& bare = none->second.at(frame);
    allow(bare);
    for (const char* filter : kFilters)
      if (wrong.count() > 0) allow(probes.at(filter).at(frame)); // some reach farther
    const Mask touched = differenceMask(view.scene.reference.at(frame), bare, 1.5f / 255);
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        if (!wrong.at(x, y) || !touched.at(x, y)) continue;
        bool darker = false;
        for (int c = 0; c < 3; ++c)
          darker |= image.at(x, y, c) < bare.at(x, y, c) - 2 * tolerances().tolerance;
        wrong.set(x, y, darker);
      }
  }
  const double share = double(wrong.count()) / double(image.pixelCount());
  where = gg::say("{:.1f}% of the pixels show neither the scene nor light added to it{}",
                  100 * share, densestAt(densestWindow(wrong)));
  return share;
}

GGRADE_ITEM("bloom.keep_picture", [](const View& view) -> Verdict {
  std::string where;
  const double share = spoiled(view, 0, where);
  return {unharmed(share), where};
});

GGRADE_ITEM("bloom.keep_state", [](const View& view) {
  return laterFrames(view,
                     [&](std::size_t i, std::string& where) { return spoiled(view, i, where); });
});

GGRADE_ITEM("bloom.keep_following", [](const View& view) {
  const Effect glow = [](const View& of, std::size_t frame) {
    const Image& image = of.frames.at(frame);
    const Image& without = of.scene.probes.at("no bloom").at(frame);
    Mask brighter(image.width(), image.height());
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        for (int c = 0; c < 3; ++c)
          if (image.at(x, y, c) > without.at(x, y, c) + kReach) brighter.set(x, y);
    return brighter;
  };
  return follows(view, glow, gg::say("bloom"));
});

/// One combination of effects must explain all frames: what is right in the first and lacks its
/// shadows in the next has left state behind.
GGRADE_ITEM("bloom.keep_together", [](const View& view) -> Verdict {
  double least = 2;
  std::string where;
  const auto against = [&](const rubric::Frames& wanted) {
    double worst = -1;
    std::string at;
    for (std::size_t i = 0; i < view.frames.size(); ++i) {
      const Comparison comparison = compare(view.frames.at(i), wanted.at(i));
      if (comparison.wrongShare <= worst) continue;
      worst = comparison.wrongShare;
      at = gg::say("frame {}: {:.1f}% of the pixels differ from every combination of effects{}",
                   i + 1, 100 * worst, densestAt(comparison.densest));
    }
    if (worst < least) least = worst, where = at;
  };
  against(view.scene.reference);
  for (const auto& [name, images] : view.scene.probes)
    if (least > 0) against(images);
  return {unharmed(least), where};
});

} // namespace
