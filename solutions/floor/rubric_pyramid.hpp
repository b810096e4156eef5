#pragma once
// The pyramid of a bloom: its levels as found among the passes, and its filter in double precision.

#include "rubric/rubric.hpp"
#include "rubric_passes.hpp"

#include <optional>
#include <string>
#include <vector>

namespace floor_rubric {

using namespace ggrade::rubric;

/// One level: what was drawn at its size first (on the way down) and last (on the way up).
struct Level {
  int width = 0, height = 0;
  std::uint32_t format = 0;                 ///< internal, of what was drawn first; 0 if nothing was
  Image down, up;                           ///< RGB; empty if nothing was drawn at this size
  bool summed = false;                      ///< drawn more than once
  std::optional<rubric::PassOutput> output; ///< where `down` was drawn
};

struct Pyramid {
  Image scene; ///< RGB; empty if no pass draws objects into a texture that is sampled
  std::uint32_t sceneFormat = 0; ///< internal format
  std::optional<rubric::PassOutput> sceneOutput;
  std::vector<Level> levels; ///< largest first
};

/// The reference's pyramid: every texture smaller than the window that a full-screen pass drew.
Pyramid ownPyramid(const trace::Trace& trace);
/// A submission's, at the sizes of the reference's levels, to one pixel.
Pyramid pyramidLike(const Pyramid& reference, const trace::Trace& trace);

/// `image` at a smaller or larger size by the area-weighted tent, edges mirrored
/// (framework/shaders/pyramid.glsl), in double precision.
Image byTent(const Image& image, int width, int height);

/// How a picture of light compares with another, any size, after division by `gain`.
struct LightComparison {
  double wrongShare = 1;
  double ratio = 0;     ///< median of found / wanted where there is light
  bool uniform = false; ///< nearly the same ratio everywhere
  /// "2.1x too bright everywhere", "31% of the pixels differ, densest at (212,340)", "matches".
  std::string text;
};
LightComparison compareLight(const Image& found, const Image& wanted, double gain);

} // namespace floor_rubric
