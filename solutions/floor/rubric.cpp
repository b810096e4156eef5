// The rubric of the reflecting floor, part "mirror". Titles and points stand in assignment.json.
//
// Where things are is learned from probes (scenes.json): the reference in scenes that show the
// floor, the objects or their reflections alone, in flat colours. Nothing here knows how a student
// has drawn the reflection; only what the window shows counts.

#include "rubric/follows.hpp"
#include "rubric/measures.hpp"
#include "rubric_passes.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

using namespace floor_rubric;
using namespace ggrade::rubric;

namespace {

/// Share of the densest window that may show a wrong object before nothing is left of the item.
constexpr double kWrongObject = 0.1;
/// Pixels from where two objects meet within which it shows which one is in front.
constexpr int kMeetingReach = 10;
/// And pixels there in which a coarser texture than ours mixes the two.
constexpr int kMeetingEdge = 1;

/// What a frame of a scene shows where.
struct Regions {
  Mask objects;    // seen directly
  Mask floor;      // not hidden by objects
  Mask reflection; // of objects, on the visible floor
  Mask meeting;    // of the reflection, near places where two objects meet: one hides the other
  Mask clipped;    // where clipping at the floor makes a difference
  Image sky;       // the floor that reflects the background but no object
  Mask covered;    // the floor's pixels where the reference shows a reflected object
  Mask away;       // neither reflection nor clipping changes anything here
};

/// Pixels beside which another object is seen: edges between two flat colours, neither of them
/// black.
Mask meetings(const Image& probe) {
  const Mask any = shown(probe);
  Mask found(probe.width(), probe.height());
  const auto differ = [&](int x, int y, int u, int v) {
    if (!any.at(x, y) || !any.at(u, v)) return false;
    for (int c = 0; c < 3; ++c)
      if (std::abs(probe.at(x, y, c) - probe.at(u, v, c)) > 0.05f) return true;
    return false;
  };
  for (int y = 0; y + 1 < probe.height(); ++y)
    for (int x = 0; x + 1 < probe.width(); ++x)
      if (differ(x, y, x + 1, y) || differ(x, y, x, y + 1)) found.set(x, y);
  return found;
}

/// Share of the light that the floor reflects, by channel.
std::array<float, 3> reflectance(const SceneEvidence& scene) {
  return scene.scene.at("materials").at("floor").at("specular").get<std::array<float, 3>>();
}

/// The scene without reflection, with the background's reflection added everywhere.
Image withSky(const SceneEvidence& scene, const Image& plain) {
  const std::array<float, 3> specular = reflectance(scene);
  const auto background = scene.scene.at("background").get<std::array<float, 3>>();
  Image image = plain;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; c < 3; ++c)
        image.at(x, y, c) = std::min(1.0f, image.at(x, y, c) + specular[std::size_t(c)] *
                                                                   background[std::size_t(c)]);
  return image;
}

/// Of the floor away from reflections, what must fit a brightness for it to be the floor's.
constexpr double kOfOneBrightness = 0.8;
/// What a reflection must have of the reference's contrast to be told from the floor's own shades.
constexpr double kLeastContrast = 0.3;

/// A floor in which no objects are reflected.
struct BareFloor {
  Image picture;      ///< empty: no such floor is shown
  float contrast = 1; ///< of its reflection, as a share of the reference's, at most 1
};

/// The floor without reflected objects, as dark or bright as the frame shows it where none are:
/// factor * plain + offset, least squares by channel. Brightness is other items' business.
BareFloor floorOfItsOwn(const Regions& regions, const Image& plain, const Image& image) {
  Image own = plain;
  for (int c = 0; c < 3; ++c) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (int v = 0; v < image.height(); ++v)
      for (int u = 0; u < image.width(); ++u) {
        const double bare = double(plain.at(u, v, c)), seen = double(image.at(u, v, c));
        if (!regions.away.at(u, v) || !regions.floor.at(u, v) || seen > 0.99) continue; // cut off
        n += 1, x += bare, y += seen, xx += bare * bare, xy += bare * seen;
      }
    const double spread = n * xx - x * x;
    if (n < 1 || spread < 1e-6 * n * n) return {};
    const double factor = (n * xy - x * y) / spread, offset = (y - factor * x) / n;
    if (factor < 0.1) return {}; // one colour
    for (int v = 0; v < own.height(); ++v)
      for (int u = 0; u < own.width(); ++u)
        own.at(u, v, c) = float(std::clamp(factor * double(plain.at(u, v, c)) + offset, 0.0, 1.0));
  }
  const Mask floor = regions.away & regions.floor;
  double added = 0, wanted = 0;
  for (int v = 0; v < own.height(); ++v)
    for (int u = 0; u < own.width(); ++u)
      if (floor.at(u, v))
        for (int c = 0; c < 3; ++c) {
          added += double(own.at(u, v, c) - plain.at(u, v, c));
          wanted += double(regions.sky.at(u, v, c) - plain.at(u, v, c));
        }
  // A black background adds nothing to tell it by.
  const float contrast = wanted > 0.003 * double(floor.count())
                             ? float(std::clamp(added / wanted, kLeastContrast, 1.0))
                             : 1.0f;
  const Mask unlike = differenceMask(image, own, contrast * 2 * tolerances().tolerance) & floor;
  if (double(unlike.count()) > (1 - kOfOneBrightness) * double(floor.count())) return {};
  return {own, contrast};
}

