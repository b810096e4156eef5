#include "check/frustum.hpp"

#include "words/words.hpp"

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ggrade::check {

using gg::say;

namespace {

/// Points that the reference's texels give, along a side.
constexpr int kSide = 64;
/// Of the points; what rounding and another look at an edge may lose.
constexpr double kLost = 0.01;
/// Times the reference's extent: what a frustum may be larger, across and in depth. Wide and round
/// numbers (near 0.1, far 20 where 2 and 5 would do: 25 times) cost little; near 0 costs all.
constexpr double kMuchWider = 30, kMuchDeeper = 500;

/// The first pass of a frame that draws depths alone.
const trace::PassRecord* depthPass(const trace::Trace& trace) {
  if (trace.frames.empty()) return nullptr;
  for (const trace::PassRecord& pass : trace.passesOf(0)) {
    const auto has = [&](std::uint32_t attachment) {
      return pass.images[attachment].kind != std::uint32_t(trace::ImageKind::none);
    };
    bool colors = false;
    for (std::uint32_t i = 0; i < trace::kColors; ++i) colors = colors || has(i);
    if (pass.kind == std::uint32_t(trace::PassKind::draw) && pass.framebuffer != 0 &&
        pass.draws > 0 && has(trace::kDepth) && !colors)
      return &pass;
  }
  return nullptr;
}

/// The first of that name that a step used; null if there is none.
const trace::MatrixRecord* matrixOf(const trace::Trace& trace, const trace::StepRecord& step,
                                    const std::string& name) {
  const auto records = trace.matricesOf(step);
  const auto record =
      std::ranges::find_if(records, [&](const auto& one) { return name == one.name; });
  return record == records.end() ? nullptr : &*record;
}

/// The first step that draws; null if none does.
const trace::StepRecord* drawingStep(const trace::Trace& trace, const trace::PassRecord& pass) {
  const auto steps = trace.stepsOf(pass);
  const auto drawn = std::ranges::find_if(steps, [](const auto& step) { return step.draws > 0; });
  return drawn == steps.end() ? nullptr : &*drawn;
}

/// Clip space from world space; nothing where a matrix is missing.
std::optional<glm::dmat4> clipFromWorld(const Frustum& frustum, const trace::Trace& trace,
                                        const trace::PassRecord& pass) {
  glm::dmat4 product(1);
  const trace::StepRecord* step = drawingStep(trace, pass);
  if (!step) return {};
  for (const std::string& name : frustum.matrices) {
    const trace::MatrixRecord* record = matrixOf(trace, *step, name);
    if (!record) return {};
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = double(record->values[i]);
    product *= matrix;
  }
  return product;
}

/// Does the pass draw with a matrix that a later one of the frame has under the same name, such as
/// the eye's view? Then it was given the wrong one, and nothing is known of its own.
bool takesAnothers(const Frustum& frustum, const trace::Trace& trace,
                   const trace::PassRecord& pass) {
  const trace::StepRecord& own = *drawingStep(trace, pass);
  const auto passes = trace.passesOf(0);
  return std::any_of(
      passes.begin() + (&pass - passes.data()) + 1, passes.end(), [&](const auto& later) {
        const trace::StepRecord* step = drawingStep(trace, later);
        return step && std::ranges::any_of(frustum.matrices, [&](const std::string& name) {
                 const trace::MatrixRecord *a = matrixOf(trace, own, name),
                                           *b = matrixOf(trace, *step, name);
                 return b && std::ranges::equal(a->values, b->values);
               });
      });
}

/// Of the points: how many lie where, and the part of each axis that those in front take.
struct Spread {
  double behind = 0, near = 0, far = 0, beside = 0; ///< shares
  std::array<double, 3> extent{};                   ///< 0 to 1 where all lie inside
  bool isReversed = false; ///< does the farthest one have a smaller depth than the nearest one?
};

Spread spreadOf(const Frustum& frustum, const glm::dmat4& matrix) {
  Spread spread;
  glm::dvec3 low(1e30), high(-1e30);
  double nearest = 1e300, farthest = -1e300, least = 0, most = 0; // distances, and their depths
  const double one = 1 / double(std::max<std::size_t>(frustum.points.size(), 1));
  for (const auto& [x, y, z] : frustum.points) {
    const glm::dvec4 clip = matrix * glm::dvec4(x, y, z, 1);
    if (!(clip.w > 0)) {
      spread.behind += one;
      continue;
    }
    const glm::dvec3 at = glm::dvec3(clip) / clip.w;
    if (clip.w < nearest) nearest = clip.w, least = at.z;
    if (clip.w > farthest) farthest = clip.w, most = at.z;
    low = glm::min(low, at);
    high = glm::max(high, at);
    if (at.z < -1)
      spread.near += one;
    else if (at.z > 1)
      spread.far += one;
    else if (std::max(std::abs(at.x), std::abs(at.y)) > 1)
      spread.beside += one;
  }
  spread.isReversed = farthest > nearest && most < least;
  for (int axis = 0; axis < 3; ++axis)
    spread.extent[std::size_t(axis)] = std::max(0.0, (high[axis] - low[axis]) / 2);
  return spread;
}

} // namespace

bool takePoints(Frustum& frustum, const trace::Trace& reference) {
  const trace::PassRecord* pass = depthPass(reference);
  if (!pass) return false;
  const auto matrix = clipFromWorld(frustum, reference, *pass);
  const auto copy = std::ranges::find_if(reference.copies, [&](const trace::CopyRecord& one) {
    return &reference.passes.at(one.pass) == pass && one.attachment == trace::kDepth &&
           one.step == trace::kNone;
  });
  if (!matrix || copy == reference.copies.end()) return false;
  const glm::dmat4 worldFromClip = glm::inverse(*matrix);
  const Image map = reference.image(*copy);
  const int step = std::max(1, map.width() / kSide);
  for (int y = step / 2; y < map.height(); y += step)
    for (int x = step / 2; x < map.width(); x += step) {
      const double depth = double(map.at(x, y));
      if (!(depth < 1)) continue;
      const glm::dvec4 world =
          worldFromClip * glm::dvec4(2 * (x + 0.5) / map.width() - 1,
                                     1 - 2 * (y + 0.5) / map.height(), 2 * depth - 1, 1);
      frustum.points.push_back({world.x / world.w, world.y / world.w, world.z / world.w});
    }
  frustum.extent = spreadOf(frustum, *matrix).extent;
  return !frustum.points.empty();
}

std::string frustumFault(const Frustum& frustum, const trace::Trace& trace) {
  const trace::PassRecord* pass = frustum.points.empty() ? nullptr : depthPass(trace);
  const auto matrix = pass ? clipFromWorld(frustum, trace, *pass) : std::nullopt;
  if (!matrix || takesAnothers(frustum, trace, *pass)) return {};
  for (int i = 0; i < 16; ++i)
    if (!std::isfinite((*matrix)[i / 4][i % 4]))
      return say(
          "the matrices that depths are drawn with hold NaN or infinity: is there a division "
          "by zero, a normalized zero, or a field of view, near or far plane that is 0?");
  const Spread spread = spreadOf(frustum, *matrix);
  const auto percent = [](double share) { return int(std::lround(share * 100)); };
  const double most = std::max({spread.behind, spread.near, spread.far, spread.beside});
  if (most > kLost) {
    if (most == spread.behind)
      return say(
          "about {}% of what the light should see lies behind the camera that depths are drawn "
          "with: does it look the other way (a camera looks along -z of its own space), or "
          "are these not the light's matrices?",
          percent(most));
    if (spread.isReversed)
      return say(
          "what is farther from the light gets a smaller depth: is the near plane's distance "
          "greater than the far one's, or the sign of z another one than a camera's?");
    if (most == spread.near)
      return say("about {}% of what the light should see lies nearer than its near plane, by "
                 "the matrices that it is drawn with",
                 percent(most));
    if (most == spread.far)
      return say("about {}% of what the light should see lies beyond its far plane, by the "
                 "matrices that it is drawn with",
                 percent(most));
    return say("about {}% of what the light should see lies beside its frustum: does that hold all "
               "corners "
               "of the box?",
               percent(most));
  }
  if (!(spread.extent[2] * kMuchDeeper > frustum.extent[2]))
    return say("all that the light should see lies within {:.2g}% of the depths from near to far "
               "({:.2g}% in the reference): is the near plane too near, or the far one too far? "
               "Both are distances from the light, above 0",
               spread.extent[2] * 100, frustum.extent[2] * 100);
  for (const std::size_t axis : {0, 1})
    if (!(spread.extent[axis] * kMuchWider > frustum.extent[axis]))
      return say("all that the light should see fills {:.2g}% of its map's {} ({:.2g}% in the "
                 "reference): is the frustum as narrow as it can be?",
                 spread.extent[axis] * 100, axis == 0 ? say("width") : say("height"),
                 frustum.extent[axis] * 100);
  return {};
}

void to_json(nlohmann::json& json, const Frustum& frustum) {
  json = {{"todo", frustum.todo},
          {"matrices", frustum.matrices},
          {"points", frustum.points},
          {"extent", frustum.extent}};
}

void from_json(const nlohmann::json& json, Frustum& frustum) {
  json.at("todo").get_to(frustum.todo);
  json.at("matrices").get_to(frustum.matrices);
  json.at("points").get_to(frustum.points);
  json.at("extent").get_to(frustum.extent);
}

} // namespace ggrade::check
