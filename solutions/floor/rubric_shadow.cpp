// The rubric of part "shadow". Titles and points stand in assignment.json.
//
// How much light a pixel of the window gets is measured between two renderings of the reference:
// "unlit" (0) and "unshadowed" (1). So shadows are found whatever their colour. The shadow map is
// judged through a matrix of the submission's own.

#include "rubric/follows.hpp"
#include "rubric/light.hpp"
#include "rubric/measures.hpp"
#include "rubric_passes.hpp"
#include "words/words.hpp"

#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <map>

using namespace floor_rubric;
using namespace ggrade::rubric;

namespace {

/// Pixels that the edge of a shadow may move: maps of other sizes and other biases do.
constexpr int kEdge = 2;
/// Least difference that light makes for a pixel to be told apart from one in shadow.
constexpr float kLeastLight = 10.0f / 255;
/// The same on objects: where they turn away from the light, a constant bias may leave them spotted
/// with what little light there is.
constexpr float kLeastOnObjects = 24.0f / 255;
/// A map may be drawn from this far off the light, as a share of the objects' distance.
constexpr double kOffLight = 0.1;
/// What may lie beyond a plane of the light's view volume, in its half widths: a map of another
/// size has its outermost surfaces elsewhere.
constexpr double kOutside = 0.01;
/// Depth maps that are looked at: each is read through hundreds of matrices.
constexpr int kMostMaps = 8;

const Image& probe(const View& view, const char* name, std::size_t frame) {
  return view.scene.probes.at(name).at(frame);
}

LightRange lightOf(const View& view, std::size_t frame) {
  return {probe(view, "unlit", frame), probe(view, "unshadowed", frame)};
}

/// What a frame of a scene shows where, in the reference.
struct Regions {
  Mask floor, objects; // where light makes a difference, one pixel away from objects' outlines
  Mask shadow;         // of both
  Mask averted;        // where light makes no difference: nobody can tell whether that is in shadow
};

const Regions& regionsOf(const View& view, std::size_t frame) {
  static std::map<std::pair<const SceneEvidence*, std::size_t>, Regions> known;
  auto [entry, fresh] = known.try_emplace({&view.scene, frame});
  Regions& regions = entry->second;
  if (fresh) {
    const LightRange light = lightOf(view, frame);
    const Mask measurable = differenceMask(light.unlit, light.unshadowed, kLeastLight);
    const Mask objects = shown(probe(view, "objects", frame));
    regions.objects =
        erode(objects, 1) & differenceMask(light.unlit, light.unshadowed, kLeastOnObjects);
    const Mask floor = shown(probe(view, "floor", frame));
    regions.averted = (objects | floor) & ~measurable;
    regions.floor = floor & ~dilate(objects, 1) & measurable;
    regions.shadow = below(visibility(view.scene.reference.at(frame), light), 0.5f) &
                     (regions.objects | regions.floor);
  }
  return regions;
}

/// Pixels in shadow in one of the view's frames.
Mask shadowIn(const View& view, std::size_t frame) {
  return below(visibility(view.frames.at(frame), lightOf(view, frame)), 0.5f);
}

Verdict shadowsAgree(const View& view, std::size_t frame, const Mask& region,
                     const std::string& what, double nothingLeft = kNothingLeft) {
  const Regions& regions = regionsOf(view, frame);
  const Mask wanted = regions.shadow & region;
  if (tooSmall(wanted)) return {1, gg::say("nothing to see in this frame")};
  const Mask found = shadowIn(view, frame) & region;
  const Agreement pixels = agreement(wanted, found, kEdge);
  const Mask wrong = (wanted & ~dilate(found, kEdge)) | (found & ~dilate(wanted, kEdge));
  return {qualityOf(pixels.wrongShare(), nothingLeft),
          gg::say("{} pixels of the {} must be in shadow: {:.1f}% of them are lit, {:.1f}% as many "
                  "again are in a shadow that must not be there{}",
                  pixels.wanted, what, 100.0 * double(pixels.missing) / double(pixels.wanted),
                  100.0 * double(pixels.extra) / double(pixels.wanted),
                  densestAt(densestWindow(wrong)))};
}

Verdict floorShadows(const View& view) {
  return worstFrame(view, [&](std::size_t i) {
    return shadowsAgree(view, i, regionsOf(view, i).floor, gg::say("floor"));
  });
}

GGRADE_ITEM("shadow.floor", floorShadows);

GGRADE_ITEM("shadow.objects", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) {
    return shadowsAgree(view, i, regionsOf(view, i).objects, gg::say("objects"));
  });
});