/// Where on the floor a frame shows reflected objects: it looks neither like the bare floor nor
/// like the floor that reflects the background.
///   contrast: a share of the tolerated difference
Mask reflectedObjects(const Regions& regions, const Image& plain, const Image& image,
                      float contrast = 1) {
  const float tolerated = contrast * 2 * tolerances().tolerance;
  return differenceMask(image, plain, tolerated) & differenceMask(image, regions.sky, tolerated) &
         regions.floor;
}

const Regions& regionsOf(const SceneEvidence& scene, std::size_t frame) {
  static std::map<std::pair<const SceneEvidence*, std::size_t>, Regions> known;
  auto [entry, fresh] = known.try_emplace({&scene, frame});
  Regions& regions = entry->second;
  if (fresh) {
    const Image& reflections = scene.probes.at("reflections").at(frame);
    regions.objects = shown(scene.probes.at("objects").at(frame));
    // One pixel away from the objects, so that a shifted edge of an object is not the floor's
    // fault.
    const Mask near = dilate(regions.objects, 1);
    regions.floor = shown(scene.probes.at("floor").at(frame)) & ~near;
    regions.reflection = shown(reflections) & regions.floor;
    const Mask edges = meetings(reflections);
    regions.meeting =
        dilate(edges, kMeetingReach) & ~dilate(edges, kMeetingEdge) & regions.reflection;
    regions.clipped = Mask(reflections.width(), reflections.height());
    if (const auto unclipped = scene.probes.find("unclipped"); unclipped != scene.probes.end())
      regions.clipped = regions.floor & differenceMask(scene.reference.at(frame),
                                                       unclipped->second.at(frame), 0.5f / 255);
    const Image& plain = scene.probes.at("plain").at(frame);
    regions.sky = withSky(scene, plain);
    regions.covered = reflectedObjects(regions, plain, scene.reference.at(frame));
    regions.away = ~dilate(regions.reflection | regions.clipped, 2);
  }
  return regions;
}

/// The same of a submission's frame, whose floor may have another brightness.
Mask reflectedIn(const View& view, std::size_t frame) {
  const Regions& regions = regionsOf(view.scene, frame);
  const Image &plain = view.scene.probes.at("plain").at(frame), &image = view.frames.at(frame);
  const BareFloor own = floorOfItsOwn(regions, plain, image);
  if (own.picture.empty()) return reflectedObjects(regions, plain, image);
  return reflectedObjects(regions, plain, image, own.contrast) &
         differenceMask(image, own.picture, own.contrast * 2 * tolerances().tolerance);
}

struct Coverage {
  double quality = 0;
  Agreement pixels;
};

/// How well the places with reflected objects agree; an edge may move by one pixel.
const Coverage& coverage(const View& view, std::size_t frame) {
  static std::map<const Image*, Coverage> known; // several items ask
  auto [entry, fresh] = known.try_emplace(&view.frames.at(frame));
  Coverage& result = entry->second;
  if (!fresh) return result;
  const Regions& regions = regionsOf(view.scene, frame);
  result.pixels = agreement(regions.covered, reflectedIn(view, frame), 1);
  result.quality = qualityOf(result.pixels.wrongShare());
  return result;
}

GGRADE_ITEM("mirror.where", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) -> Verdict {
    const Coverage& cover = coverage(view, i);
    return {cover.quality,
            gg::say("reflected objects cover {} pixels: {:.1f}% of them lack the reflection, "
                    "{:.1f}% as many again have one that must not be there",
                    cover.pixels.wanted,
                    100.0 * double(cover.pixels.missing) / double(cover.pixels.wanted),
                    100.0 * double(cover.pixels.extra) / double(cover.pixels.wanted))};
  });
});

