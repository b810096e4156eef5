// The rubric of part "figure". Titles and points stand in assignment.json.
//
// Each of the figure's pictures is looked for among the textures of the window's size; the one that
// is most like the reference's counts, whatever the submission calls it. Who has the composition
// right has the pictures right that it is made of.

#include "rubric_pictures.hpp"

#include "rubric/light.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

using namespace deferred_rubric;

namespace {

/// Where there is a surface, edges left out.
const Mask& surfaces(const SceneEvidence& scene) {
  return remembered(&scene, [&] {
    const Image& ids = wanted(scene, "uIds")->image;
    return erode(differenceMask(ids, Image(ids.width(), ids.height(), ids.channels()), 0.5f), 1);
  });
}

/// Pixels that no occlusion darkens: how many points are tested, and which, is everyone's own.
const Mask& unoccluded(const SceneEvidence& scene, std::size_t frame) {
  const Image& reference = scene.reference.at(frame);
  return remembered(&reference, [&] {
    const Image& open = scene.probes.at("open").at(frame);
    return ~dilate(differenceMask(reference, open, 1.5f / 255), 1);
  });
}

// IEC 61966-2-1, which windows are encoded by, of values from 0 to 1.
float decoded(float shown) {
  return shown <= 0.04045f ? shown / 12.92f : std::pow((shown + 0.055f) / 1.055f, 2.4f);
}
float encoded(float light) {
  return light <= 0.0031308f ? 12.92f * light : 1.055f * std::pow(light, 1 / 2.4f) - 0.055f;
}

/// The light of a window's colours.
Image decoded(const Image& window) {
  Image out = window;
  for (float& value : out.values()) value = decoded(value);
  return out;
}

/// A window in which surfaces scatter what they mirror, too: the plain sum that handouts once asked
/// for. It counts as right, as it was.
const Image& plainSum(const SceneEvidence& scene, std::size_t frame) {
  const Image& reference = scene.reference.at(frame);
  return remembered(&reference, [&] {
    const Image& scattered = scene.probes.at("scatters only").at(frame);
    const Image& mirrored = scene.probes.at("mirrors only").at(frame);
    Image sum = reference;
    for (int y = 0; y < sum.height(); ++y)
      for (int x = 0; x < sum.width(); ++x) {
        // The sky is the same in all three.
        if (std::ranges::equal(scattered.pixel(x, y), mirrored.pixel(x, y))) continue;
        for (int c = 0; c < 3; ++c) {
          const float light = decoded(scattered.at(x, y, c)) + decoded(mirrored.at(x, y, c));
          sum.at(x, y, c) = encoded(std::min(light, 1.0f));
        }
      }
    return sum;
  });
}

const Verdict& better(const Verdict& a, const Verdict& b) {
  return b.quality > a.quality ? b : a;
}

Verdict window(const View& view) {
  return worstFrame(view, [&](std::size_t i) -> Verdict {
    const Mask& where = unoccluded(view.scene, i);
    if (tooSmall(where)) return {1, gg::say("nothing to see in this frame")};
    return better(within(view, i, where, gg::say("window")),
                  within(view.frames.at(i), plainSum(view.scene, i), where, gg::say("window")));
  });
}

GGRADE_ITEM("figure.picture", window);

const Mask& unoccludedSurfaces(const SceneEvidence& scene) {
  return remembered(&scene, [&] { return surfaces(scene) & unoccluded(scene, 0); });
}

/// Surfaces that mirror. What others reflect is right wherever the Fresnel term is.
const Mask& mirrors(const SceneEvidence& scene) {
  return remembered(&scene, [&] {
    const Image& share = wanted(scene, "uFresnel")->image;
    const Image none(share.width(), share.height(), share.channels());
    return surfaces(scene) & erode(differenceMask(share, none, 1.0f / 255), 1);
  });
}

/// One of the figure's pictures, as the reference's shaders read it, with a name for messages.
struct Wanted {
  const char* sampler;
  std::string name;
  const Mask& (*region)(const SceneEvidence&) = surfaces; ///< where it is looked at
  double nothingLeft = kNothingLeft; ///< the share of wrong pixels at which it is worth nothing
};

/// The composition as a plain sum, of the reference's two pictures; null where it has only one.
const Texture* plainComposition(const SceneEvidence& scene) {
  const auto& sum = remembered(&scene, [&]() -> std::optional<Texture> {
    const Texture* diffuse = wanted(scene, "uDiffuse");
    const Texture* reflection = wanted(scene, "uReflection");
    if (!diffuse || !reflection) return {};
    Texture made = *diffuse;
    for (std::size_t i = 0; i < made.image.values().size(); ++i)
      made.image.values()[i] += reflection->image.values()[i];
    return made;
  });
  return sum ? &*sum : nullptr;
}

/// Those of the pictures that this scene has.
Verdict pictures(const View& view, const std::vector<Wanted>& all) {
  std::vector<Verdict> verdicts;
  for (const auto& [sampler, name, region, nothingLeft] : all) {
    const Texture* right = wanted(view.scene, sampler);
    if (!right) continue;
    const auto any = [](const Texture&) { return true; };
    Verdict verdict = bestMatch(view, *right, region(view.scene), name, any, nothingLeft).verdict;
    const Texture* plain =
        sampler == std::string("uComposition") ? plainComposition(view.scene) : nullptr;
    if (plain)
      verdict = better(verdict, bestMatch(view, *plain, region(view.scene), name, any).verdict);
    verdicts.push_back(verdict);
  }
  return passesOrPicture(together(verdicts), window(view));
}

GGRADE_ITEM("figure.albedo", [](const View& view) {
  // Without depths it is wrong where objects hide each other, which is little of a picture.
  constexpr double kHidden = 0.2;
  return pictures(view, {{"uAlbedo", gg::say("albedo"), surfaces, kHidden}});
});

GGRADE_ITEM("figure.gbuffer", [](const View& view) {
  return pictures(view, {{"uNormals", gg::say("normals")}, {"uIds", gg::say("identifiers")}});
});

GGRADE_PASS("figure.gbuffer", [](const View& view) {
  return outputOfObjects(view, {"uNormals", "uIds", "uAlbedo"});
});

/// Means over squares of 9 x 9 pixels, of the first channel, where `region` is: which points are
/// tested, and in which pixel, is everyone's own.
Image smoothed(const Image& image, const Mask& region) {
  constexpr int kReach = 4;
  const int width = image.width(), height = image.height();
  Image out(width, height, 1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (!region.at(x, y)) continue;
      double sum = 0, count = 0;
      for (int v = std::max(y - kReach, 0); v <= std::min(y + kReach, height - 1); ++v)
        for (int u = std::max(x - kReach, 0); u <= std::min(x + kReach, width - 1); ++u)
          if (region.at(u, v)) sum += double(image.at(u, v, 0)), ++count;
      out.at(x, y) = float(sum / count);
    }
  return out;
}

double rms(const Image& a, const Image& b, const Mask& region) {
  double sum = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (region.at(x, y)) sum += std::pow(double(a.at(x, y)) - double(b.at(x, y)), 2);
  return std::sqrt(sum / double(std::max<std::size_t>(region.count(), 1)));
}

/// How open surfaces are in the reference, and where that can be told.
struct Openness {
  Mask region;
  Image wanted;    // smoothed
  double none = 0; // RMS that an open world is off by
};

Openness openness(const Image& open, const Mask& region) {
  Openness all{region, smoothed(open, region)};
  all.none = rms(Image(open.width(), open.height(), 1, 1), all.wanted, region);
  return all;
}

/// As its texture has it.
const Openness& inTexture(const SceneEvidence& scene) {
  return remembered(&scene,
                    [&] { return openness(wanted(scene, "uOcclusion")->image, surfaces(scene)); });
}

/// How open a window shows each pixel to be, by its light between no diffuse light and all of it.
Image shownOpen(const SceneEvidence& scene, const Image& window, std::size_t frame) {
  const Image none = decoded(scene.probes.at("mirrors only").at(frame));
  const Image all = decoded(scene.probes.at("open").at(frame));
  return visibility(decoded(window), {none, all});
}

/// As the window has it, where diffuse light makes a difference and none of it is cut off.
const Openness& inWindow(const SceneEvidence& scene, std::size_t frame) {
  const Image& window = scene.reference.at(frame);
  return remembered(&window, [&] {
    constexpr float kLeast = 40.0f / 255, kWhite = 0.99f;
    const Image& open = scene.probes.at("open").at(frame);
    Mask region = differenceMask(open, scene.probes.at("mirrors only").at(frame), kLeast);
    for (int y = 0; y < open.height(); ++y)
      for (int x = 0; x < open.width(); ++x)
        if (*std::ranges::max_element(open.pixel(x, y)) > kWhite) region.set(x, y, false);
    return openness(shownOpen(scene, window, frame), erode(region, 1));
  });
}

/// Errors as a share of what no occlusion at all is off by: other points, and nothing of it.
constexpr double kOtherPoints = 0.15, kNoOcclusion = 0.6;

/// How near to the reference a picture of the occlusion is.
Verdict occlusion(const Image& open, const Openness& right, const std::string& where) {
  const double off = rms(smoothed(open, right.region), right.wanted, right.region);
  return {std::clamp((kNoOcclusion - off / right.none) / (kNoOcclusion - kOtherPoints), 0.0, 1.0),
          gg::say("occlusion in {} is off by {:.3f} (RMS); none at all by {:.3f}", where, off,
                  right.none)};
}

Verdict occlusionInTexture(const View& view) {
  Verdict best{0, gg::say("no pass draws it into a texture that a later pass reads")};
  for (const Texture& found : texturesOf(view.trace, view.scene.reference.at(0))) {
    if (found.drawn.ofObjects || findNonFinite(found.image)) continue;
    const Verdict one = occlusion(found.image, inTexture(view.scene), gg::say("a texture"));
    if (one.quality > best.quality) best = one;
  }
  return best;
}

GGRADE_ITEM("figure.occlusion", [](const View& view) {
  const Verdict window = worstFrame(view, [&](std::size_t i) {
    return occlusion(shownOpen(view.scene, view.frames.at(i), i), inWindow(view.scene, i),
                     gg::say("the window"));
  });
  return passesOrPicture(occlusionInTexture(view), window);
});

GGRADE_PASS("figure.occlusion",
            [](const View& view) { return outputOf(view.trace, {"uOcclusion"}); });

/// The diffuse light by what there would be without any occlusion.
Image dimmedBy(const SceneEvidence& scene, const Image& diffuse) {
  const Image &albedo = wanted(scene, "uAlbedo")->image,
              &irradiance = wanted(scene, "uIrradiance")->image;
  Image share(diffuse.width(), diffuse.height(), 1, 1);
  for (int y = 0; y < share.height(); ++y)
    for (int x = 0; x < share.width(); ++x) {
      float light = 0, all = 0;
      for (int c = 0; c < 3; ++c) {
        light += diffuse.at(x, y, c);
        all += albedo.at(x, y, c) * irradiance.at(x, y, c) * std::numbers::inv_pi_v<float>;
      }
      if (all > 0) share.at(x, y) = std::clamp(light / all, 0.0f, 1.0f);
    }
  return share;
}

/// Where it can be told whether diffuse light lacks anything.
const Mask& dimmable(const SceneEvidence& scene) {
  return remembered(&scene, [&] {
    constexpr float kLeast = 0.02f;
    const Image& albedo = wanted(scene, "uAlbedo")->image;
    const Image none(albedo.width(), albedo.height(), albedo.channels());
    return surfaces(scene) & differenceMask(albedo, none, kLeast);
  });
}

/// How much of its light the picture of `open` lacks, on the mean, where that can be told.
double lacking(const Image& open, const Mask& region) {
  double sum = 0;
  for (int y = 0; y < open.height(); ++y)
    for (int x = 0; x < open.width(); ++x)
      if (region.at(x, y)) sum += 1 - double(open.at(x, y));
  return sum / double(std::max<std::size_t>(region.count(), 1));
}

/// How much light one picture of `open` lacks of what the reference's lacks.
Verdict keepsAway(const Image& own, const Image& reference, const Mask& region) {
  constexpr double kHardlyAny = 0.1, kEnough = 0.5;
  const double wanted = lacking(reference, region);
  const double share = wanted > 0 ? std::max(lacking(own, region) / wanted, 0.0) : 1;
  return {
      std::clamp((share - kHardlyAny) / (kEnough - kHardlyAny), 0.0, 1.0),
      gg::say("occlusion keeps away {:.0f}% of what it keeps away in the reference", 100 * share)};
}

/// Does the occlusion that a program has found keep light away, as it does in the reference or more
/// (of the sun's, too)? Who has found none yet is not asked.
Verdict dimmed(const View& view) {
  const Verdict right{1, {}};
  const Texture* light = wanted(view.scene, "uDiffuse");
  if (!light || !wanted(view.scene, "uOcclusion")) return right;
  Verdict best = keepsAway(shownOpen(view.scene, view.frames.at(0), 0),
                           shownOpen(view.scene, view.scene.reference.at(0), 0),
                           inWindow(view.scene, 0).region);
  if (best.quality >= 1) return right;
  const auto any = [](const Texture&) { return true; };
  const Match own = bestMatch(view, *light, unoccludedSurfaces(view.scene), {}, any);
  if (own.texture && own.verdict.quality > 0 && !findNonFinite(own.texture->image))
    best = better(best, keepsAway(dimmedBy(view.scene, own.texture->image),
                                  dimmedBy(view.scene, light->image), dimmable(view.scene)));
  return occlusionInTexture(view).quality < kNearlyAll ? right : best;
}

GGRADE_ITEM("figure.irradiance", [](const View& view) {
  return together({pictures(view, {{"uIrradiance", gg::say("irradiance")},
                                   {"uDiffuse", gg::say("diffuse light"), unoccludedSurfaces}}),
                   dimmed(view)});
});

GGRADE_PASS("figure.irradiance",
            [](const View& view) { return outputOf(view.trace, {"uDiffuse"}); });

GGRADE_ITEM("figure.reflection", [](const View& view) {
  return pictures(view, {{"uReflected", gg::say("reflected directions")},
                         {"uFresnel", gg::say("Fresnel term")},
                         {"uReflection", gg::say("reflection"), mirrors}});
});

// The composition reads the Fresnel term, too.
GGRADE_PASS("figure.reflection", [](const View& view) {
  return outputOf(view.trace, {"uReflection", "uFresnel"});
});

GGRADE_ITEM("figure.composition", [](const View& view) {
  return pictures(view, {{"uComposition", gg::say("composition"), unoccludedSurfaces}});
});

GGRADE_ITEM("figure.keep_state", sameAgain);

GGRADE_ITEM("figure.keep_following", outlinesFollow);

} // namespace