/// Points on the objects that the light sees, and points at its far plane between which and the
/// light nothing but the floor can lie; world space.
struct LightPoints {
  std::vector<glm::dvec4> surface, nothing;
  glm::dvec4 light{0, 0, 0, 1};
};

/// From the reference's own map. Its shaders' names are ours to know.
const LightPoints& lightPoints(const View& view) {
  static std::map<const SceneEvidence*, LightPoints> known;
  auto [entry, fresh] = known.try_emplace(&view.scene);
  LightPoints& points = entry->second;
  if (!fresh) return points;
  const trace::Trace& trace = view.scene.referenceTrace;
  for (const Drawn& drawn : sampledLater(trace)) {
    if (drawn.attachment != trace::kDepth || !drawn.ofObjects) continue;
    glm::dmat4 projection(1), lightView(1);
    for (const trace::MatrixRecord& record : trace.matricesOf(trace.stepsOf(*drawn.pass)[0])) {
      const std::string name = record.name;
      glm::dmat4* to = name == "uProjection" ? &projection : name == "uView" ? &lightView : nullptr;
      if (to)
        for (int i = 0; i < 16; ++i) (*to)[i / 4][i % 4] = double(record.values[i]);
    }
    const glm::dmat4 worldFromClip = glm::inverse(projection * lightView);
    points.light = glm::inverse(lightView)[3];
    const Image map = trace.image(*drawn.copy);
    const int step = std::max(1, map.width() / 64);
    for (int y = step / 2; y < map.height(); y += step)
      for (int x = step / 2; x < map.width(); x += step) {
        const double depth = map.at(x, y);
        const glm::dvec4 clip(2 * (x + 0.5) / map.width() - 1, 1 - 2 * (y + 0.5) / map.height(),
                              2 * depth - 1, 1);
        const glm::dvec4 world = worldFromClip * clip;
        (depth < 1 ? points.surface : points.nothing).push_back(world / world.w);
      }
    break;
  }
  return points;
}

/// Does this matrix look from the light? What the eye or another place sees agrees with itself,
/// too. A perspective has its centre where x, y and w are 0; one without a centre may pass.
bool looksFromLight(const glm::dmat4& mapFromWorld, bool unit, const LightPoints& points) {
  const glm::dvec4 rowOfW(mapFromWorld[0][3], mapFromWorld[1][3], mapFromWorld[2][3], 0);
  if (glm::length(rowOfW) < 1e-9) return true;
  glm::dvec4 at = mapFromWorld * points.light;
  if (unit) at = {at.x - 0.5 * at.w, at.y - 0.5 * at.w, at.z, at.w};
  double distance = 0;
  for (const glm::dvec4& point : points.surface) distance += std::abs((mapFromWorld * point).w);
  distance /= double(std::max<std::size_t>(points.surface.size(), 1));
  return std::max({std::abs(at.x), std::abs(at.y), std::abs(at.w)}) <= kOffLight * distance;
}

