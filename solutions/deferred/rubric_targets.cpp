// The rubric of part "targets". Titles and points stand in assignment.json.
//
// The three kinds of light are looked for among the textures that objects are drawn into; in which
// order they are attached is nobody's concern. Who has the picture right has the textures right.

#include "rubric_pictures.hpp"
#include "words/words.hpp"

#include <algorithm>

using namespace deferred_rubric;

namespace {

/// A sampler of the reference's composition, what it reads, and where that is, for messages.
struct Kind {
  const char* sampler;
  std::string name, place;
};

std::vector<Kind> allKinds() {
  return {{"uDiffuse", gg::say("diffuse light"), gg::say("where there is diffuse light")},
          {"uSpecular", gg::say("specular light"), gg::say("where there is specular light")},
          {"uAmbient", gg::say("ambient light"), gg::say("where there is ambient light")}};
}

/// Stored light that is told from none.
constexpr float kLeastLight = 4.0f / 255;

/// Where objects are seen, edges left out.
const Mask& objects(const SceneEvidence& scene, std::size_t frame) {
  const Image& probe = scene.probes.at("objects").at(frame);
  return remembered(&probe, [&] { return erode(shown(probe), 1); });
}

Verdict window(const View& view) {
  return picture(view, [&](std::size_t i) { return objects(view.scene, i); });
}

bool ofObjects(const Texture& texture) {
  return texture.drawn.ofObjects;
}

/// The textures that hold the kinds, and how right they are.
struct Kinds {
  Verdict verdict;
  std::vector<const Texture*> textures;
};

Kinds kindsOf(const View& view) {
  std::vector<Verdict> verdicts;
  Kinds kinds;
  for (const auto& [sampler, name, place] : allKinds()) {
    const Texture* right = wanted(view.scene, sampler);
    if (!right) continue; // this scene has none
    // Where there is such light; elsewhere any dark texture would do.
    const Image none(right->image.width(), right->image.height(), 3);
    const Mask lit = dilate(differenceMask(right->image, none, kLeastLight), 1);
    const Mask region = lit & objects(view.scene, 0);
    if (tooSmall(region)) continue;
    const Match best = bestMatch(view, *right, region, name, ofObjects);
    verdicts.push_back(best.verdict);
    if (best.texture) kinds.textures.push_back(best.texture);
  }
  kinds.verdict = together(verdicts);
  return kinds;
}

GGRADE_ITEM("targets.kinds",
            [](const View& view) { return passesOrPicture(kindsOf(view).verdict, window(view)); });

GGRADE_PASS("targets.kinds", [](const View& view) {
  return outputOfObjects(view, {"uDiffuse", "uSpecular", "uAmbient"});
});

GGRADE_ITEM("targets.once", [](const View& view) -> Verdict {
  const Kinds kinds = kindsOf(view);
  const bool once =
      std::all_of(kinds.textures.begin(), kinds.textures.end(), [&](const Texture* texture) {
        return texture->drawn.pass == kinds.textures.front()->drawn.pass;
      });
  if (!once) return {0, gg::say("the kinds of light come from different passes")};
  return {kinds.verdict.quality,
          gg::say("one pass draws {} textures; {}", kinds.textures.size(), kinds.verdict.message)};
});

/// Pixels that have less light than that.
Mask darker(const Image& found, const Image& light, const Mask& region) {
  Mask mask(found.width(), found.height());
  for (int y = 0; y < found.height(); ++y)
    for (int x = 0; x < found.width(); ++x)
      for (int c = 0; c < 3; ++c)
        if (region.at(x, y) && found.at(x, y, c) < std::min(light.at(x, y, c), 1.0f) - kTolerance)
          mask.set(x, y);
  return mask;
}

/// The objects' diffuse light in a texture, and from there, with or without other light, in the
/// window.
GGRADE_ITEM("targets.through", [](const View& view) {
  const Texture& right = *wanted(view.scene, "uDiffuse");
  const Mask& region = objects(view.scene, 0);
  const Verdict texture =
      bestMatch(view, right, region, gg::say("diffuse light"), ofObjects).verdict;
  const double share = double(darker(view.frames.at(0), right.image, region).count()) /
                       double(std::max<std::size_t>(region.count(), 1));
  const Verdict shown{qualityOf(share),
                      gg::say("the window has less than the diffuse light in {:.1f}% of {} pixels",
                              100 * share, region.count())};
  return passesOrPicture(texture.quality < shown.quality ? texture : shown, window(view));
});

/// Where a window without this kind of light would look different.
Mask matters(const SceneEvidence& scene, const Texture& kind) {
  const Image& window = scene.reference.at(0);
  Image without(window.width(), window.height(), 3);
  for (const auto& [sampler, name, place] : allKinds()) {
    const Texture* other = wanted(scene, sampler);
    if (!other || other == &kind) continue;
    for (std::size_t i = 0; i < without.values().size(); ++i)
      without.values()[i] += other->image.values()[i];
  }
  for (float& value : without.values()) value = std::min(value, 1.0f);
  return differenceMask(window, without, 4 * kTolerance);
}

/// Highlights are small: each kind of light counts where it is seen, and the whole picture, too.
GGRADE_ITEM("targets.compose", [](const View& view) {
  std::vector<Verdict> kinds;
  for (const auto& [sampler, name, place] : allKinds()) {
    const Texture* kind = wanted(view.scene, sampler);
    if (!kind) continue;
    const Mask region = matters(view.scene, *kind) & objects(view.scene, 0);
    if (!tooSmall(region)) kinds.push_back(within(view, 0, region, place));
  }
  const Verdict seen = together(kinds), all = window(view);
  return seen.quality < all.quality ? seen : all;
});

/// Where emphasising the edges makes a difference.
Mask edges(const SceneEvidence& scene, std::size_t frame) {
  return differenceMask(scene.reference.at(frame), scene.probes.at("no edges").at(frame),
                        kTolerance);
}

/// Where the filter takes all there is, or more, and one pixel around it: what is less than 0 there
/// is another item's.
Mask negative(const SceneEvidence& scene, std::size_t frame) {
  const Image& filtered = scene.probes.at("diffuse alone").at(frame);
  Mask mask(filtered.width(), filtered.height());
  for (int y = 0; y < filtered.height(); ++y)
    for (int x = 0; x < filtered.width(); ++x)
      mask.set(x, y, *std::ranges::min_element(filtered.pixel(x, y)) <= 0);
  return dilate(mask & edges(scene, frame), 1);
}

/// Pixels that have a neighbour outside the window.
Mask border(const Image& window) {
  Mask inner(window.width(), window.height());
  for (int y = 1; y + 1 < window.height(); ++y)
    for (int x = 1; x + 1 < window.width(); ++x) inner.set(x, y);
  return ~inner;
}

GGRADE_ITEM("targets.edges", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) {
    return within(view, i, edges(view.scene, i) & ~negative(view.scene, i), gg::say("edges"));
  });
});