GGRADE_ITEM("mirror.shading", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) {
    return within(view, i, erode(regionsOf(view.scene, i).reflection, 1),
                  gg::say("reflection's colours"));
  });
});

/// The textures that objects were drawn into and a later pass samples.
std::vector<Drawn> objectTextures(const trace::Trace& trace) {
  std::vector<Drawn> all = sampledLater(trace);
  std::erase_if(all, [](const Drawn& drawn) {
    return drawn.attachment >= trace::kColors || !drawn.ofObjects;
  });
  return all;
}

/// The reference's reflection texture at the window's size, RGB, and the background that it starts
/// from.
struct WantedTexture {
  Image picture, background;
  Mask objects;
};

const WantedTexture& wantedTexture(const SceneEvidence& scene) {
  static std::map<const SceneEvidence*, WantedTexture> known;
  const auto [entry, fresh] = known.try_emplace(&scene);
  WantedTexture& wanted = entry->second;
  if (fresh) {
    const std::vector<Drawn> textures = objectTextures(scene.referenceTrace);
    if (textures.size() != 1) throw std::runtime_error("the reference has no reflection texture");
    const int width = scene.reference.at(0).width(), height = scene.reference.at(0).height();
    const Image texture = scene.referenceTrace.image(*textures[0].copy);
    wanted.picture = resampled(texture, width, height, 3); // alpha goes
    const auto colour = scene.scene.at("background").get<std::array<float, 3>>();
    wanted.background = Image(width, height, 3);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        std::ranges::copy(colour, wanted.background.pixel(x, y).begin());
    wanted.objects = differenceMask(wanted.picture, wanted.background, 2 * tolerances().tolerance);
  }
  return wanted;
}

/// How right a texture is that mirrored objects were drawn into, of any size, in the first frame.
double textureQuality(const Image& found, const WantedTexture& wanted, std::string& message) {
  const Image a = resampled(found, wanted.picture.width(), wanted.picture.height(), 3);
  const Mask region =
      dilate(wanted.objects | differenceMask(a, wanted.background, 2 * tolerances().tolerance), 1);
  CompareOptions options;
  options.mask = &region;
  const Comparison comparison = compare(a, wanted.picture, options);
  const double share =
      double(comparison.wrongPixels) / double(std::max<std::size_t>(wanted.objects.count(), 1));
  message =
      gg::say("reflection texture of {}: {:.1f}% as many pixels as it has of objects differ{}",
              found.sizeText(), 100 * share, densestAt(comparison.densest));
  return comparison.compared() ? qualityOf(share) : 0;
}

/// Is anything drawn or copied into what isn't the window? If that can't be told: yes.
bool leavesTheWindow(const trace::Trace& trace) {
  return trace.passesLost > 0 || trace.stepsLost > 0 ||
         std::ranges::any_of(trace.passes, [&](const trace::PassRecord& pass) {
           return pass.kind != std::uint32_t(trace::PassKind::draw) ||
                  (pass.framebuffer != 0 && trace.drewObjects(pass));
         });
}

/// A reflection that is made in another way is right if the floor is, all of it; but not one
/// without any texture, which is what the handout asks for.
Verdict orTheFloor(const View& view, const Verdict& best) {
  if (best.quality >= 1 || !leavesTheWindow(view.trace)) return best;
  const Mask& floor = regionsOf(view.scene, 0).floor;
  CompareOptions options;
  options.mask = &floor;
  const Comparison comparison = compare(view.frames.at(0), view.scene.reference.at(0), options);
  const std::size_t objects = regionsOf(view.scene, 0).reflection.count();
  const double share = double(comparison.wrongPixels) / double(std::max<std::size_t>(objects, 1));
  const double quality = comparison.compared() ? qualityOf(share) : 0;
  if (quality <= best.quality) return best;
  return {quality, gg::say("{}; but the floor counts: {:.1f}% as many of its "
                           "pixels differ as reflect objects{}",
                           best.message, 100 * share, densestAt(comparison.densest))};
}