/// Share of the light's points that a map agrees with when it is read through `mapFromWorld`, whose
/// result is -1 to 1 or, with `unit`, 0 to 1 already.
double agreementThrough(const Image& map, float background, float range,
                        const glm::dmat4& mapFromWorld, bool unit, const LightPoints& points) {
  if (!looksFromLight(mapFromWorld, unit, points)) return 0;
  std::size_t right = 0, all = 0;
  const auto look = [&](const glm::dvec4& world, bool surface) {
    const glm::dvec4 clip = mapFromWorld * world;
    if (!(clip.w > 0)) {
      all += surface ? 1 : 0;
      return;
    }
    glm::dvec3 at = glm::dvec3(clip) / clip.w;
    if (!unit) at = at * 0.5 + 0.5;
    const double px = at.x * map.width(), py = (1 - at.y) * map.height();
    if (!(px >= 0 && py >= 0 && px < map.width() && py < map.height())) {
      all += surface ? 1 : 0; // what a map doesn't show it can't hide; objects it must show
      return;
    }
    ++all;
    // Texels lie elsewhere in a map of another size: the neighbours' range counts.
    float low = 2, high = -1;
    bool empty = false;
    for (int y = std::max(0, int(py) - 1); y <= std::min(map.height() - 1, int(py) + 1); ++y)
      for (int x = std::max(0, int(px) - 1); x <= std::min(map.width() - 1, int(px) + 1); ++x) {
        const float depth = map.at(x, y);
        low = std::min(low, depth);
        high = std::max(high, depth);
        empty |= depth == background;
      }
    const auto holds = [&](double depth) {
      const double slack = 0.03 * double(range);
      return depth >= double(low) - slack && depth <= double(high) + slack;
    };
    if (surface) {
      right += holds(at.z);
      return;
    }
    if (!empty) { // the floor may have been drawn, too: it hides nothing that anybody sees
      const glm::dvec4 ray = world - points.light;
      const glm::dvec4 floor = mapFromWorld * (points.light - points.light.y / ray.y * ray);
      empty = floor.w > 0 && holds(unit ? floor.z / floor.w : floor.z / floor.w * 0.5 + 0.5);
    }
    right += empty;
  };
  for (const glm::dvec4& world : points.surface) look(world, true);
  const double surface = double(right) / double(std::max<std::size_t>(points.surface.size(), 1));
  right = all = 0;
  for (const glm::dvec4& world : points.nothing) look(world, false);
  const double nothing = all ? double(right) / double(all) : 1;
  return std::min(surface, nothing);
}

/// Share of the surface that lies between the planes of a perspective that looks from the light; 0
/// if the matrix is no such perspective.
double seenThrough(const glm::dmat4& mapFromWorld, bool unit, const LightPoints& points) {
  const glm::dvec3 rowOfW(mapFromWorld[0][3], mapFromWorld[1][3], mapFromWorld[2][3]);
  if (glm::length(rowOfW) < 1e-9 || !looksFromLight(mapFromWorld, unit, points)) return 0;
  std::size_t seen = 0;
  for (const glm::dvec4& world : points.surface) {
    const glm::dvec4 clip = mapFromWorld * world;
    if (!(clip.w > 0)) continue;
    const glm::dvec3 at = glm::dvec3(clip) / clip.w;
    const double low = unit ? 0 : -1;
    seen += glm::all(glm::greaterThanEqual(at, glm::dvec3(low - kOutside))) &&
            glm::all(glm::lessThanEqual(at, glm::dvec3(1 + kOutside)));
  }
  return double(seen) / double(std::max<std::size_t>(points.surface.size(), 1));
}

struct MapVerdict {
  double share = 0;
  double seen = 0;        ///< share of the surface between the planes of the best of its matrices
  bool found = false;     ///< a depth map that a later pass samples
  bool depthOnly = false; ///< its pass drew no colours
  std::uint32_t size = 0;
};