/// There a filter shows what the textures say of neighbours that aren't there.
GGRADE_ITEM("targets.border", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) {
    const Mask region = border(view.scene.reference.at(i)) & ~negative(view.scene, i);
    return within(view, i, region, gg::say("the window's border"));
  });
});

GGRADE_ITEM("targets.negative", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) -> Verdict {
    const Mask region = edges(view.scene, i) & negative(view.scene, i);
    if (tooSmall(region)) return {1, gg::say("the filter takes nowhere more than there is")};
    return within(view, i, region, gg::say("where the filter takes more than there is"));
  });
});

/// Pixels whose light is above what 8 bits a channel hold.
Mask aboveOne(const Image& image) {
  Mask mask(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      mask.set(x, y, *std::ranges::max_element(image.pixel(x, y)) > 1 + 2 * kTolerance);
  return mask;
}

GGRADE_ITEM("targets.bright", [](const View& view) {
  const Texture& right = *wanted(view.scene, "uDiffuse");
  const Match best = bestMatch(view, right, aboveOne(right.image) & objects(view.scene, 0),
                               gg::say("diffuse light above 1"), ofObjects);
  const Verdict window = worstFrame(view, [&](std::size_t i) -> Verdict {
    const Mask matters = differenceMask(view.scene.reference.at(i),
                                        view.scene.probes.at("8 bits").at(i), kTolerance);
    if (tooSmall(matters)) return {0, gg::say("8 bits would do in this frame")};
    return within(view, i, matters, gg::say("window"));
  });
  return passesOrPicture(best.verdict, window);
});

/// Share of the background that isn't what it was.
double spoiled(const View& view, std::size_t frame, std::string& where) {
  const Mask region = ~dilate(shown(view.scene.probes.at("objects").at(frame)), 2);
  if (tooSmall(region)) return 0;
  CompareOptions options;
  options.mask = &region;
  const Comparison comparison =
      compare(view.frames.at(frame), view.scene.reference.at(frame), options);
  where = gg::say("{:.1f}% of the background differs{}", 100 * comparison.wrongShare,
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

GGRADE_ITEM("targets.keep_following", outlinesFollow);

} // namespace
