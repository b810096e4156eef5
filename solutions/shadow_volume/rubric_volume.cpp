// The rubric of shadow_volume: the volume and what was counted of it. Titles and points stand in
// assignment.json.
//
// The volume itself is judged by the picture of it, white (scene key debug.volume). A program that
// shows another volume, or none, is right if what it counted or its shadows in the same scene are.

#include "rubric_shadows.hpp"
#include "words/words.hpp"

#include <algorithm>

using namespace shadow_volume_rubric;

namespace {

/// Less than any lit surface of the scene reaches, and what is left of white after rounding.
constexpr float kWhite = 0.98f;
/// What faces without anything that connects them are worth, and connected ones of which the volume
/// has another shape.
constexpr double kFacesAlone = 0.3, kAnyWalls = 0.5;
/// A volume of which so much beside the object is wrong has another shape.
constexpr double kAnotherShape = 0.3;

Mask white(const Image& image) {
  Mask mask(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      mask.set(x, y, std::min({image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)}) > kWhite);
  return mask;
}

/// The white that is seen in a frame: beside the caster, and on those of its faces that the light
/// shines on.
struct Shown {
  Mask beside, faces;
};

Shown volumeIn(const View& view, const Image& frame) {
  const Regions& regions = regionsOf(view.scene, 0);
  const Mask all = white(frame);
  return {all & ~dilate(regions.caster, 1), all & regions.onCaster};
}

Verdict extruded(const View& view) {
  const Shown found = volumeIn(view, view.frames.at(0));
  const Shown wanted = volumeIn(view, view.scene.reference.at(0));
  const Agreement pixels = agreement(wanted.beside, found.beside, kEdge);
  const Mask wrong = (wanted.beside & ~dilate(found.beside, kEdge)) |
                     (found.beside & ~dilate(wanted.beside, kEdge));
  return {qualityOf(pixels.wrongShare(), kAnotherShape),
          gg::say("beside the object {} pixels must be white; {} of them are not, and {} "
                  "others are{}",
                  pixels.wanted, pixels.missing, pixels.extra, densestAt(densestWindow(wrong)))};
}

Verdict mesh(const View& view) {
  const Shown found = volumeIn(view, view.frames.at(0));
  const Shown wanted = volumeIn(view, view.scene.reference.at(0));
  const double faces = double((found.faces & wanted.faces).count()) /
                       double(std::max<std::size_t>(wanted.faces.count(), 1));
  // How far the rectangles reach is another item's, and so is part of the shape.
  const double beside =
      double(found.beside.count()) / double(std::max<std::size_t>(wanted.beside.count(), 1));
  const double walls = kFacesAlone + (kAnyWalls - kFacesAlone) * std::min(1.0, beside / 0.4) +
                       (1 - kAnyWalls) * extruded(view).quality;
  return {std::clamp((faces - 0.5) / 0.45, 0.0, 1.0) * walls,
          gg::say("{:.0f}% of the faces towards the lamp are white, and beside the object {} "
                  "pixels; {} in the reference",
                  100 * faces, found.beside.count(), wanted.beside.count())};
}

/// Who has what the volume is for has the volume.
Verdict orCountedRightly(const View& view, const Verdict& verdict) {
  const Verdict other = counted(view);
  if (frozen(view)) return other;
  return other.quality >= kNearlyAll && other.quality > verdict.quality ? other : verdict;
}

GGRADE_ITEM("shadow_volume.mesh",
            [](const View& view) { return orCountedRightly(view, mesh(view)); });

GGRADE_ITEM("shadow_volume.extrude",
            [](const View& view) { return orCountedRightly(view, extruded(view)); });

GGRADE_ITEM("shadow_volume.stencil", counted);

GGRADE_ITEM("shadow_volume.far", counted);

GGRADE_ITEM("shadow_volume.inside", counted);

GGRADE_ITEM("shadow_volume.edges", counted);

constexpr std::uint32_t kKeep = 0x1E00; // GL_KEEP

bool counts(const trace::StepRecord& step) {
  return step.stencilTest && std::ranges::any_of(step.stencil, [](const trace::StencilFace& face) {
           return face.depthFail != kKeep || face.depthPass != kKeep;
         });
}

/// Vertices of the volume in the first frame, as if front and back faces were drawn at once.
double volumeVertices(const trace::Trace& trace) {
  double sum = 0;
  if (trace.frames.empty()) return sum;
  for (const trace::PassRecord& pass : trace.passesOf(0))
    for (const trace::StepRecord& step : trace.stepsOf(pass))
      if (counts(step)) sum += double(step.vertices) / (step.cullFace ? 2 : 1);
  return sum;
}

/// Times as many vertices as the reference's at which the bonus is gone. Every edge of a torus knot
/// makes 3.7 times as many.
constexpr double kTooMany = 2.5, kFewEnough = 1.3;

GGRADE_ITEM("shadow_volume.silhouette", [](const View& view) -> Verdict {
  const Verdict shadows = shadowsInWindow(view);
  const double own = volumeVertices(view.trace);
  const double reference = volumeVertices(view.scene.referenceTrace);
  const double few = own > 0 ? (kTooMany - own / reference) / (kTooMany - kFewEnough) : 0;
  const std::string message = gg::say(
      "{:.0f} vertices are drawn into the stencil; {:.0f} in the reference", own, reference);
  if (shadows.quality < kNearlyAll)
    return {0, gg::say("{}; it counts once the shadows are right: {}", message, shadows.message)};
  return {std::clamp(few, 0.0, 1.0), message};
});

} // namespace