/// Does a pass draw all of its texture, and nothing of the frame before?
Verdict fillsTexture(const trace::PassRecord& pass, std::uint32_t attachment) {
  const trace::ImageRef& image = pass.images[attachment];
  const std::int32_t* port = pass.viewport;
  if (port[0] != 0 || port[1] != 0 || port[2] != std::int32_t(image.width) ||
      port[3] != std::int32_t(image.height))
    return {0, gg::say("drawn with a viewport of {}x{} at ({},{}) into a texture of {}x{}", port[2],
                       port[3], port[0], port[1], image.width, image.height)};
  if (!(pass.cleared & (1u << attachment)))
    return {0, gg::say("the texture's colours are not cleared")};
  const bool hasDepth = pass.images[trace::kDepth].kind != std::uint32_t(trace::ImageKind::none);
  if (hasDepth && !(pass.cleared & (1u << trace::kDepth)))
    return {0, gg::say("the framebuffer object's depths are not cleared")};
  return {1,
          gg::say("all of the texture of {}x{} is cleared and drawn", image.width, image.height)};
}

Verdict noTexture() {
  return {0, gg::say("no pass samples a texture that objects were drawn into")};
}

GGRADE_ITEM("mirror.target", [](const View& view) {
  Verdict best = noTexture();
  for (const Drawn& drawn : objectTextures(view.trace)) {
    const Verdict verdict = fillsTexture(*drawn.pass, drawn.attachment);
    if (verdict.quality >= best.quality) best = verdict;
  }
  return orTheFloor(view, best);
});

GGRADE_ITEM("mirror.texture", [](const View& view) {
  const WantedTexture& wanted = wantedTexture(view.scene);
  Verdict best = noTexture();
  for (const Drawn& drawn : objectTextures(view.trace)) {
    std::string message;
    const double quality = textureQuality(view.trace.image(*drawn.copy), wanted, message);
    if (quality >= best.quality) best = {quality, message};
  }
  return orTheFloor(view, best);
});

GGRADE_PASS("mirror.texture", [](const View& view) -> std::vector<PassOutput> {
  // The first one: a reflection is drawn before what shows it.
  const std::vector<Drawn> textures = objectTextures(view.trace);
  if (textures.empty()) return {};
  return {{textures[0].copy->pass, textures[0].attachment}};
});

using Colour = std::array<float, 3>;

/// Cosine of the angle between two colours: 1 for the same hue, however bright. 0 if one is black.
float sameHue(const Colour& a, const Colour& b) {
  const auto dot = [](const Colour& u, const Colour& v) {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  };
  const float size = dot(a, a) * dot(b, b);
  return size > 1e-6f ? dot(a, b) / std::sqrt(size) : 0;
}

Colour colourAt(const Image& image, int x, int y) {
  return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

/// The light that the reflection adds to the floor at a pixel.
Colour added(const Image& image, const Image& plain, int x, int y) {
  return {image.at(x, y, 0) - plain.at(x, y, 0), image.at(x, y, 1) - plain.at(x, y, 1),
          image.at(x, y, 2) - plain.at(x, y, 2)};
}

/// Two colours within 8 degrees are the same object's.
const float kOneObject = std::cos(8 * 3.14159265f / 180);

/// The reflection's pixels where a frame adds light of the hue of the object that is reflected
/// there.
Mask rightHue(const View& view, std::size_t frame, const Image& image) {
  const Image& plain = view.scene.probes.at("plain").at(frame);
  const Image& flat = view.scene.probes.at("reflections").at(frame);
  const Mask region = erode(regionsOf(view.scene, frame).reflection, 1);
  Mask right(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (region.at(x, y) && sameHue(added(image, plain, x, y), colourAt(flat, x, y)) > kOneObject)
        right.set(x, y);
  return right;
}

/// Highlights are white in the reference, too: what it reaches is what can be had.
const Mask& reachable(const View& view, std::size_t frame) {
  static std::map<std::pair<const SceneEvidence*, std::size_t>, Mask> known;
  const auto [entry, fresh] = known.try_emplace({&view.scene, frame});
  if (fresh) entry->second = rightHue(view, frame, view.scene.reference.at(frame));
  return entry->second;
}

/// The flat colours of a probe, one an object.
std::set<Colour> palette(const Image& probe, const Mask& region) {
  std::set<Colour> colours;
  for (int y = 0; y < probe.height(); ++y)
    for (int x = 0; x < probe.width(); ++x)
      if (region.at(x, y)) colours.insert(colourAt(probe, x, y));
  return colours;
}

/// Pixels of `region` where a frame shows another object than the one that belongs there, or none.
/// A highlight whitens the hue, and bad lighting darkens it: neither makes it another object's.
Mask wrongObject(const View& view, std::size_t frame, const Mask& region) {
  const Image& image = view.frames.at(frame);
  const Image& plain = view.scene.probes.at("plain").at(frame);
  const Image& flat = view.scene.probes.at("reflections").at(frame);
  const std::set<Colour> colours = palette(flat, region);
  Mask wrong(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (!region.at(x, y)) continue;
      const Colour light = added(image, plain, x, y);
      const float right = sameHue(light, colourAt(flat, x, y));
      const bool none = right == 0;
      const bool other = right < kOneObject &&
                         std::any_of(colours.begin(), colours.end(), [&](const Colour& colour) {
                           return sameHue(light, colour) > std::max(kOneObject, right);
                         });
      if (none || other) wrong.set(x, y);
    }
  }
  return wrong;
}

GGRADE_ITEM("mirror.position", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) -> Verdict {
    const Mask& wanted = reachable(view, i);
    const std::size_t right = (rightHue(view, i, view.frames.at(i)) & wanted).count();
    const double share = double(right) / double(std::max<std::size_t>(wanted.count(), 1));
    return {std::clamp((share - 0.5) / 0.45, 0.0, 1.0),
            gg::say("{:.0f}% of the reflection shows the colour of the object that belongs there",
                    100 * share)};
  });
});

