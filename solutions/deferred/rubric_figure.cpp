// The rubric of part "figure". Titles and points stand in assignment.json.
//
// Each of the figure's pictures is looked for among the textures of the window's size; the one that
// is most like the reference's counts, whatever the submission calls it. Who has the composition
// right has the pictures right that it is made of.

#include "rubric_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace deferred_rubric;

namespace {

/// Where there is a surface, edges left out.
const Mask& surfaces(const SceneEvidence& scene) {
  static std::map<const SceneEvidence*, Mask> known;
  const auto [entry, fresh] = known.try_emplace(&scene);
  if (fresh) {
    const Image& ids = wanted(scene, "uIds")->image;
    entry->second =
        erode(differenceMask(ids, Image(ids.width(), ids.height(), ids.channels()), 0.5f), 1);
  }
  return entry->second;
}

/// Pixels that no occlusion darkens: how many points are tested, and which, is everyone's own.
Mask unoccluded(const View& view, std::size_t frame) {
  const auto open = view.scene.probes.find("open");
  const Image& reference = view.scene.reference.at(frame);
  if (open == view.scene.probes.end()) return Mask(reference.width(), reference.height(), true);
  return ~dilate(differenceMask(reference, open->second.at(frame), 1.5f / 255), 1);
}

Verdict window(const View& view) {
  return picture(view, [&](std::size_t i) { return unoccluded(view, i); });
}

GGRADE_ITEM("figure.picture", window);

/// One of the figure's pictures, as the reference's shaders read it, with a name for messages.
struct Wanted {
  const char* sampler;
  const char* name;
  bool occluded = false; ///< does occlusion darken it?
};

/// The mean quality of the pictures that this scene has.
Verdict pictures(const View& view, const std::vector<Wanted>& all) {
  double sum = 0, count = 0;
  std::string message;
  for (const auto& [sampler, name, occluded] : all) {
    const Texture* right = wanted(view.scene, sampler);
    if (!right) continue;
    Mask region = surfaces(view.scene);
    if (occluded) region = region & unoccluded(view, 0);
    const Match best = bestMatch(view, *right, region, name, [](const Texture&) { return true; });
    sum += best.quality;
    ++count;
    if (best.quality < 1) message += (message.empty() ? "" : "; ") + best.message;
  }
  if (count == 0) return {1, "this scene has none"};
  return passesOrPicture({sum / count, message.empty() ? "all match" : message}, window(view));
}

GGRADE_ITEM("figure.gbuffer", [](const View& view) {
  return pictures(view, {{"uNormals", "normals"}, {"uIds", "identifiers"}});
});

GGRADE_PASS("figure.gbuffer", [](const View& view) {
  return outputOf(view, {"uNormals", "uIds", "uAlbedo"});
});

GGRADE_ITEM("figure.irradiance", [](const View& view) {
  return pictures(view, {{"uIrradiance", "irradiance"}, {"uDiffuse", "diffuse light", true}});
});

GGRADE_PASS("figure.irradiance", [](const View& view) { return outputOf(view, {"uDiffuse"}); });

/// Means over squares of 9 x 9 pixels, of the first channel, where `region` is.
Image smoothed(const Image& image, const Mask& region) {
  constexpr int kReach = 4;
  const int width = image.width(), height = image.height();
  Image out(width, height, 1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      double sum = 0, count = 0;
      for (int v = std::max(y - kReach, 0); v <= std::min(y + kReach, height - 1); ++v)
        for (int u = std::max(x - kReach, 0); u <= std::min(x + kReach, width - 1); ++u)
          if (region.at(u, v)) sum += double(image.at(u, v, 0)), ++count;
      if (region.at(x, y)) out.at(x, y) = float(sum / count);
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

/// The reference's occlusion, smoothed, and how far off an open world is.
struct Occlusion {
  Image wanted;
  double open = 0; // RMS
};

const Occlusion& occlusionOf(const SceneEvidence& scene) {
  static std::map<const SceneEvidence*, Occlusion> known;
  const auto [entry, fresh] = known.try_emplace(&scene);
  Occlusion& occlusion = entry->second;
  if (fresh) {
    const Mask& region = surfaces(scene);
    occlusion.wanted = smoothed(wanted(scene, "uOcclusion")->image, region);
    occlusion.open = rms(Image(occlusion.wanted.width(), occlusion.wanted.height(), 1, 1),
                         occlusion.wanted, region);
  }
  return occlusion;
}

/// Errors as a share of what no occlusion at all is off by: other points, and nothing of it.
constexpr double kOtherPoints = 0.15, kNoOcclusion = 0.6;

/// Smoothed, because which points are tested is everyone's own.
GGRADE_ITEM("figure.occlusion", [](const View& view) -> Verdict {
  const Occlusion& occlusion = occlusionOf(view.scene);
  const Mask& region = surfaces(view.scene);
  Verdict best{0, "no pass draws it into a texture that a later pass reads"};
  double least = occlusion.open;
  for (const Texture& found : texturesOf(view.trace, view.scene.reference.at(0))) {
    if (drewObjects(*found.drawn.pass) || findNonFinite(found.image)) continue;
    const double off = rms(smoothed(found.image, region), occlusion.wanted, region);
    if (off >= least) continue;
    least = off;
    best = {
        std::clamp((kNoOcclusion - off / occlusion.open) / (kNoOcclusion - kOtherPoints), 0.0, 1.0),
        fmt::format("occlusion is off by {:.3f} (RMS); none at all by {:.3f}", off,
                    occlusion.open)};
  }
  return best;
});

GGRADE_PASS("figure.occlusion", [](const View& view) { return outputOf(view, {"uOcclusion"}); });

GGRADE_ITEM("figure.reflection", [](const View& view) {
  return pictures(view, {{"uReflected", "reflected directions"},
                         {"uFresnel", "Fresnel term"},
                         {"uReflection", "reflection"}});
});

GGRADE_PASS("figure.reflection", [](const View& view) { return outputOf(view, {"uReflection"}); });

GGRADE_ITEM("figure.composition", [](const View& view) {
  return pictures(view, {{"uComposition", "composition", true}});
});

GGRADE_ITEM("figure.keep_state", sameAgain);

} // namespace