/// The best depth map of the view, through the best of its matrices.
const MapVerdict& bestMap(const View& view) {
  static std::map<const trace::Trace*, MapVerdict> known; // several items ask
  const auto [entry, fresh] = known.try_emplace(&view.trace);
  MapVerdict& best = entry->second;
  if (!fresh) return best;
  const LightPoints& points = lightPoints(view);
  int maps = 0;
  for (const Drawn& drawn : sampledLater(view.trace)) {
    if (drawn.attachment != trace::kDepth || !drawn.ofObjects) continue;
    if (++maps > kMostMaps) break;
    best.found = true;
    const Image map = view.trace.image(*drawn.copy);
    const float background =
        drawn.pass->cleared & (1u << trace::kDepth) ? drawn.pass->clearDepth : 1.0f;
    float low = 2, high = -1;
    for (const float depth : map.values())
      if (depth != background) low = std::min(low, depth), high = std::max(high, depth);
    std::vector<glm::dmat4> matrices;
    for (const trace::StepRecord& step : view.trace.stepsOf(*drawn.pass))
      for (const glm::dmat4& matrix : matricesOf(view.trace, step)) matrices.push_back(matrix);
    // The eye's projection, which the reader has too, is none of the light's.
    std::vector<glm::dmat4> cameras = perspectives(matrices);
    for (const glm::dmat4& matrix : matricesOf(view.trace, *drawn.readingStep)) {
      matrices.push_back(matrix);
      cameras.push_back(matrix);
    }
    for (const glm::dmat4& matrix : cameras)
      for (const bool unit : {false, true})
        best.seen = std::max(best.seen, seenThrough(matrix, unit, points));
    if (low > high) continue; // nothing was drawn
    double share = 0;
    for (const glm::dmat4& matrix : matricesAndProducts(matrices))
      for (const bool unit : {false, true})
        share = std::max(share, agreementThrough(map, background, std::max(high - low, 1e-6f),
                                                 matrix, unit, points));
    bool colors = false;
    for (std::uint32_t a = 0; a < trace::kColors; ++a)
      colors |= drawn.pass->images[a].kind != std::uint32_t(trace::ImageKind::none);
    if (share >= best.share) {
      best.share = share;
      best.depthOnly = !colors;
      best.size = drawn.copy->width;
    }
  }
  return best;
}

GGRADE_ITEM("shadow.camera", [](const View& view) -> Verdict {
  const MapVerdict& map = bestMap(view);
  const double quality = std::clamp((map.seen - 0.75) / 0.23, 0.0, 1.0);
  const std::string message =
      map.seen > 0 ? gg::say("between the planes of a camera at the light lie {:.0f}% of the "
                             "surfaces that the light sees",
                             100 * map.seen)
                   : gg::say("no matrix of the submission looks from the light at the objects");
  const Verdict shadow = floorShadows(view);
  if (shadow.quality <= quality) return {quality, message};
  return {shadow.quality, gg::say("{}; judged by the floor: {}", message, shadow.message)};
});

GGRADE_ITEM("shadow.map", [](const View& view) -> Verdict {
  if (lightPoints(view).surface.size() < 50)
    throw std::runtime_error("the reference's shadow map shows no objects");
  const MapVerdict& map = bestMap(view);
  const double quality = std::clamp((map.share - 0.55) / 0.35, 0.0, 1.0);
  const Verdict shadow = floorShadows(view);
  if (shadow.quality >= quality && quality < 1)
    return {
        shadow.quality,
        map.found
            ? gg::say("no matrix of the submission fits its shadow map; judged by the floor: {}",
                      shadow.message)
            : gg::say("no pass samples a depth texture that objects were drawn into; judged by "
                      "the floor: {}",
                      shadow.message)};
  return {quality, gg::say("the map of {0}x{0} agrees with the objects at {1:.0f}% of the points "
                           "that the light sees",
                           map.size, 100 * map.share)};
});

/// The light's depth map; null if no pass draws objects into one that a later pass samples.
const Drawn* lightMap(const std::vector<Drawn>& all) {
  for (const Drawn& drawn : all)
    if (drawn.attachment == trace::kDepth && drawn.ofObjects) return &drawn;
  return nullptr;
}