GGRADE_ITEM("mirror.hidden", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) -> Verdict {
    const Mask region = reachable(view, i) & regionsOf(view.scene, i).meeting;
    if (tooSmall(region)) return {1, gg::say("nothing to see in this frame")};
    const Mask wrong = wrongObject(view, i, region);
    // The densest window: a hidden object may be small in a large picture.
    const Window densest = densestWindow(wrong);
    // Nothing is hidden rightly by a reflection that isn't there.
    const double quality = qualityOf(densest.share, kWrongObject) * coverage(view, i).quality;
    return {
        quality,
        gg::say("where two objects meet, {} of {} pixels show another object than the nearest{}",
                wrong.count(), region.count(), densestAt(densest))};
  });
});

GGRADE_ITEM("mirror.clip", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) -> Verdict {
    const Mask& region = regionsOf(view.scene, i).clipped;
    if (tooSmall(region)) return {1, gg::say("nothing to see in this frame")};
    Verdict verdict = within(view, i, region, gg::say("where a sunken object must be cut off"));
    verdict.quality *= coverage(view, i).quality;
    return verdict;
  });
});

/// Floor that shows its own light and, at most, as much more as it can reflect: whatever else is
/// wrong with the reflection there, the floor is not spoiled.
Mask floorWithAnyReflection(const View& view, std::size_t frame) {
  const Image& image = view.frames.at(frame);
  const Image& plain = view.scene.probes.at("plain").at(frame);
  const Mask& floor = regionsOf(view.scene, frame).floor;
  const std::array<float, 3> specular = reflectance(view.scene);
  Mask explained(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      bool all = floor.at(x, y);
      for (int c = 0; c < 3 && all; ++c) {
        const float added = image.at(x, y, c) - plain.at(x, y, c);
        all = added >= -kTolerance && added <= specular[std::size_t(c)] + kTolerance;
      }
      if (all) explained.set(x, y);
    }
  return explained;
}

/// Share of the pixels away from the reflection that look neither like the reference nor like the
/// scene with any reflection or none.
double spoiled(const View& view, std::size_t frame, std::string& where) {
  const Mask& region = regionsOf(view.scene, frame).away;
  CompareOptions options;
  options.mask = &region;
  const Comparison full = compare(view.frames.at(frame), view.scene.reference.at(frame), options);
  const Comparison bare =
      compare(view.frames.at(frame), view.scene.probes.at("plain").at(frame), options);
  const Mask wrong = full.compared() && bare.compared()
                         ? full.wrong & bare.wrong & ~floorWithAnyReflection(view, frame)
                         : region;
  const Window densest = densestWindow(wrong);
  const double share = double(wrong.count()) / double(std::max<std::size_t>(region.count(), 1));
  where = gg::say("{:.1f}% of the pixels away from the reflection differ{}", 100 * share,
                  densestAt(densest));
  return share;
}

GGRADE_ITEM("mirror.keep_picture", [](const View& view) -> Verdict {
  std::string where;
  const double share = spoiled(view, 0, where);
  return {unharmed(share), where};
});

GGRADE_ITEM("mirror.keep_state", [](const View& view) {
  return laterFrames(view,
                     [&](std::size_t i, std::string& where) { return spoiled(view, i, where); });
});

GGRADE_ITEM("mirror.keep_following", [](const View& view) {
  const Effect reflections = [](const View& of, std::size_t frame) {
    if (&of.frames == &of.scene.reference) return regionsOf(of.scene, frame).covered;
    return reflectedIn(of, frame);
  };
  return follows(view, reflections, gg::say("reflection"));
});

} // namespace
