// The rubric of part "targets". Titles and points stand in assignment.json.
//
// The three kinds of light are looked for among the textures that objects are drawn into; in which
// order they are attached is nobody's concern. Who has the picture right has the textures right.

#include "rubric_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

using namespace deferred_rubric;

namespace {

/// A sampler of the reference's composition, and what it reads.
constexpr std::pair<const char*, const char*> kKinds[] = {
    {"uDiffuse", "diffuse light"}, {"uSpecular", "specular light"}, {"uAmbient", "ambient light"}};

/// Stored light that is told from none.
constexpr float kLeastLight = 4.0f / 255;

/// Where objects are seen, edges left out.
const Mask& objects(const SceneEvidence& scene, std::size_t frame) {
  static std::map<std::pair<const SceneEvidence*, std::size_t>, Mask> known;
  const auto [entry, fresh] = known.try_emplace({&scene, frame});
  if (fresh) entry->second = erode(shown(scene.probes.at("objects").at(frame)), 1);
  return entry->second;
}

Verdict window(const View& view) {
  return picture(view, [&](std::size_t i) { return objects(view.scene, i); });
}

/// The textures that hold the kinds, and how right they are.
struct Kinds {
  Verdict verdict;
  std::vector<const Texture*> textures;
};

Kinds kindsOf(const View& view) {
  Kinds kinds;
  double sum = 0;
  for (const auto& [sampler, name] : kKinds) {
    const Texture* right = wanted(view.scene, sampler);
    if (!right) continue; // this scene has none
    // Where there is such light; elsewhere any dark texture would do.
    const Image none(right->image.width(), right->image.height(), 3);
    const Mask lit = dilate(differenceMask(right->image, none, kLeastLight), 1);
    const Match best =
        bestMatch(view, *right, lit & objects(view.scene, 0), name,
                  [](const Texture& texture) { return drewObjects(*texture.drawn.pass); });
    sum += best.quality;
    if (best.texture) kinds.textures.push_back(best.texture);
    if (best.quality < 1)
      kinds.verdict.message += (kinds.verdict.message.empty() ? "" : "; ") + best.message;
    kinds.verdict.quality += 1;
  }
  kinds.verdict.quality = sum / std::max(kinds.verdict.quality, 1.0);
  if (kinds.verdict.message.empty()) kinds.verdict.message = "all kinds of light are there";
  return kinds;
}

GGRADE_ITEM("targets.kinds",
            [](const View& view) { return passesOrPicture(kindsOf(view).verdict, window(view)); });

GGRADE_PASS("targets.kinds", [](const View& view) -> std::vector<PassOutput> {
  return outputOf(view, {"uDiffuse", "uSpecular", "uAmbient"});
});

GGRADE_ITEM("targets.once", [](const View& view) -> Verdict {
  const Kinds kinds = kindsOf(view);
  const bool once =
      std::all_of(kinds.textures.begin(), kinds.textures.end(), [&](const Texture* texture) {
        return texture->drawn.pass == kinds.textures.front()->drawn.pass;
      });
  if (!once) return {0, "the kinds of light come from different passes"};
  return {kinds.verdict.quality, "one pass draws " + std::to_string(kinds.textures.size()) +
                                     " textures; " + kinds.verdict.message};
});

GGRADE_ITEM("targets.compose", window);

/// Where the filter takes more than there is, and one pixel around it: what is less than 0 there is
/// another item's.
Mask negative(const SceneEvidence& scene) {
  const Image& light = wanted(scene, "uDiffuse")->image;
  const int width = light.width(), height = light.height();
  Mask mask(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c) {
        const auto at = [&](int u, int v) {
          return light.at(std::clamp(u, 0, width - 1), std::clamp(v, 0, height - 1), c);
        };
        const float sum = 5 * at(x, y) - at(x - 1, y) - at(x + 1, y) - at(x, y - 1) - at(x, y + 1);
        if (sum < -kTolerance) mask.set(x, y);
      }
  return dilate(mask, 1);
}

/// Pixels that have a neighbour outside the window.
Mask border(const Image& window) {
  Mask inner(window.width(), window.height());
  for (int y = 1; y + 1 < window.height(); ++y)
    for (int x = 1; x + 1 < window.width(); ++x) inner.set(x, y);
  return ~inner;
}

/// What the border is worth: there it shows what the textures say of neighbours that aren't there.
constexpr double kBorder = 0.2;

// The first frame: only there are the textures known.
GGRADE_ITEM("targets.edges", [](const View& view) -> Verdict {
  const Image& reference = view.scene.reference.at(0);
  const Mask ordinary = ~negative(view.scene);
  const Mask edges =
      differenceMask(reference, view.scene.probes.at("no edges").at(0), kTolerance) & ordinary;
  const Verdict inner = within(view, 0, edges, "edges");
  const Verdict outer = within(view, 0, border(reference) & ordinary, "the window's border");
  return {inner.quality * (1 - kBorder + kBorder * outer.quality),
          inner.message + "; " + outer.message};
});

GGRADE_ITEM("targets.negative", [](const View& view) -> Verdict {
  const Mask region =
      negative(view.scene) & differenceMask(view.scene.reference.at(0),
                                            view.scene.probes.at("no edges").at(0), kTolerance);
  if (tooSmall(region)) return {1, "the filter takes nowhere more than there is"};
  return within(view, 0, region, "where the filter takes more than there is");
});

/// Pixels whose light is above what 8 bits a channel hold.
Mask aboveOne(const Image& image) {
  Mask mask(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      mask.set(x, y, *std::ranges::max_element(image.pixel(x, y)) > 1 + 2 * kTolerance);
  return mask;
}

GGRADE_ITEM("targets.bright", [](const View& view) -> Verdict {
  const Texture& right = *wanted(view.scene, "uDiffuse");
  const Match best = bestMatch(
      view, right, aboveOne(right.image) & objects(view.scene, 0), "diffuse light above 1",
      [](const Texture& texture) { return drewObjects(*texture.drawn.pass); });
  const Mask matters =
      differenceMask(view.scene.reference.at(0), view.scene.probes.at("8 bits").at(0), kTolerance);
  if (tooSmall(matters)) return {best.quality, best.message};
  return passesOrPicture({best.quality, best.message}, within(view, 0, matters, "window"));
});

/// Share of the background that isn't what it was.
double spoiled(const View& view, std::size_t frame, std::string& where) {
  const Mask region = ~dilate(shown(view.scene.probes.at("objects").at(frame)), 2);
  if (tooSmall(region)) return 0;
  CompareOptions options;
  options.mask = &region;
  const Comparison comparison =
      compare(view.frames.at(frame), view.scene.reference.at(frame), options);
  where = fmt::format("{:.1f}% of the background differs{}", 100 * comparison.wrongShare,
                      densestAt(comparison.densest));
  return comparison.wrongShare;
}

GGRADE_ITEM("targets.keep_background", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) -> Verdict {
    std::string where;
    const double share = spoiled(view, i, where);
    return {unharmed(share), where};
  });
});

GGRADE_ITEM("targets.keep_state", sameAgain);

} // namespace
