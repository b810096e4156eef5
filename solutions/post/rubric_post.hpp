#pragma once
/// \file
/// What the three rubrics of post measure alike: how near a picture is to the reference, as a share
/// of what the effect changes.

#include "rubric/measures.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cmath>

namespace post_rubric {

using namespace ggrade;
using namespace ggrade::rubric;

/// Least difference that counts as the effect's, of 1.
inline constexpr float kLeastChange = 6.0f / 255;

/// What lies so near to what the effect changes is judged with it, the rest by itself, pixels.
inline constexpr int kNear = 2;

/// An effect, or a part of it: what the reference draws with it and without.
struct Effect {
  const SceneEvidence& scene;
  std::string probe = "plain"; ///< the scene without it, see scenes.json

  const Image& with(std::size_t frame) const { return scene.reference.at(frame); }
  const Image& without(std::size_t frame) const { return scene.probes.at(probe).at(frame); }
  /// Where it changes what is seen.
  Mask changed(std::size_t frame) const {
    return differenceMask(with(frame), without(frame), kLeastChange);
  }
};

/// How far a frame is from the reference where the effect shows: 0 is the same, 1 as far as the
/// scene without it.
double apart(const View& view, std::size_t frame, const Effect& effect);

/// The first frame, where the effect shows.
Verdict shows(const View& view, const Effect& effect, double free, double gone,
              const std::string& what);

/// A picture to look at (edges, velocities), pixel by pixel.
Verdict pictured(const View& view, const Mask& region, double free, double gone,
                 const std::string& what);

/// How much of what the effect leaves alone has changed.
Verdict leftAlone(const View& view, std::size_t frame, const Effect& effect);

} // namespace post_rubric