/// Does a map agree with the objects when it is read through a matrix of the step that samples the
/// submission's own?
bool readable(const View& view, const Image& map, const trace::StepRecord& reading) {
  float low = 1, high = 0;
  for (const float depth : map.values())
    if (depth < 1) low = std::min(low, depth), high = std::max(high, depth);
  for (const glm::dmat4& matrix : matricesAndProducts(matricesOf(view.trace, reading)))
    for (const bool unit : {false, true})
      if (agreementThrough(map, 1, std::max(high - low, 1e-6f), matrix, unit, lightPoints(view)) >=
          0.9)
        return true;
  return false;
}

GGRADE_PASS("shadow.map", [](const View& view) -> std::vector<PassOutput> {
  const trace::Trace& reference = view.scene.referenceTrace;
  const std::vector<Drawn> own = sampledLater(view.trace), known = sampledLater(reference);
  const Drawn *found = lightMap(own), *wanted = lightMap(known);
  // The reference's map is of no use to a lookup with another matrix.
  if (!found || !wanted || !readable(view, reference.image(*wanted->copy), *found->readingStep))
    return {};
  return {{found->copy->pass, found->attachment}};
});

GGRADE_ITEM("shadow.depth_only", [](const View& view) -> Verdict {
  const double right = floorShadows(view).quality;
  const MapVerdict& map = bestMap(view);
  if (!map.found)
    return {0, gg::say("no pass samples a depth texture that objects were drawn into")};
  if (!map.depthOnly)
    return {0, gg::say("the map's framebuffer object has a colour attachment, too")};
  if (right < 0.5) return {0, gg::say("depths only; it counts once the floor's shadows are right")};
  return {1, gg::say("depths only")};
});

/// Colours where the submission and the reference both have a shadow.
Verdict sharedShadow(const View& view, std::size_t frame) {
  const Regions& regions = regionsOf(view, frame);
  const Mask both = regions.shadow & shadowIn(view, frame);
  const Mask floor = erode(both & regions.floor, 1);
  if (tooSmall(floor))
    return {0, gg::say("the submission and the reference share no shadow on the floor")};
  const Verdict onFloor = within(view, frame, floor, gg::say("colours in the floor's shadow"));
  // Apart, because the objects' shadows are small beside the floor's. Having none is another
  // item's.
  const Mask objects = erode(both & regions.objects, 1);
  if (tooSmall(objects)) return onFloor;
  const Verdict onObjects = within(view, frame, objects, gg::say("colours in the objects' shadow"));
  return onObjects.quality < onFloor.quality ? onObjects : onFloor;
}

/// Where the floor shines in the reference's shadow unless the highlight is taken away as well.
/// There the amount of light tells nothing about what is in shadow: the highlight is most of it.
Verdict highlightTaken(const View& view, std::size_t frame) {
  const Regions& regions = regionsOf(view, frame);
  const Mask shining =
      differenceMask(probe(view, "unshadowed", frame), probe(view, "matt", frame), kLeastLight);
  const Mask region = erode(regions.shadow & regions.floor & shining, kEdge);
  if (tooSmall(region)) return {1, gg::say("nothing to see in this frame")};
  return within(view, frame, region, gg::say("colours where a highlight must be in shadow"));
}

GGRADE_ITEM("shadow.ambient", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) -> Verdict {
    if (view.scene.has("backlit")) return highlightTaken(view, i);
    Verdict verdict = sharedShadow(view, i);
    verdict.quality *= shadowsAgree(view, i, regionsOf(view, i).floor, gg::say("floor")).quality;
    return verdict;
  });
});

GGRADE_ITEM("shadow.outside", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) -> Verdict {
    const Regions& regions = regionsOf(view, i);
    const Mask wanted = regions.shadow & regions.floor;
    const Mask found = shadowIn(view, i) & regions.floor;
    // A low light draws out every difference: only what lies far from all shadows is false.
    const Window densest = densestWindow(found & ~dilate(wanted, 4 * kEdge));
    const Agreement pixels = agreement(wanted, found, kEdge);
    // Lit everywhere is not lit rightly.
    const double there = 1 - double(pixels.missing) / double(pixels.wanted);
    return {qualityOf(densest.share, 0.25) * std::clamp((there - 0.5) / 0.4, 0.0, 1.0),
            gg::say("{:.0f}% of a window of {} pixels away from all shadows are in shadow{}",
                    100 * densest.share, kWindowSide, densestAt(densest))};
  });
});

