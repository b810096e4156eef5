#include "rubric_shadows.hpp"

#include "words/words.hpp"

#include <algorithm>
#include <map>

namespace shadow_volume_rubric {

namespace {

/// Least difference that light makes for a pixel to be told apart from one in shadow.
constexpr float kLeastLight = 10.0f / 255;
/// The same on the caster: near where a smooth surface turns away from the light, its flat faces
/// have turned already, and a volume may begin before or behind them.
constexpr float kLeastOnCaster = 24.0f / 255;
/// Stencils that are looked at. A right program has two.
constexpr std::size_t kMostStencils = 16;

Verdict agreeOn(const Mask& wanted, const Mask& found, const Mask& place, const std::string& what) {
  const Mask right = wanted & place, seen = found & place;
  Agreement pixels = agreement(right, seen, kEdge);
  // A place with hardly any shadow must not be full of it either.
  pixels.wanted = std::max(pixels.wanted, place.count() / 8);
  const Mask wrong = (right & ~dilate(seen, kEdge)) | (seen & ~dilate(right, kEdge));
  return {qualityOf(pixels.wrongShare()),
          gg::say("{}: {} pixels must be in shadow; {} of them are not, and {} others are{}", what,
                  right.count(), pixels.missing, pixels.extra, densestAt(densestWindow(wrong)))};
}

} // namespace

const Image& probe(const View& view, const char* name, std::size_t frame) {
  return view.scene.probes.at(name).at(frame);
}

LightRange lightOf(const View& view, std::size_t frame) {
  return {probe(view, "unlit", frame), probe(view, "unshadowed", frame)};
}

const Image& wanted(const SceneEvidence& scene, std::size_t frame) {
  const auto shadowed = scene.probes.find("shadowed");
  return (shadowed == scene.probes.end() ? scene.reference : shadowed->second).at(frame);
}

const Regions& regionsOf(const SceneEvidence& scene, std::size_t frame) {
  static std::map<std::pair<const SceneEvidence*, std::size_t>, Regions> known;
  auto [entry, fresh] = known.try_emplace({&scene, frame});
  Regions& regions = entry->second;
  if (fresh) {
    const View view{scene, scene.reference, scene.referenceTrace};
    const LightRange light = lightOf(view, frame);
    const Mask walls = shown(probe(view, "walls", frame));
    regions.caster = shown(probe(view, "caster", frame));
    regions.averted =
        (walls | regions.caster) & ~differenceMask(light.unlit, light.unshadowed, kLeastLight);
    regions.onWalls = walls & ~dilate(regions.caster, 1) & ~regions.averted;
    regions.onCaster =
        erode(regions.caster, 1) & differenceMask(light.unlit, light.unshadowed, kLeastOnCaster);
    regions.shadow =
        below(visibility(wanted(scene, frame), light), 0.5f) & (regions.onWalls | regions.onCaster);
  }
  return regions;
}

Mask shadowIn(const View& view, std::size_t frame) {
  return below(visibility(view.frames.at(frame), lightOf(view, frame)), 0.5f);
}

Verdict agree(const View& view, std::size_t frame, const Mask& found, Where where) {
  if (frozen(view)) return {0, gg::say("the picture stays as it is, although time passes")};
  const Regions& regions = regionsOf(view.scene, frame);
  const Verdict walls =
      agreeOn(regions.shadow, found, regions.onWalls,
              where == Where::window ? gg::say("window, walls") : gg::say("stencil, walls"));
  if (tooSmall(regions.onCaster)) return walls;
  const Verdict caster =
      agreeOn(regions.shadow, found, regions.onCaster,
              where == Where::window ? gg::say("window, caster") : gg::say("stencil, caster"));
  return caster.quality < walls.quality ? caster : walls;
}

Verdict shadowsInWindow(const View& view) {
  return worstFrame(
      view, [&](std::size_t i) { return agree(view, i, shadowIn(view, i), Where::window); });
}

std::vector<Mask> stencils(const trace::Trace& trace) {
  std::vector<Mask> all;
  if (trace.frames.empty()) return all;
  float cleared = 0;
  for (const trace::PassRecord& pass : trace.passesOf(0)) {
    if (pass.cleared >> trace::kStencil & 1) cleared = float(pass.clearStencil);
    const trace::CopyRecord* copy = trace.copyOf(trace.indexOf(pass), trace::kStencil);
    if (!copy || all.size() == kMostStencils) continue;
    const Image values = trace.image(*copy);
    all.push_back(differenceMask(
        values, Image(values.width(), values.height(), values.channels(), cleared), 0.5f));
  }
  return all;
}

Verdict counted(const View& view) {
  Verdict best = shadowsInWindow(view);
  const Mask& place = regionsOf(view.scene, 0).caster;
  bool found = false;
  for (const Mask& stencil : stencils(view.trace)) {
    if (stencil.width() != place.width() || stencil.height() != place.height()) continue;
    const Verdict one = agree(view, 0, stencil, Where::stencil);
    // Where both are wrong, the stencil's message says more.
    if (!found || one.quality > best.quality)
      best = {std::max(one.quality, best.quality), one.message};
    found = true;
  }
  return best;
}

} // namespace shadow_volume_rubric