/// Share of the pixels that no amount of light explains: neither lit, nor in shadow, nor between.
/// Counted over the picture, the floor and the objects; the greatest share counts, because objects
/// are a small part of the picture.
double spoiled(const View& view, std::size_t frame, std::string& where) {
  const Image& image = view.frames.at(frame);
  const Regions& regions = regionsOf(view, frame);
  // The colour of a shadow is another item's.
  const Mask region =
      ~dilate(regions.shadow | (shadowIn(view, frame) & (regions.floor | regions.objects)), kEdge) &
      ~regions.averted;
  const Mask wrong =
      unexplained(image, view.scene.reference.at(frame), lightOf(view, frame), region);
  double share = 0;
  const Mask all(image.width(), image.height(), true);
  for (const auto& [part, name] : {std::pair{&all, gg::say("pixels")},
                                   {&regions.floor, gg::say("floor's pixels")},
                                   {&regions.objects, gg::say("objects' pixels")}}) {
    const Mask judged = region & *part;
    if (tooSmall(judged)) continue;
    const double one = double((wrong & judged).count()) / double(judged.count());
    if (one < share) continue;
    share = one;
    where = gg::say("{:.1f}% of the {} away from shadows differ{}", 100 * share, name,
                    densestAt(densestWindow(wrong)));
  }
  return share;
}

GGRADE_ITEM("shadow.keep_picture", [](const View& view) -> Verdict {
  std::string where;
  const double share = spoiled(view, 0, where);
  return {unharmed(share), where};
});

GGRADE_ITEM("shadow.keep_state", [](const View& view) {
  return laterFrames(view,
                     [&](std::size_t i, std::string& where) { return spoiled(view, i, where); });
});

GGRADE_ITEM("shadow.keep_following", [](const View& view) {
  const Effect shadows = [](const View& of, std::size_t frame) {
    return shadowIn(of, frame) & regionsOf(of, frame).floor;
  };
  return follows(view, shadows, gg::say("shadow"));
});

double rms(const Image& a, const Image& b, const Mask& region) {
  double sum = 0;
  std::size_t count = 1;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (region.at(x, y)) {
        const double d =
            std::clamp(double(a.at(x, y)), 0.0, 1.0) - std::clamp(double(b.at(x, y)), 0.0, 1.0);
        sum += d * d;
        ++count;
      }
  return std::sqrt(sum / double(count));
}

GGRADE_ITEM("shadow.pcf", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) -> Verdict {
    const LightRange light = lightOf(view, i);
    const Image wanted = visibility(view.scene.reference.at(i), light);
    const Mask region = dilate(regionsOf(view, i).shadow, 8) & regionsOf(view, i).floor;
    const double hard = rms(visibility(probe(view, "hard", i), light), wanted, region);
    const double found = rms(visibility(view.frames.at(i), light), wanted, region);
    return {std::clamp((1 - found / hard) / 0.7, 0.0, 1.0),
            gg::say("the soft edge is off by {:.3f} (RMS of the light); a hard one is by {:.3f}",
                    found, hard)};
  });
});

/// What a constant bias gets wrong at grazing light: 8% in the default scene's seed.
constexpr double kNothingOfBias = 0.1;

GGRADE_ITEM("shadow.bias", [](const View& view) {
  return worstFrame(view, [&](std::size_t i) {
    return shadowsAgree(view, i, regionsOf(view, i).floor | regionsOf(view, i).objects,
                        gg::say("floor and the objects"), kNothingOfBias);
  });
});

} // namespace
